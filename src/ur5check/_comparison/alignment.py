"""The transformation of one arm's joint coordinates and base frame to another's.

Two arms are comparable when their joint axes are the same lines in space.  Sought are a base
transform X = T_ab, a sign s_i and a zero offset o_i for each joint, with

    q_b = s ∘ q_a + o     and     X · T_b,i(q_b)  carrying the same axis lines as  T_a,i(q_a).

`alignment_paths` finds every way to do so, and `alignment_choice` the one with the smallest torque
difference.  Angles that are π/2 or the like but for their digits are taken as what they stand for.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from .._errors import UsageError
from .._robot.serial_arm import Joint, Limits, SerialArm, Source
from .._robot.transforms import Array, Transform
from .alignment_choice import (
    FAR_BETTER,
    AxisFit,
    OpenZero,
    TorqueDifference,
    gravity_kept,
)
from .alignment_paths import (
    NEAR_ANGLE,
    NEAR_LENGTH,
    AlignmentPath,
    Undetermined,
    alignment_paths,
    as_written,
    met_at_the_tool,
)
from .joint_axes import SAME_ANGLE, SAME_LENGTH, across, joint_starts, tool_pose
from .rounded_constants.rounded_angles import with_angles_written_out

__all__ = [
    "SAME_ANGLE",
    "SAME_LENGTH",
    "Alignment",
    "align",
    "align_as_written",
    "arm_in_coordinates_of",
    "numbers_as_written",
    "same_recipe",
]

# An arm whose axes all meet at right angles has 2ⁿ solutions; the first ones found change least.
_MOST_SOLUTIONS = 512

_SAME_TORQUE = 1e-9  # relative: rounding


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
        Whether all axes became the same lines (within SAME_ANGLE, SAME_LENGTH), rounded angles such
        as 1.5708 taken as the exact ones.
    axis_angle, axis_distance : ndarray, shape (n,)
        Between corresponding axes at q_a = 0, as the numbers are written [rad], [m]; a prismatic
        joint's axis has a direction only.
    tool : Transform
        Pose of b's tool in a's tool frame at q_a = 0.
    unknown : tuple of Undetermined
        Joints whose zero neither axes nor tool nor torques determine.
    relative_difference : float
        RMS of Δτ over a hundred random states and all joints, each joint's as a share of its RMS
        torque; nan where the axes do not coincide.
    torque_difference : float
        The largest |Δτ| at these states [N m] or [N]; nan likewise.
    others : tuple of Alignment
        The other alignments that make the axes coincide, by `relative_difference`.
    nearest : Alignment or None
        Where the axes do not coincide: the alignment that nearly makes them.
    """

    T_ab: Transform
    signs: Array
    offsets: Array
    exact: bool
    axis_angle: Array
    axis_distance: Array
    tool: Transform
    unknown: tuple[Undetermined, ...] = ()
    relative_difference: float = float("nan")
    torque_difference: float = float("nan")
    others: tuple[Alignment, ...] = ()
    nearest: Alignment | None = None


def align(a: SerialArm, b: SerialArm) -> Alignment:
    """The alignment of b with a that has the smallest torque difference.

    One that changes less is preferred unless it leaves twice as much, in the links that the two
    place differently: gravity kept, tool frame the same, fewest joints reversed or shifted,
    smallest offsets.

    When no alignment makes the axes the same lines, joint coordinates are taken as they stand
    (signs +1, offsets 0), only the base is turned to fit, and `exact` is False: then the two arms
    differ in geometry, and the residuals show where.  So they are if both sources follow one rule
    and their inertias agree far better number by number than under any alignment: then a length or
    angle is wrong, and a reversed or shifted joint would hide it.

    Raises UsageError if the arms have different numbers or kinds of joints.
    """
    _refuse_incomparable(a, b)
    exact_a, exact_b = with_angles_written_out(a), with_angles_written_out(b)
    fits = _fits(exact_a, exact_b, SAME_ANGLE, SAME_LENGTH)
    if not fits:
        return _not_aligned(a, b, exact_a, exact_b)
    torques = TorqueDifference(exact_a, exact_b)
    best, *others = _ranked(a, b, [torques.with_open_zeros_found(fit) for fit in fits], torques)
    written = align_as_written(a, b)
    if not written.exact and same_recipe(a, arm_in_coordinates_of(a, b, written)):
        maps = numbers_as_written(exact_a, exact_b)
        bodies = [
            link.inertia.expressed_in(T).parameters()
            for link, T in zip(exact_b.links, maps, strict=True)
        ]
        by_number = torques.of_numbers(np.concatenate(bodies))
        if by_number < FAR_BETTER * best.relative_difference - _SAME_TORQUE:
            return replace(written, others=(best, *others))
    return replace(best, others=tuple(others))


