"""Standard DH frames for any chain of joints (Denavit & Hartenberg 1955).

Frame i of an arm may be moved: turned about the axis of joint i+1 and slid along it, so that

    T = B · J1(q1) · P1 · …  =  (B C0) · Rot_z(q1) (C0⁻¹ P1 C1) · Rot_z(q2) (C1⁻¹ P2 C2) · …

with C_i's z axis along that joint's axis.  Each bracket must be Rot_z Trans_z Trans_x Rot_x, which
it is when x_i lies along the common normal of the two axes.  So seen from frame i−1, with w the
next axis and p a point on it:

- skew or intersecting axes: x_i = ± z × w, and the origin is the normal's foot on w;
- parallel axes: any normal will do; the one through the origin of frame i−1 makes d = 0;
- the same axis twice: x_i stays as it is, and only α may turn z over.

Of the two directions of x_i the one with the smaller offset is taken.  Frames that are DH frames
already are kept.  The last frame has the tip's z axis for its next axis.  The rest,
B C0 before the first row and C_n⁻¹ after the last, are the table's `base` and `tool`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NoReturn

import numpy as np

from ..._errors import UsageError
from ..._robot.serial_arm import Link, SerialArm
from ..._robot.transforms import Array, Transform
from ..round_trip import on_grid

__all__ = ["ROUNDING", "DHFrames", "dh_frames"]

#: Rounding of directions and lengths after a few rotations; smaller values are zero.
ROUNDING = 64 * float(np.finfo(np.float64).eps)

# Axes that are parallel but for a rounded angle meet somewhere; a table whose frames are further
# away than any arm's is no table of that arm (and the reader takes such lengths for millimetres).
_FARTHEST = 20.0  # [m]

_Z = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class DHFrames:
    """base : of frame 0 in the base frame;  tool : of the tip in frame n
    links : the arm's, each with its P_i and inertia between DH frames
    """

    base: Transform
    links: tuple[Link, ...]
    tool: Transform


def dh_frames(arm: SerialArm) -> DHFrames:
    """The arm in standard DH frames.

    Raises UsageError where two axes are so nearly parallel that their common normal lies 20 m away.
    """
    before = first = _frame_zero(arm)
    kept = _are_dh(arm)
    links = []
    axes = [*(joint.axis for joint in arm.joints[1:]), _Z]
    for i, (link, axis) in enumerate(zip(arm.links, axes, strict=True)):
        last = i + 1 == arm.n
        seen = before.inverse() @ link.link_tip_frame
        stays = (kept or last) and np.array_equal(axis, _Z) and _is_dh(seen)
        after = Transform.identity() if stays else _next_frame(seen, axis)
        if last and np.abs((seen @ after).p).max() > _FARTHEST:
            after = seen.inverse()  # the tip's z axis need not be met: the tool takes the rest
        link_tip_frame = seen @ after
        if np.abs(link_tip_frame.p).max() > _FARTHEST:
            _refuse(arm, i, float(np.abs(link_tip_frame.p).max()))
        inertia = link.inertia
        if not np.array_equal(after.matrix(), np.eye(4)):
            inertia = on_grid(inertia.expressed_in(after.inverse()), after)
        links.append(replace(link, link_tip_frame=link_tip_frame, inertia=inertia))
        before = after
    return DHFrames(_tidy(arm.base @ first), tuple(links), _tidy(before.inverse()))


def _is_dh(T: Transform) -> bool:
    """Whether T = Rot_z Trans_z Trans_x Rot_x: x meets z at a right angle."""
    astray = T.p - T.p[2] * _Z - (T.R[:, 0] @ T.p) * T.R[:, 0]
    return bool(
        abs(T.R[2, 0]) <= ROUNDING
        and np.abs(astray).max() <= ROUNDING * max(1.0, float(np.abs(T.p).max()))
    )


def _refuse(arm: SerialArm, i: int, distance: float) -> NoReturn:
    raise UsageError(
        f"{arm.name!r} has no DH table: the axes of joints {arm.joints[i].name!r} and "
        f"{arm.joints[i + 1].name!r} are all but parallel, and their common normal lies "
        f"{distance:.3g} m away; if parallel is meant, write the angle with all its digits, else "
        "convert to URDF"
    )


def _are_dh(arm: SerialArm) -> bool:
    """Whether all frames but the tip's are DH frames already."""
    return all(np.array_equal(joint.axis, _Z) for joint in arm.joints) and all(
        _is_dh(link.link_tip_frame) for link in arm.links[:-1]
    )


def _frame_zero(arm: SerialArm) -> Transform:
    """C0: where B only turns about z and slides along it, frame 0 is the base frame itself."""
    axis, to_base = arm.joints[0].axis, arm.base.inverse()
    on_axis = np.abs(np.cross(axis, to_base.p)).max() <= ROUNDING * max(
        1.0, np.abs(to_base.p).max()
    )
    if np.array_equal(axis, _Z) and np.abs(to_base.R[:, 2] - _Z).max() <= ROUNDING and on_axis:
        return to_base
    return Transform(_turn_z_to(axis), np.zeros(3))


def _next_frame(seen: Transform, axis: Array) -> Transform:
    """C_i, from the pose of the arm's frame i in DH frame i−1 and the axis that starts there."""
    w, p = seen.R @ axis, seen.p
    normal = np.cross(_Z, w)
    if np.abs(normal).max() > ROUNDING:
        x = normal / np.linalg.norm(normal)
        # The foot on w of the common normal of w and the z axis through the origin.
        slide = float(np.cross(_Z, p) @ normal) / float(normal @ normal)
        slide = -slide if slide else 0.0
    else:
        w = np.copysign(1.0, w[2]) * _Z
        across = np.array([p[0], p[1], 0.0])
        reach = float(np.linalg.norm(across))
        # The same line twice: any x will do, so the one that makes the offset zero.
        apart = reach > ROUNDING * max(1.0, abs(float(p[2])))
        x = across / reach if apart else np.array([1.0, 0.0, 0.0])
        slide = -float(p[2] * w[2])
    if x[0] < -ROUNDING or (abs(x[0]) <= ROUNDING and x[1] < 0.0):
        x = -x
    x = np.where(np.abs(x) <= ROUNDING, 0.0, x)
    R = np.column_stack([x, np.cross(w, x), w])
    return seen.inverse() @ Transform(R, p + slide * w)


def _turn_z_to(axis: Array) -> Array:
    """The smallest rotation that takes z to `axis`; about x where any would do."""
    about = np.cross(_Z, axis)
    sine = float(np.linalg.norm(about))
    if sine == 0.0:
        return np.eye(3) if axis[2] > 0.0 else np.diag([1.0, -1.0, -1.0])
    return Transform.rotation(about / sine, float(np.arctan2(sine, axis[2]))).R


def _tidy(T: Transform) -> Transform:
    """The identity, where T is that to rounding."""
    scale = max(1.0, float(np.abs(T.p).max()))
    nothing = np.abs(T.matrix() - np.eye(4)).max() <= ROUNDING * scale
    return Transform.identity() if nothing else T
