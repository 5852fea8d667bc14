"""Laying one arm along another, axis by axis: every way in which the axes become the same lines.

With the axes 1 … i of arm b in place, joint i can still turn, and the angle that brings axis i + 1
onto its counterpart is that joint's zero offset.  Where two consecutive axes meet at right angles,
axis i + 1 fits either way round, and both ways are followed.  Directions in which everything found
so far may still slide (along parallel axes, or along a sliding joint) are kept as `FreeTranslation`
until a later axis takes them up.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array, Transform
from .joint_axes import (
    across,
    angle_about,
    joint_starts,
    signed_angle,
    smallest_rotation,
    tool_angle,
    tool_pose,
)

__all__ = ["NEAR_ANGLE", "NEAR_LENGTH", "AlignmentPath", "as_written", "met_at_the_tool", "walks"]

#: Below this two axes may be one and the same, or parallel: no zero is read off so small a lever.
#: Also what counts as *nearly* one line: a rounding such as 1.5707 for π/2 (1e-4 rad), or a length
#: rounded to the millimetre.
NEAR_LENGTH = 1e-3  # [m]
NEAR_ANGLE = 1e-3  # [rad]

_NOTHING = 1e-9  # [m] or [rad]: rounding of a product of transforms


@dataclass(frozen=True, eq=False)
class FreeTranslation:
    """Translations that would leave every axis found so far where it is.

    directions : (3, k), in a's base frame
    owners : (3 + n, k), what one unit of each direction means: a shift of the base, an offset of a
        sliding joint
    """

    directions: Array
    owners: Array

    def taken_up(
        self, gap: Array, along: Array | None = None
    ) -> tuple[FreeTranslation, Array, Array]:
        """Close `gap` as far as sliding can; a gap along the axis `along` is none.

        Returns the slack that is left, the translation made, and what it means (3 + n,).
        """
        seen_part = np.eye(3) if along is None else np.eye(3) - np.outer(along, along)
        seen = seen_part @ self.directions
        u, sizes, vt = np.linalg.svd(seen, full_matrices=True)
        rank = int((sizes > 1e-9).sum())  # directions are unit vectors: parallel means rounding
        y = vt[:rank].T @ ((u[:, :rank].T @ (seen_part @ gap)) / sizes[:rank])
        rest = vt[rank:].T
        left = FreeTranslation(self.directions @ rest, self.owners @ rest)
        return left, self.directions @ y, self.owners @ y

    def with_slide(self, direction: Array, joint: int) -> FreeTranslation:
        """This slack, and a sliding joint's own."""
        owner = np.zeros(len(self.owners))
        owner[3 + joint] = 1.0
        return FreeTranslation(
            np.column_stack([self.directions, direction]), np.column_stack([self.owners, owner])
        )


@dataclass(frozen=True, eq=False)
class AlignmentPath:
    """Arm b laid along arm a as far as joint i.

    here : the frame that joint i of b starts from, in a's base frame
    """

    here: Transform
    signs: tuple[float, ...]
    offsets: tuple[float, ...]
    free_translation: FreeTranslation
    slid: Array  # (3 + n,): what has been taken up, by owner
    unknown: tuple[str, ...]


def walks(a: SerialArm, b: SerialArm, angle: float, length: float) -> Iterator[AlignmentPath]:
    """Every way to lay b along a with all axes within the tolerances."""
    targets = joint_starts(a)

    def onward(walk: AlignmentPath, i: int) -> Iterator[AlignmentPath]:
        """`walk` has the axes up to i in place; joint i's zero is still open."""
        if i + 1 == b.n:
            yield walk
            return
        for turned in _turns(a, b, walk, i, targets):
            placed = _place(a, b, turned, i + 1, targets)
            off_angle, off_length = _gap(a, b, placed, i + 1, targets)
            if off_angle <= angle and off_length <= length:
                yield from onward(placed, i + 1)

    for sign in (1.0, -1.0):
        yield from onward(_start(a, b, sign, targets), 0)


