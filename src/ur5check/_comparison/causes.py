"""What the first screen of `diff` says of a difference's causes: the cheap part of `explain`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from .._robot.states import MAX_ACCELERATION, States
from .diagnosis.diagnosis import Diagnosis, diagnose
from .difference import Difference
from .worst_case.worst_case import WorstCase, worst_torque

__all__ = ["Causes", "evidence", "find_causes"]

#: States enough for evidence: an RMS over a thousand of them is known to a few per cent.
_EVIDENCE = 1_000


@dataclass(frozen=True, eq=False)
class Causes:
    """Known mistakes, and the worst configuration of the joint that differs most.

    worst : in motion; None where the torques agree
    """

    diagnosis: Diagnosis
    worst: WorstCase | None


def find_causes(
    difference: Difference,
    *,
    acceleration: float = MAX_ACCELERATION,
    progress: Callable[[str], None],
) -> Causes:
    """As `explain` does, of one joint only, and without terms, identifiability, digits, bodies."""
    progress("looking for known mistakes")
    diagnosis = diagnose(difference.pair, evidence(difference))
    worst = None
    if not difference.same_torques:
        progress("searching for the worst configuration")
        joint = int(difference.torques.maximum.argmax()) + 1
        worst = worst_torque(
            difference.pair, joint, seed=difference.seed, acceleration=acceleration
        )
    return Causes(diagnosis, worst)


def evidence(difference: Difference) -> States:
    """The states at which mistakes are measured."""
    states = difference.states
    return States(states.q[:_EVIDENCE], states.qd[:_EVIDENCE], states.qdd[:_EVIDENCE])
