"""Differences between the answers of every pair of engines, at the same states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from .engine_answers import AnswerDifference, Answers, answer_difference

__all__ = ["AgreementMatrix", "matrix_of"]


@dataclass(frozen=True)
class AgreementMatrix:
    """keys : the engines, in the order of reports;  pairs : all pairs of them, in that order"""

    keys: tuple[str, ...]
    pairs: tuple[AnswerDifference, ...]

    def between(self, a: str, b: str) -> AnswerDifference:
        """The difference of two engines, in either order.  Raises KeyError for others."""
        for pair in self.pairs:
            if {pair.a, pair.b} == {a, b}:
                return pair
        raise KeyError((a, b))

    @property
    def worst(self) -> float:
        """The largest |Δτ| of any pair [N m]; zero for an engine alone."""
        return max((pair.torque for pair in self.pairs), default=0.0)

    def agreeing(self, limit: float) -> tuple[tuple[str, ...], ...]:
        """The engines in groups whose torques agree within `limit`, the largest group first.

        An engine joins the first group with all of which it agrees.
        """
        groups: list[list[str]] = []
        for key in self.keys:
            for group in groups:
                if all(self.between(key, other).torque <= limit for other in group):
                    group.append(key)
                    break
            else:
                groups.append([key])
        return tuple(tuple(group) for group in sorted(groups, key=len, reverse=True))


def matrix_of(answers: Sequence[Answers]) -> AgreementMatrix:
    """All pairs of engines, from their answers at the same states."""
    pairs = tuple(answer_difference(a, b) for a, b in combinations(answers, 2))
    return AgreementMatrix(tuple(one.key for one in answers), pairs)