def as_written(a: SerialArm, b: SerialArm) -> Iterator[AlignmentPath]:
    """Arm b laid on a as its joint coordinates stand: only the base is fitted, to axes 1 and 2."""
    targets = joint_starts(a)
    walk = _start(a, b, 1.0, targets)
    if b.n > 1:
        walk = next(_turns(a, b, walk, 0, targets))
        walk = replace(walk, signs=(1.0, 1.0))
        for i in range(1, b.n):
            if i > 1:
                here = walk.here @ b.links[i - 1].link_tip_frame
                walk = replace(
                    walk, here=here, signs=(*walk.signs, 1.0), offsets=(*walk.offsets, 0.0)
                )
            walk = _place(a, b, walk, i, targets)
    yield walk


def _start(a: SerialArm, b: SerialArm, sign: float, targets: list[Transform]) -> AlignmentPath:
    """Axis 1 of b on axis 1 of a, by the smallest turn; the base may still turn and slide."""
    axis = sign * (targets[0].R @ a.joints[0].axis)
    rotation = smallest_rotation(b.base.R @ b.joints[0].axis, axis)
    # Slide along the axis is open; start with both base origins at the same height along it.
    origin = targets[0].p - rotation.R @ b.base.p
    X = Transform(rotation.R, origin - axis * (axis @ origin))
    owners = np.zeros((3 + b.n, 1))
    directions = axis[:, None]
    if b.joints[0].kind == "prismatic":  # no line at all, only a direction
        directions, owners = np.eye(3), np.zeros((3 + b.n, 3))
        X = rotation
    owners[:3] = directions
    return AlignmentPath(
        X @ b.base, (sign,), (), FreeTranslation(directions, owners), np.zeros(3 + b.n), ()
    )


def _turns(
    a: SerialArm, b: SerialArm, walk: AlignmentPath, i: int, targets: list[Transform]
) -> Iterator[AlignmentPath]:
    """Joint i of b turned so that what follows points as in a; the walk moves on to joint i + 1."""
    joint = b.joints[i]
    if joint.kind == "prismatic" and i > 0:
        direction = walk.here.R @ joint.axis
        free_translation = walk.free_translation.with_slide(direction, i)
        yield _arrived(a, b, replace(walk, free_translation=free_translation), i, 0.0, targets)
        return
    angles, certain = _zeros(a, b, walk, i, targets)
    for angle in angles:
        yield _arrived(a, b, walk, i, angle, targets)
    if not certain:
        sentence = (
            f"the zero of joint {i + 1} ({a.joints[i].name}): it turns about the axis of the next, "
            "only their sum shows"
        )
        unsure = replace(walk, unknown=(*walk.unknown, sentence))
        yield _arrived(a, b, unsure, i, 0.0, targets)


def _zeros(
    a: SerialArm, b: SerialArm, walk: AlignmentPath, i: int, targets: list[Transform]
) -> tuple[list[float], bool]:
    """Angles of joint i that may bring what follows into place, and whether one of them must.

    A following axis that points elsewhere shows the angle, either way round; one that is parallel
    shows it by where it stands.  A lever of less than a milliradian or a millimetre shows it badly
    and may be a rounded digit: such angles are offered, and the axes that follow decide.
    """
    axis, back, ahead = b.joints[i].axis, walk.here.inverse(), Transform.identity()
    angles: list[float] = []
    for k in range(i + 1, b.n):
        ahead = ahead @ b.links[k - 1].link_tip_frame
        standing = b.joints[i].kind == b.joints[k].kind == "revolute"
        r, s = across(ahead.p, axis), across(back.R @ targets[k].p + back.p, axis)
        lever = _shorter(r, s) if standing else 0.0
        if lever > 0.0:
            by_place = [angle_about(axis, r, s)]
        d = across(ahead.R @ b.joints[k].axis, axis)
        t = across(back.R @ (targets[k].R @ a.joints[k].axis), axis)
        slant = _shorter(d, t)
        by_direction = [angle_about(axis, d, sign * t) for sign in (1.0, -1.0)]
        if slant > NEAR_ANGLE:
            return [*angles, *by_direction], True
        if lever > NEAR_LENGTH:
            return [*angles, *by_place, *(by_direction if slant > _NOTHING else [])], True
        angles += by_place if lever > _NOTHING else []
        angles += by_direction if slant > _NOTHING else []
        if b.joints[k].kind == "revolute":
            break  # a parallel slide stands nowhere in particular: look further along; else stop
    return angles, False


