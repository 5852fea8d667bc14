"""`ur5check.explain`: a difference with everything that can be said of its causes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from .._arguments import callback, instance, number
from .._result import Result
from .._robot.states import MAX_ACCELERATION, States
from .attribution_detail import TermAttribution, by_term
from .diagnosis.diagnosis import Diagnosis, diagnose
from .difference import Difference
from .identifiability.equivalence import Equivalence, equivalence
from .identifiability.identifiability import Identifiability, identify
from .plausibility.plausibility import Plausibility, plausibility
from .rounding.error_budget import ErrorBudget, budget
from .worst_case.worst_case import WorstCase, worst_cases

__all__ = ["Explanation", "explain"]

#: States enough for evidence: an RMS over a thousand of them is known to a few per cent.
_EVIDENCE = 1_000


@dataclass(frozen=True, eq=False, repr=False)
class Explanation(Result):
    """A difference, explained.

    terms : the attribution, split into gravity, Coriolis and inertial torque
    identifiability, equivalence : the identifiable parameters of arm a, and whether the arms
        differ only in others
    budget : torque error due to rounding;  diagnosis : known mistakes, with evidence
    worst : the states of largest disagreement
    plausible_a, plausible_b : what is odd about either arm's bodies
    """

    difference: Difference
    terms: TermAttribution
    identifiability: Identifiability
    equivalence: Equivalence
    budget: ErrorBudget
    diagnosis: Diagnosis
    worst: tuple[WorstCase, ...]
    plausible_a: tuple[Plausibility, ...]
    plausible_b: tuple[Plausibility, ...]


def explain(
    difference: Difference,
    *,
    acceleration: float = MAX_ACCELERATION,
    progress: Callable[[str], None] | None = None,
) -> Explanation:
    """Why two arms differ: known mistakes, attribution, what is identifiable, the worst case.

    Parameters
    ----------
    difference : from `diff`
    acceleration : bound on |q̈| for the worst case [rad/s²]
    progress : called with a line before each longer step

    Raises UsageError for an acceleration that is no positive number.
    """
    instance("difference", difference, Difference, "see ur5check.diff")
    acceleration = number("acceleration", acceleration, positive=True)
    say = callback("progress", progress)
    pair, seed = difference.pair, difference.seed
    for arm in (pair.a, pair.b):
        arm.require_tensors("an explanation")
    few = _first(difference.states, _EVIDENCE)
    say("looking for known mistakes")
    diagnosis = diagnose(pair, few)
    say("splitting the difference: terms, rounding, identifiability")
    identifiability = identify(pair.a, seed=seed)
    terms = by_term(pair, few)
    digits = budget(pair, few)
    equivalent = equivalence(pair, few, identifiability)
    say("searching for the worst case")
    worst = worst_cases(pair, seed=seed, acceleration=acceleration)
    say("checking the bodies")
    return Explanation(
        difference,
        terms,
        identifiability,
        equivalent,
        digits,
        diagnosis,
        worst,
        plausibility(pair.a),
        plausibility(pair.given_b),
    )


def _first(states: States, count: int) -> States:
    return States(states.q[:count], states.qd[:count], states.qdd[:count])
