"""All causes of a residual, each tested alone, rated by one criterion."""

from __future__ import annotations

from collections.abc import Iterable

from .arm_causes import arm_causes
from .cause import Cause
from .link_causes import link_causes, mistake_causes
from .weighted_problem import WeightedProblem

__all__ = ["EVIDENCE", "causes_of", "named_causes"]

#: Evidence that a cause must have to be named; also the margin by which it must beat another that
#: is then ruled out.  In Bayes' criterion 10 is "very strong" (Kass & Raftery, J. American
#: Statistical Association 90, 1995, p. 777).
EVIDENCE = 10.0

#: A named cause takes away at least this part of what free base parameters take away.
_CLOSES = 0.5


def causes_of(problem: WeightedProblem, judged: Iterable[int]) -> tuple[Cause, ...]:
    """All causes, the likeliest first.

    judged : joints (from 0) whose model torque stands out
    """
    found = [*arm_causes(problem, judged), *link_causes(problem), *mistake_causes(problem)]
    return tuple(sorted(found, key=lambda cause: -cause.evidence))


def named_causes(causes: tuple[Cause, ...]) -> tuple[Cause, ...]:
    """The likeliest cause, if there is evidence enough, and those that it does not rule out."""
    best = causes[0]
    if best.evidence <= EVIDENCE or best.closes < _CLOSES:
        return ()
    return tuple(
        cause
        for cause in causes
        if cause.evidence > max(EVIDENCE, best.evidence - EVIDENCE) and cause.closes >= _CLOSES
    )
