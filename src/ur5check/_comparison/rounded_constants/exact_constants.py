"""Rounded constants, corrected: π/2 for 1.5707, 1/12 for 0.0833333, gravity."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..._robot.serial_arm import SerialArm
from .cylinder_constant import cut_twelfths, with_exact_twelfth
from .decimals import Writing, written_as
from .rounded_angles import rounded_angles, with_exact_angles

__all__ = [
    "GRAVITY",
    "STEPS",
    "Arms",
    "Correction",
    "RoundedConstant",
    "Side",
    "Step",
    "angles",
    "twelfths",
    "written_out",
]

Side = Literal["a", "b"]

#: Standard gravity [m/s²] (3rd CGPM, 1901): 9.8, 9.81, 9.806 and 9.807 write it with fewer digits.
GRAVITY = 9.80665

Arms = dict[Side, SerialArm]
Step = Callable[[Arms], Iterator["Correction"]]


@dataclass(frozen=True)
class RoundedConstant:
    """A constant that an arm has with fewer digits.

    constant : "π/2", "1/12" or "9.80665";  written : as the arm has it, "1.5707"
    decimals : of a number that was written down; None where it is a factor of computed numbers
    where : the transforms "P1" or "B", the links "link 2", or "gravity"
    """

    constant: str
    written: str
    decimals: int | None
    where: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Correction:
    """One rounded constant corrected in one arm.

    cause : the constant;  arm : the arm afterwards;  links : their numbers, 0 for the base
    """

    cause: RoundedConstant
    side: Side
    arm: SerialArm
    links: tuple[int, ...] = ()


def angles(arms: Arms) -> Iterator[Correction]:
    """Rounded quarter turns, those of one writing together."""
    for side, given in arms.items():
        arm, found = given, rounded_angles(given)
        kinds = {(angle.constant, angle.writing): None for angle in found}  # in order, once each
        for constant, writing in kinds:
            group = tuple(
                each for each in found if (each.constant, each.writing) == (constant, writing)
            )
            arm = with_exact_angles(arm, group)
            where = tuple(each.where for each in group)
            links = tuple(each.place for each in group)
            yield Correction(_rounded(constant, writing, where), side, arm, links)


def twelfths(arms: Arms) -> Iterator[Correction]:
    """Cylinders computed with a cut-off 1/12."""
    for side, given in arms.items():
        arm, found = given, cut_twelfths(given)
        for constant in {cut.constant: None for cut in found}:
            group = tuple(cut for cut in found if cut.constant == constant)
            arm = with_exact_twelfth(arm, group)
            where = tuple(f"link {cut.link}" for cut in group)
            links = tuple(cut.link for cut in group)
            yield Correction(RoundedConstant("1/12", constant, None, where), side, arm, links)


def gravities(arms: Arms) -> Iterator[Correction]:
    """Two different writings of GRAVITY.  Two equal ones make no difference and are left alone."""
    sizes = {side: float(np.linalg.norm(arm.gravity)) for side, arm in arms.items()}
    exact = {side for side, size in sizes.items() if abs(size - GRAVITY) <= 1e-12}
    writings = {side: written_as(size, GRAVITY) for side, size in sizes.items()}
    if abs(sizes["a"] - sizes["b"]) <= 1e-12:
        return
    if any(writing is None and side not in exact for side, writing in writings.items()):
        return
    for side, writing in writings.items():
        if writing is not None:
            better = arms[side].with_gravity(arms[side].gravity * (GRAVITY / sizes[side]))
            yield Correction(_rounded(str(GRAVITY), writing, ("gravity",)), side, better)


#: The steps of an error budget, in order.
STEPS: tuple[Step, ...] = (angles, twelfths, gravities)


def _rounded(constant: str, writing: Writing, where: tuple[str, ...]) -> RoundedConstant:
    return RoundedConstant(constant, writing.text, writing.decimals, where)


def written_out(step: Step, arms: Arms) -> tuple[Arms, tuple[Correction, ...]]:
    """Both arms after one step, and the corrections that were made.

    What both arms round in the same way in the same places makes no difference and is left alone.
    """
    found = tuple(step(arms))
    a, b = ({each.cause for each in found if each.side == side} for side in "ab")
    if a == b:
        return arms, ()
    return arms | {correction.side: correction.arm for correction in found}, found
