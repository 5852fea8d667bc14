"""Two arms in one set of joint coordinates, one base frame, and corresponding link frames."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..arm.inertia import Inertia
from ..arm.serial_arm import SerialArm
from ..arm.transforms import Array, Transform
from ..dynamics.kinematics import link_frames
from .alignment import (
    SAME_ANGLE,
    SAME_LENGTH,
    Alignment,
    align,
    align_as_written,
    arm_in_coordinates_of,
)

__all__ = ["Pair", "Side", "pair_as_written", "pair_up", "same_recipe"]

Side = Literal["a", "b"]


@dataclass(frozen=True, eq=False)
class Pair:
    """Arms `a` and `b`, ready to be compared at the same q.

    a : the first arm, as given
    b : the second, in a's joint coordinates and base frame
    given_b : the second, as given
    alignment : how b was brought there
    link_maps : for each link, the transform from b's link frame to a's in which the two links'
        inertias are held against each other, T_{a,i ← b,i}
    """

    a: SerialArm
    b: SerialArm
    given_b: SerialArm
    alignment: Alignment
    link_maps: tuple[Transform, ...]

    def inertias_b(self) -> tuple[Inertia, ...]:
        """B's inertias, each in arm a's link frame."""
        return tuple(
            link.inertia.expressed_in(T)
            for link, T in zip(self.b.links, self.link_maps, strict=True)
        )

    def parameter_difference(self) -> Array:
        """π_a − π_b, shape (10 n,), both in arm a's link frames."""
        pi_b = np.concatenate([inertia.parameters() for inertia in self.inertias_b()])
        return np.asarray(self.a.parameters() - pi_b)

    def arm(self, geometry: Side, inertias: Side, gravity: Side) -> SerialArm:
        """The arm with one side's geometry, inertias and gravity each, in a's coordinates."""
        arm = self.a if geometry == "a" else self.b
        if geometry == "a" and inertias == "b":
            arm = arm.with_inertias(self.inertias_b())
        elif geometry == "b" and inertias == "a":
            arm = arm.with_inertias(
                [
                    link.inertia.expressed_in(T.inverse())
                    for link, T in zip(self.a.links, self.link_maps, strict=True)
                ]
            )
        return arm.with_gravity((self.a if gravity == "a" else self.b).gravity)


def pair_up(a: SerialArm, b: SerialArm) -> Pair:
    """Align b with a and find the frames in which their links correspond.

    Raises UsageError if the arms have different numbers or kinds of joints.
    """
    return _paired(a, b, align(a, b))


def pair_as_written(a: SerialArm, b: SerialArm) -> Pair:
    """The same with b's joint angles as they stand, whether or not the axes then coincide."""
    return _paired(a, b, align_as_written(a, b))


def _paired(a: SerialArm, b: SerialArm, alignment: Alignment) -> Pair:
    moved = arm_in_coordinates_of(a, b, alignment)
    return Pair(a, moved, b, alignment, _link_maps(a, moved, alignment.exact))


def _link_maps(a: SerialArm, b: SerialArm, same_axes: bool) -> tuple[Transform, ...]:
    """Link frames that coincide in space at q = 0 correspond; so do those of one recipe.

    Two files written in the same frames are compared digit by digit, untouched by rounding: a map
    between source frames that is the identity within the tolerance of the axes becomes exactly so.
    With unequal geometry nothing coincides, and frames made by the same recipe are taken as the
    same, so that a wrong length counts as geometry and not as a centre of mass too.
    """
    rest = [0.0] * a.n
    in_space = [
        Transform.from_matrix(T_a).inverse() @ Transform.from_matrix(T_b)
        for T_a, T_b in zip(link_frames(a, rest), link_frames(b, rest), strict=True)
    ]
    as_written = [
        la.source_frame @ lb.source_frame.inverse() for la, lb in zip(a.links, b.links, strict=True)
    ]
    if not same_axes:
        return tuple(as_written if same_recipe(a, b) else in_space)
    between_sources = [
        la.source_frame.inverse() @ T @ lb.source_frame
        for la, T, lb in zip(a.links, in_space, b.links, strict=True)
    ]
    return tuple(
        written if E.angle() < SAME_ANGLE and abs(E.p).max() < SAME_LENGTH else T
        for T, E, written in zip(in_space, between_sources, as_written, strict=True)
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
