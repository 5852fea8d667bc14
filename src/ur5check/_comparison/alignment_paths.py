"""All alignments of two arms, axis by axis: every way in which the axes become the same lines.

With the axes 1 … i of arm b in place, joint i can still turn, and the angle that brings axis i + 1
onto its counterpart is that joint's zero offset.  Where two consecutive axes meet at right angles,
axis i + 1 fits either way round, and both ways are followed.  Translations that leave
everything found so far in place (along parallel axes, or along a sliding joint) are kept as
`FreeTranslation` until a later axis determines them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

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

__all__ = [
    "NEAR_ANGLE",
    "NEAR_LENGTH",
    "AlignmentPath",
    "Undetermined",
    "alignment_paths",
    "as_written",
    "met_at_the_tool",
]

#: Below this two axes may be one and the same, or parallel: no zero is read off so small a lever.
#: Also what counts as *nearly* one line: a rounding such as 1.5707 for π/2 (1e-4 rad), or a length
#: rounded to the millimetre.
NEAR_LENGTH = 1e-3  # [m]
NEAR_ANGLE = 1e-3  # [rad]

_NOTHING = 1e-9  # [m] or [rad]: rounding of a product of transforms


@dataclass(frozen=True)
class Undetermined:
    """A joint whose zero does not show in the axes.

    joint : from 1
    reason : "same line": it turns about the line of the next joint, only their sum shows; "tool":
        only a common tool frame shows it, and the arms have none
    """

    joint: int
    reason: Literal["same line", "tool"]


@dataclass(frozen=True, eq=False)
class FreeTranslation:
    """Translations that would leave every axis found so far where it is.

    directions : (3, k), in a's base frame
    meanings : (3 + n, k), what one unit of each direction means: a shift of the base, an offset of
        a sliding joint
    """

    directions: Array
    meanings: Array

    def taken_up(
        self, gap: Array, along: Array | None = None
    ) -> tuple[FreeTranslation, Array, Array]:
        """Close `gap` as far as sliding can; a gap along the axis `along` is none.

        The base is shifted before a joint's zero is.

        Returns the free translation that remains, the translation made, and its meaning (3 + n,).
        """
        seen_part = np.eye(3) if along is None else np.eye(3) - np.outer(along, along)
        seen = seen_part @ self.directions
        u, sizes, vt = np.linalg.svd(seen, full_matrices=True)
        rank = int((sizes > 1e-9).sum())  # directions are unit vectors: parallel means rounding
        by_base = np.where(np.abs(self.meanings[3:]).max(axis=0, initial=0.0) > 1e-9, 0.0, seen)
        y = np.linalg.pinv(by_base, rcond=1e-9) @ (seen_part @ gap)
        y += vt[:rank].T @ ((u[:, :rank].T @ (seen_part @ gap - seen @ y)) / sizes[:rank])
        rest = vt[rank:].T
        left = FreeTranslation(self.directions @ rest, self.meanings @ rest)
        return left, self.directions @ y, self.meanings @ y

    def with_slide(self, direction: Array, joint: int) -> FreeTranslation:
        """This free translation, and a sliding joint's own."""
        meaning = np.zeros(len(self.meanings))
        meaning[3 + joint] = 1.0
        return FreeTranslation(
            np.column_stack([self.directions, direction]), np.column_stack([self.meanings, meaning])
        )


@dataclass(frozen=True, eq=False)
class AlignmentPath:
    """Arm b aligned with arm a as far as joint i.

    here : the frame that joint i of b starts from, in a's base frame
    """

    here: Transform
    signs: tuple[float, ...]
    offsets: tuple[float, ...]
    free_translation: FreeTranslation
    slid: Array  # (3 + n,): translation made so far, as shifts of the base and joint offsets
    unknown: tuple[Undetermined, ...]


def alignment_paths(
    a: SerialArm, b: SerialArm, angle: float, length: float
) -> Iterator[AlignmentPath]:
    """Every alignment of b with a that has all axes within the tolerances."""
    targets = joint_starts(a)

    def onward(path: AlignmentPath, i: int) -> Iterator[AlignmentPath]:
        """All ends of a path that has the axes up to i in place; joint i's zero is still free."""
        if i + 1 == b.n:
            yield path
            return
        for turned in _turns(a, b, path, i, targets):
            placed = _place(a, b, turned, i + 1, targets)
            off_angle, off_length = _gap(a, b, placed, i + 1, targets)
            if off_angle <= angle and off_length <= length:
                yield from onward(placed, i + 1)

    for sign in (1.0, -1.0):
        yield from onward(_start(a, b, sign, targets), 0)


def as_written(a: SerialArm, b: SerialArm) -> Iterator[AlignmentPath]:
    """Arm b aligned with its joint coordinates as written: the base is fitted to axes 1 and 2."""
    targets = joint_starts(a)
    path = _start(a, b, 1.0, targets)
    if b.n > 1:
        path = next(_turns(a, b, path, 0, targets))
        path = replace(path, signs=(1.0, 1.0))
        for i in range(1, b.n):
            if i > 1:
                here = path.here @ b.links[i - 1].link_tip_frame
                path = replace(
                    path, here=here, signs=(*path.signs, 1.0), offsets=(*path.offsets, 0.0)
                )
            path = _place(a, b, path, i, targets)
    yield path