def align_as_written(a: SerialArm, b: SerialArm) -> Alignment:
    """Arm b aligned with its joint angles as they stand; `exact` if the axes coincide."""
    _refuse_incomparable(a, b)
    exact_a, exact_b = with_angles_written_out(a), with_angles_written_out(b)
    path = next(as_written(exact_a, exact_b))
    fit = _fit(exact_b, path, 0.0)
    clean = _measured(exact_a, exact_b, fit)
    fits = clean.axis_angle.max() <= SAME_ANGLE and clean.axis_distance.max() <= SAME_LENGTH
    if not fits:
        return replace(_measured(a, b, fit), exact=False)
    # The turn of the base about axis 1 must not be taken from the joint.
    return _measured(a, b, fit, TorqueDifference(exact_a, exact_b))


def numbers_as_written(a: SerialArm, b: SerialArm) -> tuple[Transform, ...]:
    """For each link, the transform from b's link frame to a's that has both source frames coincide.

    Source frames placed by the same rule are taken as the same, wherever they stand in space: a
    wrong length then counts as geometry, and not as a wrong centre of mass too.
    """
    return tuple(
        la.source_frame @ lb.source_frame.inverse() for la, lb in zip(a.links, b.links, strict=True)
    )


def same_recipe(a: SerialArm, b: SerialArm) -> bool:
    """Whether two sources put their link frames by the same rule, as far as their numbers show.

    Each link's numbers are held at the same end of it, and each joint turns about the same axis of
    its own frame: two DH tables do so, and two URDFs that descend from one.
    """
    return all(
        la.held_near == lb.held_near and np.abs(ja.axis - jb.axis).max() < SAME_ANGLE
        for la, lb, ja, jb in zip(a.links, b.links, a.joints, b.joints, strict=True)
    )


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


def _fits(a: SerialArm, b: SerialArm, angle: float, length: float) -> list[AxisFit]:
    """Every alignment that has all axes within the tolerances, gravity kept where that can be."""
    found = []
    for path in islice(alignment_paths(a, b, angle, length), _MOST_SOLUTIONS):
        met, zero = met_at_the_tool(a, b, path)
        fit = replace(_fit(b, met, zero), open_zeros=tuple(_open_zeros(b, met)))
        found.append(gravity_kept(a, b, fit))
    return found


def _fit(b: SerialArm, path: AlignmentPath, last_zero: float) -> AxisFit:
    """A path that has reached the last joint, as base transform, signs and offsets."""
    offsets = np.array([*path.offsets, last_zero]) + path.slid[3:]
    T = b.base
    for joint, link, offset in zip(b.joints[:-1], b.links[:-1], offsets[:-1], strict=True):
        T = T @ joint.motion(offset) @ link.link_tip_frame
    X = path.here @ T.inverse()
    return AxisFit(X, np.array(path.signs), _wrapped(b, offsets), path.unknown)


def _open_zeros(b: SerialArm, path: AlignmentPath) -> Iterator[OpenZero]:
    """Zeros that the axes leave open; a common tool may have closed them."""
    n, last = b.n, b.n - 1
    for each in path.unknown:
        if each.reason == "same line":
            i = each.joint - 1
            ahead = b.links[i].link_tip_frame.R @ b.joints[i + 1].axis
            offsets = np.zeros(n)
            offsets[i], offsets[i + 1] = 1.0, -float(np.sign(ahead @ b.joints[i].axis))
            yield OpenZero(i, offsets, np.zeros(3), sliding=False)
    for meaning in path.free_translation.meanings.T:
        slides = np.abs(meaning[3:])
        if slides.max() > 1e-9:
            yield OpenZero(int(slides.argmax()), meaning[3:], meaning[:3], sliding=True)
    if n > 1:
        offsets = np.zeros(n)
        offsets[last] = 1.0
        yield OpenZero(last, offsets, np.zeros(3), sliding=b.joints[last].kind == "prismatic")


