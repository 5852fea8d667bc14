"""`ur5check.explain`: a difference with everything that can be said of its causes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from .._arguments import callback, instance, number
from .._result import Result
from .._robot.states import MAX_ACCELERATION
from .attribution_detail import TermAttribution, by_term
from .causes import evidence
from .diagnosis.diagnosis import Diagnosis, diagnose
from .difference import Difference
from .identifiability.equivalence import Equivalence, equivalence
from .identifiability.identifiability import Identifiability, identify
from .plausibility.plausibility import Plausibility, plausibility
from .rounding.error_budget import ErrorBudget, budget
from .worst_case.worst_case import WorstCase, worst_cases

__all__ = ["Explanation", "explain"]


@dataclass(frozen=True, eq=False, repr=False)
class Explanation(Result):
    """A difference with what can be said of its causes.

    Attributes
    ----------
    difference : Difference
    terms : TermAttribution
        The attribution, split into gravity, Coriolis and inertial torque.
    identifiability : Identifiability
        The identifiable parameters of arm a.
    equivalence : Equivalence
        Whether the arms differ only in parameters without effect on torque.
    budget : ErrorBudget
        Torque error due to rounded numbers.
    diagnosis : Diagnosis
        Known mistakes, with evidence.
    worst : tuple of WorstCase
        The states of largest difference.
    plausible_a, plausible_b : tuple of Plausibility
        What is implausible about either arm's bodies.
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
    difference : Difference
        From `diff`.
    acceleration : float
        Bound on |q̈| for the worst case [rad/s²], positive.
    progress : callable, optional
        Called with a line before each longer step.

    Returns
    -------
    Explanation

    Raises
    ------
    UsageError
        For an invalid argument.

    Examples
    --------
    >>> import ur5check
    >>> arm = ur5check.load("paper")
    >>> difference = ur5check.diff(arm, arm.with_gravity(-arm.gravity), samples=9)
    >>> explanation = ur5check.explain(difference)
    >>> [mistake.id for mistake in explanation.diagnosis.mistakes]
    ['gravity-sign']
    """
    instance("difference", difference, Difference, "see ur5check.diff")
    acceleration = number("acceleration", acceleration, positive=True)
    say = callback("progress", progress)
    pair, seed = difference.pair, difference.seed
    for arm in (pair.a, pair.b):
        arm.require_tensors("an explanation")
    few = evidence(difference)
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