def _start(a: SerialArm, b: SerialArm, sign: float, targets: list[Transform]) -> AlignmentPath:
    """Axis 1 of b on axis 1 of a, by the smallest turn; the base may still turn and slide."""
    axis = sign * (targets[0].R @ a.joints[0].axis)
    rotation = smallest_rotation(b.base.R @ b.joints[0].axis, axis)
    # Slide along the axis is open; start with both base origins at the same height along it.
    origin = targets[0].p - rotation.R @ b.base.p
    X = Transform(rotation.R, origin - axis * (axis @ origin))
    meanings = np.zeros((3 + b.n, 1))
    directions = axis[:, None]
    if b.joints[0].kind == "prismatic":  # no line at all, only a direction
        directions, meanings = np.eye(3), np.zeros((3 + b.n, 3))
        X = rotation
    meanings[:3] = directions
    return AlignmentPath(
        X @ b.base, (sign,), (), FreeTranslation(directions, meanings), np.zeros(3 + b.n), ()
    )


def _turns(
    a: SerialArm, b: SerialArm, path: AlignmentPath, i: int, targets: list[Transform]
) -> Iterator[AlignmentPath]:
    """Joint i of b turned so that what follows points as in a; the path advances to joint i + 1."""
    joint = b.joints[i]
    if joint.kind == "prismatic" and i > 0:
        direction = path.here.R @ joint.axis
        free_translation = path.free_translation.with_slide(direction, i)
        yield _arrived(a, b, replace(path, free_translation=free_translation), i, 0.0, targets)
        return
    angles, certain = _zeros(a, b, path, i, targets)
    for angle in angles:
        yield _arrived(a, b, path, i, angle, targets)
    if not certain:
        unsure = path
        if joint.kind == "revolute":
            unsure = replace(path, unknown=(*path.unknown, Undetermined(i + 1, "same line")))
        yield _arrived(a, b, unsure, i, 0.0, targets)


def _zeros(
    a: SerialArm, b: SerialArm, path: AlignmentPath, i: int, targets: list[Transform]
) -> tuple[list[float], bool]:
    """Angles of joint i that may bring what follows into place, and whether one of them must.

    A following axis that points elsewhere shows the angle, either way round; one that is parallel
    shows it by where it stands.  A lever of less than a milliradian or a millimetre shows it badly
    and may be a rounded digit: such angles are candidates, and the axes that follow decide.
    """
    axis, back, ahead = b.joints[i].axis, path.here.inverse(), Transform.identity()
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
    a: SerialArm, b: SerialArm, path: AlignmentPath, i: int, angle: float, targets: list[Transform]
) -> AlignmentPath:
    """The path at joint i + 1, with the sign of that joint's axis.

    A turn of joint 1 is given to the base instead: the axis is the same.
    """
    moved = Transform.rotation(b.joints[i].axis, angle)
    here = path.here @ moved @ b.links[i].link_tip_frame
    along = (here.R @ b.joints[i + 1].axis) @ (targets[i + 1].R @ a.joints[i + 1].axis)
    sign = 1.0 if along >= 0.0 else -1.0
    return replace(
        path,
        here=here,
        signs=(*path.signs, sign),
        offsets=(*path.offsets, angle if i > 0 else 0.0),
    )


def _place(
    a: SerialArm, b: SerialArm, path: AlignmentPath, i: int, targets: list[Transform]
) -> AlignmentPath:
    """Use the free translation to bring axis i onto its counterpart as far as possible."""
    if b.joints[i].kind == "prismatic":
        return path
    along = targets[i].R @ a.joints[i].axis
    free_translation, shift, meaning = path.free_translation.taken_up(
        targets[i].p - path.here.p, along
    )
    here = Transform(path.here.R, path.here.p + shift)
    return replace(path, here=here, free_translation=free_translation, slid=path.slid + meaning)


def _gap(
    a: SerialArm, b: SerialArm, path: AlignmentPath, i: int, targets: list[Transform]
) -> tuple[float, float]:
    """Angle [rad] and distance [m] between axis i of b, as aligned, and axis i of a."""
    u = path.signs[i] * (path.here.R @ b.joints[i].axis)
    t = targets[i].R @ a.joints[i].axis
    angle = float(np.arctan2(np.linalg.norm(np.cross(u, t)), u @ t))
    if b.joints[i].kind == "prismatic":
        return angle, 0.0
    return angle, float(np.linalg.norm(across(path.here.p - targets[i].p, t)))


def met_at_the_tool(a: SerialArm, b: SerialArm, path: AlignmentPath) -> tuple[AlignmentPath, float]:
    """The path and the last joint's zero that bring the tool frames together.

    The path is marked as undetermined where the arms have no common tool frame.
    """
    last, joint, P = b.n - 1, b.joints[-1], b.links[-1].link_tip_frame
    tool_a = tool_pose(a)
    rotation = Transform.identity()
    if joint.kind == "revolute" or last == 0:
        angle = tool_angle(path.here.R @ joint.axis, path.here @ P, tool_a)
        rotation = Transform.rotation(joint.axis, angle)
    free_translation = path.free_translation
    if joint.kind == "prismatic" and last > 0:
        free_translation = free_translation.with_slide(path.here.R @ joint.axis, last)
    free_translation, shift, meaning = free_translation.taken_up(
        tool_a.p - (path.here @ rotation @ P).p
    )
    rest = tool_a.inverse() @ Transform.translation(shift) @ path.here @ rotation @ P
    if rest.angle() > NEAR_ANGLE or np.linalg.norm(rest.p) > NEAR_LENGTH:
        return replace(path, unknown=(*path.unknown, Undetermined(b.n, "tool"))), 0.0
    own = path.here.R @ joint.axis * meaning[3 + last]  # the last joint's slide moves its link only
    here = Transform(path.here.R, path.here.p + shift - own)
    met = replace(path, here=here, free_translation=free_translation, slid=path.slid + meaning)
    if last == 0:  # a single joint: its zero and a turn of the base are one freedom
        return replace(met, here=here @ rotation), 0.0
    return met, (signed_angle(rotation.R, joint.axis) if joint.kind == "revolute" else 0.0)