def _shorter(u: Array, v: Array) -> float:
    return min(float(np.linalg.norm(u)), float(np.linalg.norm(v)))


def _arrived(
    a: SerialArm, b: SerialArm, walk: AlignmentPath, i: int, angle: float, targets: list[Transform]
) -> AlignmentPath:
    """The walk at joint i + 1, with the sign that its axis turned out to have.

    What joint 1 had to turn, the base turns instead: the axis is the same.
    """
    moved = Transform.rotation(b.joints[i].axis, angle)
    here = walk.here @ moved @ b.links[i].link_tip_frame
    along = (here.R @ b.joints[i + 1].axis) @ (targets[i + 1].R @ a.joints[i + 1].axis)
    sign = 1.0 if along >= 0.0 else -1.0
    return replace(
        walk,
        here=here,
        signs=(*walk.signs, sign),
        offsets=(*walk.offsets, angle if i > 0 else 0.0),
    )


def _place(
    a: SerialArm, b: SerialArm, walk: AlignmentPath, i: int, targets: list[Transform]
) -> AlignmentPath:
    """Let the slack carry axis i onto its counterpart as far as it can."""
    if b.joints[i].kind == "prismatic":
        return walk
    along = targets[i].R @ a.joints[i].axis
    free_translation, shift, meaning = walk.free_translation.taken_up(
        targets[i].p - walk.here.p, along
    )
    here = Transform(walk.here.R, walk.here.p + shift)
    return replace(walk, here=here, free_translation=free_translation, slid=walk.slid + meaning)


def _gap(
    a: SerialArm, b: SerialArm, walk: AlignmentPath, i: int, targets: list[Transform]
) -> tuple[float, float]:
    """Angle [rad] and distance [m] between axis i of b, as laid, and axis i of a."""
    u = walk.signs[i] * (walk.here.R @ b.joints[i].axis)
    t = targets[i].R @ a.joints[i].axis
    angle = float(np.arctan2(np.linalg.norm(np.cross(u, t)), u @ t))
    if b.joints[i].kind == "prismatic":
        return angle, 0.0
    return angle, float(np.linalg.norm(across(walk.here.p - targets[i].p, t)))


def met_at_the_tool(
    a: SerialArm, b: SerialArm, walk: AlignmentPath
) -> tuple[AlignmentPath, float, tuple[str, ...]]:
    """The last joint's zero, and the last slack, if there is a common tool frame to show them."""
    last, joint, P = b.n - 1, b.joints[-1], b.links[-1].link_tip_frame
    tool_a = tool_pose(a)
    rotation = Transform.identity()
    if joint.kind == "revolute" or last == 0:
        angle = tool_angle(walk.here.R @ joint.axis, walk.here @ P, tool_a)
        rotation = Transform.rotation(joint.axis, angle)
    free_translation = walk.free_translation
    if joint.kind == "prismatic" and last > 0:
        free_translation = free_translation.with_slide(walk.here.R @ joint.axis, last)
    free_translation, shift, meaning = free_translation.taken_up(
        tool_a.p - (walk.here @ rotation @ P).p
    )
    rest = tool_a.inverse() @ Transform.translation(shift) @ walk.here @ rotation @ P
    if rest.angle() > NEAR_ANGLE or np.linalg.norm(rest.p) > NEAR_LENGTH:
        said = f"the zero of joint {b.n} ({a.joints[last].name})"
        if walk.free_translation.directions.shape[1]:
            said += " and a shift along parallel axes"
        return walk, 0.0, (f"{said}: only a common tool frame shows it, and these arms have none",)
    own = walk.here.R @ joint.axis * meaning[3 + last]  # the last joint's slide moves its link only
    here = Transform(walk.here.R, walk.here.p + shift - own)
    met = replace(walk, here=here, free_translation=free_translation, slid=walk.slid + meaning)
    if last == 0:  # a single joint: its zero and a turn of the base are one freedom
        return replace(met, here=here @ rotation), 0.0, ()
    return met, (signed_angle(rotation.R, joint.axis) if joint.kind == "revolute" else 0.0), ()
