"""What a known mistake is: one record with what it spoils, the transformation that undoes it, and
the rule of family CMP under which it is reported."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np

from ..._finding import Severity
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from ..._rules.rule import Rule
from ..arm_pair import Pair, Side
from ..rounded_constants.exact_constants import RoundedConstant
from .link_numbers import Body, LinkPair

__all__ = [
    "ArmDifference",
    "ArmMistake",
    "LinkMistake",
    "Mistake",
    "Quantity",
    "Repair",
    "changed",
    "value_of",
]

#: What a mistake in one link spoils: one number, vector or matrix; "body" is mass, centre of mass
#: and tensor at once.
Quantity = Literal["mass", "centre", "tensor", "link_vector", "rotation", "body"]

_FIELDS: dict[Quantity, str] = {
    "mass": "mass",
    "centre": "com",
    "tensor": "tensor",
    "link_vector": "offset",
    "rotation": "rotation",
    "body": "whole",
}

_SPOILS: dict[Quantity, str] = {
    "mass": "mass",
    "centre": "centre of mass",
    "tensor": "tensor",
    "link_vector": "length",
    "rotation": "twist",
    "body": "mass, centre and tensor",
}

_WHY: dict[Quantity, str] = {
    "mass": "gravity and inertial torques of every joint before the link grow with its mass",
    "centre": "gravity torque is weight times lever: a wrong centre of mass shows in every static "
    "hold",
    "tensor": "inertial torques and the mass matrix are wrong while gravity torque is right, so "
    "that only motion shows it",
    "link_vector": "every frame beyond the link moves: the tool pose and all torques are wrong",
    "rotation": "every axis beyond the link tilts: the tool pose and all torques are wrong",
    "body": "mass, centre of mass and tensor are wrong together, in gravity and inertial torques",
}

#: (how, the repaired value): one way in which the mistake could have been made.
Repair = tuple[str, Any]


@dataclass(frozen=True, kw_only=True, eq=False)
class Mistake(ABC):
    """A known mistake between two models of one arm.

    id : how reports, tests and the docs name it
    rule_id : of family CMP, never used again for anything else
    says : what happened, as a clause;  repair : what to do in the file, as an imperative
    bad, good : an example, in words: what stands in one file and what in the other
    sources : where it was met: "account/repository#number" of a public report, or the name of a
        shipped model
    severity : of its findings; a "note" is a convention, not a mistake
    """

    id: str
    rule_id: str
    says: str
    repair: str
    bad: str
    good: str
    sources: tuple[str, ...] = ()
    severity: Severity = "warning"

    @property
    @abstractmethod
    def spoils(self) -> str:
        """What it makes wrong, in words."""

    @property
    @abstractmethod
    def consequence(self) -> str:
        """What it does to a user of the model, as a clause."""

    def rule(self) -> Rule:
        """The record in the registry of rules."""
        return Rule(
            id=self.rule_id,
            name=self.id,
            severity=self.severity,
            checks=f"whether {self.says}",
            why="two models of one robot must give the same torques for the same motion",
            consequence=self.consequence,
            bad=self.bad,
            good=self.good,
            fix=self.repair,
            report=next((source for source in self.sources if "#" in source), ""),
            example="words",
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class LinkMistake(Mistake):
    """A mistake in one number of one link.

    quantity : the number
    repairs : of a link pair and a link (from 0), every value that would undo the mistake
    alone : whether it must explain a number by itself.  Most mistakes are undone from the suspect's
        own numbers and may come in pairs; one that takes its value from elsewhere would, in a
        pair, explain anything.
    """

    quantity: Quantity
    repairs: Callable[[LinkPair, int], Iterator[Repair]]
    alone: bool = False

    @property
    def spoils(self) -> str:
        return _SPOILS[self.quantity]

    @property
    def consequence(self) -> str:
        return _WHY[self.quantity]


@dataclass(frozen=True, eq=False)
class ArmDifference:
    """What is different between two arms as a whole.

    side : the arm in which the mistake was made, None where nothing decides
    choices : how many values were tried
    joints : numbers from 1 and what is different at each [rad], [m] or [kg m²]
    base : pose of b's base in a's;  gravity : a's and b's, in a's base frame [m/s²]
    motors : a's and b's motor inertias, shape (2, n) [kg m²]
    links, rounded : the links with a rounded constant, numbers from 1, and how it is written
    """

    side: Side | None
    choices: int = 1
    joints: tuple[tuple[int, float], ...] = ()
    base: Transform = field(default_factory=Transform.identity)
    gravity: tuple[Array, Array] = (np.zeros(3), np.zeros(3))
    motors: Array = field(default_factory=lambda: np.zeros((2, 0)))
    links: tuple[int, ...] = ()
    rounded: RoundedConstant | None = None


#: Arm b less the mistake; the transform takes vectors from a's base frame to the arm's.
ArmRepair = Callable[[SerialArm, ArmDifference, Transform], SerialArm]


@dataclass(frozen=True, kw_only=True, eq=False)
class ArmMistake(Mistake):
    """A mistake, or a difference of convention, that concerns the whole arm.

    sentence : what happened, with places for values: {a}, {b} and {arm} are the models' labels,
        {joints}, {angles}, {base}, {gravity}, {motors} and {rounded} what `ArmDifference` holds
    affects, why : what it makes wrong, and what that does
    find : of an aligned pair, and the side whose DH table was read by the other convention
    repaired : see ArmRepair; None where b needs no change, once the two arms are aligned
    changes_torque : whether it changes torques that are compared at the same aligned state
    """

    sentence: str
    affects: str
    why: str
    find: Callable[[Pair, Side | None], ArmDifference | None]
    repaired: ArmRepair | None = None
    changes_torque: bool = True

    @property
    def spoils(self) -> str:
        return self.affects

    @property
    def consequence(self) -> str:
        return self.why


def value_of(body: Body, quantity: Quantity) -> Any:
    """The body's mass, centre, tensor, link vector or rotation, or its inertia as a whole."""
    return getattr(body, _FIELDS[quantity])


def changed(body: Body, quantity: Quantity, value: Any) -> Body:
    """The body with one quantity replaced."""
    if quantity == "body":
        return replace(body, mass=value.mass, com=value.com, tensor=value.tensor)
    return replace(body, **{_FIELDS[quantity]: value})
