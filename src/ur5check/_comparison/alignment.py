"""The transformation of one arm's joint coordinates and base frame to another's.

Two arms are comparable when their joint axes are the same lines in space.  Sought are a base
transform X = T_ab, a sign s_i and a zero offset o_i for each joint, with

    q_b = s ∘ q_a + o     and     X · T_b,i(q_b)  carrying the same axis lines as  T_a,i(q_a).

`alignment_paths` finds every way to do so; here one is chosen and measured.

What axes cannot determine is reported in `unknown`: the zero of joint 1 and a turn of the base
about axis 1 are one freedom (it is given to the base, unless only the joint's zero keeps gravity
the same); the last joint's zero shows in the tool frame alone.

Among alignments that fit equally well the one that changes least is taken: gravity kept, tool
frame the same, fewest joints reversed or shifted, smallest offsets.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from .._errors import UsageError
from .._robot.serial_arm import Joint, Limits, SerialArm, Source
from .._robot.transforms import Array, Transform
from .alignment_paths import (
    NEAR_ANGLE,
    NEAR_LENGTH,
    AlignmentPath,
    alignment_paths,
    as_written,
    met_at_the_tool,
)
from .joint_axes import across, joint_starts, signed_angle, smallest_rotation, tool_pose

__all__ = [
    "SAME_ANGLE",
    "SAME_LENGTH",
    "Alignment",
    "align",
    "align_as_written",
    "arm_in_coordinates_of",
]

#: Two axes are one line if they are closer than this.  No data sheet, table or URDF that people
#: write by hand carries more digits than the micrometre and the microradian.
SAME_LENGTH = 1e-6  # [m]
SAME_ANGLE = 1e-6  # [rad]

# An arm of intersecting right-angled axes has 2ⁿ solutions; the first ones found change least.
_MOST_SOLUTIONS = 256


@dataclass(frozen=True, eq=False)
class Alignment:
    """Arm b in arm a's joint coordinates and base frame.

    Attributes
    ----------
    T_ab : Transform
        Arm b's base frame in arm a's.
    signs, offsets : ndarray, shape (n,)
        q_b = signs ∘ q_a + offsets [rad]; [m] for a prismatic joint.
    exact : bool
        Whether all axes became the same lines (within SAME_ANGLE, SAME_LENGTH).
    axis_angle, axis_distance : ndarray, shape (n,)
        Between corresponding axes at q_a = 0 [rad], [m]; a prismatic joint's axis has a direction
        only.
    tool : Transform
        Pose of b's tool in a's tool frame at q_a = 0.
    unknown : tuple of str
        What the axes could not determine, in sentences.
    notes : tuple of str
        A near miss, in a sentence.
    """

    T_ab: Transform
    signs: Array
    offsets: Array
    exact: bool
    axis_angle: Array
    axis_distance: Array
    tool: Transform
    unknown: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def align(a: SerialArm, b: SerialArm) -> Alignment:
    """The alignment of b with a that changes least.

    When no alignment makes the axes the same lines, joint coordinates are taken as they stand
    (signs +1, offsets 0), only the base is turned to fit, and `exact` is False: then the two arms
    differ in geometry, and the residuals show where.

    Raises UsageError if the arms have different numbers or kinds of joints.
    """
    _refuse_incomparable(a, b)
    exact = _best(a, b, SAME_ANGLE, SAME_LENGTH)
    if exact is not None:
        return exact
    written = align_as_written(a, b)
    near = _best(a, b, NEAR_ANGLE, NEAR_LENGTH)
    if near is None or _changes(near) == 0:
        return written
    return replace(written, notes=(_near_miss(near, a),))


def align_as_written(a: SerialArm, b: SerialArm) -> Alignment:
    """Arm b aligned with its joint angles as they stand; `exact` if the axes coincide."""
    _refuse_incomparable(a, b)
    written = _finish(a, b, next(as_written(a, b)), exact=False)
    fits = written.axis_angle.max() <= SAME_ANGLE and written.axis_distance.max() <= SAME_LENGTH
    return replace(written, exact=bool(fits))


def arm_in_coordinates_of(a: SerialArm, b: SerialArm, alignment: Alignment) -> SerialArm:
    """Arm b with a's joint coordinates and base frame; its link frames stay its own.

    J_i(s q + o) = J_i(o) · J_i(s q): offsets go into the fixed transforms, signs into the axes.
    """
    joints, links = [], []
    for i, (joint, link) in enumerate(zip(b.joints, b.links, strict=True)):
        sign, offset = float(alignment.signs[i]), float(alignment.offsets[i])
        joints.append(
            Joint(
                a.joints[i].name,
                joint.axis * sign,
                joint.kind,
                _limits(joint.limits, sign, offset),
                joint.armature,
                joint.damping,
                joint.friction,
            )
        )
        links.append(replace(link, link_tip_frame=joint.motion(offset) @ link.link_tip_frame))
    return SerialArm(
        b.name,
        tuple(joints),
        tuple(links),
        base=alignment.T_ab @ b.base,
        gravity=alignment.T_ab.R @ b.gravity,
        source=Source(inputs=b.source.inputs, base=b.source.base, tip=b.source.tip),
        given_label=b.given_label,
    )


def _limits(limits: Limits, sign: float, offset: float) -> Limits:
    ends = [None if end is None else sign * (end - offset) for end in (limits.lower, limits.upper)]
    lower, upper = ends if sign > 0 else ends[::-1]
    return replace(limits, lower=lower, upper=upper)


def _refuse_incomparable(a: SerialArm, b: SerialArm) -> None:
    if a.n != b.n:
        raise UsageError(
            f"{a.label!r} has {a.n} joints and {b.label!r} has {b.n}; "
            "choose base and tip so that both chains have the same joints"
        )
    for i, (ja, jb) in enumerate(zip(a.joints, b.joints, strict=True), 1):
        if ja.kind != jb.kind:
            raise UsageError(
                f"joint {i} is {ja.kind} in {a.label!r} ({ja.name}) but {jb.kind} in {b.label!r} "
                f"({jb.name}); arms with different kinds of joints cannot be compared"
            )


def _best(a: SerialArm, b: SerialArm, angle: float, length: float) -> Alignment | None:
    """The fitting alignment that changes least, if there is one."""
    fitting = islice(alignment_paths(a, b, angle, length), _MOST_SOLUTIONS)
    found = [_finish(a, b, path, exact=True) for path in fitting]
    found += [_turned_at_joint_1(a, b, alignment) for alignment in found]
    return min(found, key=lambda alignment: _cost(a, b, alignment), default=None)


def _finish(a: SerialArm, b: SerialArm, path: AlignmentPath, *, exact: bool) -> Alignment:
    """What only the tool shows, then everything measured on the arms themselves."""
    unknown = path.unknown
    angle = 0.0
    if exact:
        path, angle, undetermined = met_at_the_tool(a, b, path)
        unknown += undetermined
    offsets = np.array([*path.offsets, angle]) + path.slid[3:]
    T = b.base
    for joint, link, offset in zip(b.joints[:-1], b.links[:-1], offsets[:-1], strict=True):
        T = T @ joint.motion(offset) @ link.link_tip_frame
    X = path.here @ T.inverse()
    return _measured(a, b, X, np.array(path.signs), _wrapped(b, offsets), exact, unknown)


def _measured(
    a: SerialArm,
    b: SerialArm,
    X: Transform,
    signs: Array,
    offsets: Array,
    exact: bool,
    unknown: tuple[str, ...],
) -> Alignment:
    draft = Alignment(
        X, signs, offsets, exact, np.zeros(a.n), np.zeros(a.n), Transform.identity(), unknown
    )
    moved = arm_in_coordinates_of(a, b, draft)
    angles, distances = [], []
    for ja, jb, start_a, start_b in zip(
        a.joints, moved.joints, joint_starts(a), joint_starts(moved), strict=True
    ):
        t, u = start_a.R @ ja.axis, start_b.R @ jb.axis
        angles.append(np.arctan2(np.linalg.norm(np.cross(u, t)), u @ t))
        apart = across(start_b.p - start_a.p, t)
        distances.append(0.0 if ja.kind == "prismatic" else np.linalg.norm(apart))
    return replace(
        draft,
        axis_angle=np.array(angles),
        axis_distance=np.array(distances),
        tool=tool_pose(a).inverse() @ tool_pose(moved),
    )


def _turned_at_joint_1(a: SerialArm, b: SerialArm, found: Alignment) -> Alignment:
    """The same alignment with the turn about axis 1 given to joint 1 instead of the base."""
    if b.joints[0].kind == "prismatic" or b.n == 1:
        return found
    axis = found.T_ab.R @ b.base.R @ b.joints[0].axis
    # The turn of X about the axis; what is left of X tilts the axis and must stay.
    tilt = smallest_rotation(b.base.R @ b.joints[0].axis, axis)
    rotation = Transform(found.T_ab.R @ tilt.R.T, np.zeros(3))
    angle = signed_angle(rotation.R, axis)
    offsets = found.offsets.copy()
    offsets[0] = angle
    undo = b.base @ b.joints[0].motion(-angle) @ b.base.inverse()
    return _measured(
        a, b, found.T_ab @ undo, found.signs, _wrapped(b, offsets), found.exact, found.unknown
    )


def _cost(a: SerialArm, b: SerialArm, alignment: Alignment) -> tuple[float, ...]:
    """How much an alignment changes, the gravest change first."""
    down_a, down_b = a.gravity, alignment.T_ab.R @ b.gravity
    tilted = np.linalg.norm(np.cross(down_a, down_b)) > 1e-6 * np.linalg.norm(down_a) * (
        np.linalg.norm(down_b)
    ) or bool(down_a @ down_b < 0)
    return (
        float(tilted),
        float(len(alignment.unknown)),
        float(alignment.tool.angle() > NEAR_ANGLE),
        float(_changes(alignment) + (alignment.T_ab.angle() > NEAR_ANGLE)),
        float((alignment.signs < 0).sum()),
        round(float(np.abs(alignment.offsets).sum()), 9),
        round(alignment.T_ab.angle(), 9),
    )


def _changes(alignment: Alignment) -> int:
    """How many joints an alignment reverses or shifts."""
    return int(((alignment.signs < 0) | (np.abs(alignment.offsets) > NEAR_ANGLE)).sum())


def _near_miss(near: Alignment, a: SerialArm) -> str:
    parts = []
    for joint, sign, offset in zip(a.joints, near.signs, near.offsets, strict=True):
        if sign < 0:
            parts.append(f"{joint.name} reversed")
        if abs(offset) > NEAR_ANGLE:
            parts.append(f"{joint.name} shifted by {np.degrees(offset):+.4g}°")
    worst_angle, worst_length = near.axis_angle.max(), near.axis_distance.max()
    return (
        f"with {', '.join(parts)} all axes would coincide to {worst_angle:.1e} rad and "
        f"{1e3 * worst_length:.2g} mm; joint angles are compared as they are written"
    )


def _wrapped(b: SerialArm, offsets: Array) -> Array:
    """Angles in (−π, π], taken as the quarter turns that they all but are; slides untouched.

    A joint's zero that is off by less than SAME_ANGLE is a rounded angle in a file.  It stays with
    the geometry, where the error budget of rounding looks for it, and is no offset.
    """
    values = []
    for joint, offset in zip(b.joints, offsets, strict=True):
        value = float(offset)
        if joint.kind == "revolute":
            value = float(np.pi - (np.pi - value) % (2.0 * np.pi))
            quarters = round(value / (np.pi / 2))
            if abs(value - quarters * (np.pi / 2)) < SAME_ANGLE:
                value = (quarters if quarters != -2 else 2) * (np.pi / 2)
        values.append(value)
    return np.array(values)