def _measured(
    a: SerialArm, b: SerialArm, fit: AxisFit, torques: TorqueDifference | None = None
) -> Alignment:
    """An alignment measured on the arms as they are written.

    torques : of the arms with angles written out, where these axes coincide
    """
    offsets = _wrapped(b, fit.offsets)
    nothing = np.zeros(a.n)
    draft = Alignment(
        fit.T_ab, fit.signs, offsets, torques is not None, nothing, nothing,
        Transform.identity(), fit.unknown,
    )  # fmt: skip
    moved = arm_in_coordinates_of(a, b, draft)
    angles, distances = [], []
    for ja, jb, start_a, start_b in zip(
        a.joints, moved.joints, joint_starts(a), joint_starts(moved), strict=True
    ):
        t, u = start_a.R @ ja.axis, start_b.R @ jb.axis
        angles.append(np.arctan2(np.linalg.norm(np.cross(u, t)), u @ t))
        apart = across(start_b.p - start_a.p, t)
        distances.append(0.0 if ja.kind == "prismatic" else np.linalg.norm(apart))
    measured = replace(
        draft,
        axis_angle=np.array(angles),
        axis_distance=np.array(distances),
        tool=tool_pose(a).inverse() @ tool_pose(moved),
    )
    if torques is None:
        return measured
    delta = torques.torque(replace(fit, offsets=offsets))
    return replace(
        measured,
        relative_difference=torques.relative(delta),
        torque_difference=float(np.abs(delta).max()),
    )


def _ranked(
    a: SerialArm, b: SerialArm, fits: list[AxisFit], torques: TorqueDifference
) -> list[Alignment]:
    """Alignments by torque difference, but first that which changes least among those that the
    best is not far better than."""
    found = [(_measured(a, b, fit, torques), fit) for fit in fits]
    found.sort(key=lambda each: each[0].relative_difference)
    least = found[0][1]
    tied = [
        alignment for alignment, fit in found if fit is least or not torques.far_better(least, fit)
    ]
    chosen = min(tied, key=lambda each: _cost(a, b, each))
    return [chosen, *(alignment for alignment, _ in found if alignment is not chosen)]


def _cost(a: SerialArm, b: SerialArm, alignment: Alignment) -> tuple[float, ...]:
    """How much an alignment changes, the gravest change first."""
    down_a, down_b = a.gravity, alignment.T_ab.R @ b.gravity
    tilted = np.abs(down_a - down_b).max() > 1e-6 * np.linalg.norm(down_a)
    met = alignment.tool.angle() <= NEAR_ANGLE and np.abs(alignment.tool.p).max() <= NEAR_LENGTH
    return (
        float(tilted),
        float(not met),
        float(_changes(alignment) + (alignment.T_ab.angle() > NEAR_ANGLE)),
        float((alignment.signs < 0).sum()),
        round(float(np.abs(alignment.offsets).sum()), 9),
        round(alignment.T_ab.angle(), 9),
    )


def _changes(alignment: Alignment) -> int:
    """How many joints an alignment reverses or shifts."""
    return int(((alignment.signs < 0) | (np.abs(alignment.offsets) > NEAR_ANGLE)).sum())


def _not_aligned(a: SerialArm, b: SerialArm, exact_a: SerialArm, exact_b: SerialArm) -> Alignment:
    """Joint angles as they stand, and the alignment that all but makes the axes coincide."""
    written = align_as_written(a, b)
    near = [_measured(a, b, fit) for fit in _fits(exact_a, exact_b, NEAR_ANGLE, NEAR_LENGTH)]
    nearest = min(near, key=lambda each: _cost(a, b, each), default=None)
    if nearest is None or _changes(nearest) == 0:
        return written
    return replace(written, nearest=nearest)


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
