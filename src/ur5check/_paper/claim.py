"""A claim, its test, and its verdict.

    confirmed               what the paper printed passes
    confirmed after repair  it fails as printed, and passes once the mistake is repaired
    refuted                 it fails, and no known repair makes it pass

A claim is tested on several models; each trial compares one number with one limit. nan fails.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from .paper_models import Form

__all__ = ["Bound", "Claim", "ClaimOutcome", "Trial", "Verdict", "judged", "overall"]

Verdict = Literal["confirmed", "confirmed after repair", "refuted"]
Bound = Literal["at most", "at least", "below", "above"]


@dataclass(frozen=True)
class Claim:
    """A statement of the paper in a form that can be tested.

    id : its name in reports, tests and docs
    text : what is claimed, in our words
    test : what is measured, and the limit with its reason
    source : where the paper says it
    unit : of the number that is measured
    """

    id: str
    text: str
    test: str
    source: str
    unit: str


@dataclass(frozen=True)
class Trial:
    """The test of a claim on one model.

    form : of what the paper printed, of the same repaired, or of something else
    value, limit : in the claim's unit;  bound : on which side of the limit the value must lie
    why : the reason of this outcome; may be empty
    """

    model: str
    form: Form
    value: float
    limit: float
    why: str = ""
    bound: Bound = "at most"

    @property
    def holds(self) -> bool:
        """Whether the claim holds for this model."""
        return {
            "at most": self.value <= self.limit,
            "at least": self.value >= self.limit,
            "below": self.value < self.limit,
            "above": self.value > self.limit,
        }[self.bound]


@dataclass(frozen=True)
class ClaimOutcome:
    """The verdict on a claim for one model."""

    claim: Claim
    model: str
    form: Form
    value: float
    unit: str
    limit: float
    bound: Bound
    why: str
    verdict: Verdict

    @property
    def id(self) -> str:
        """The claim's."""
        return self.claim.id

    @property
    def holds(self) -> bool:
        """Whether the claim holds for this model."""
        return self.verdict != "refuted"


def judged(claim: Claim, trials: Iterable[Trial]) -> tuple[ClaimOutcome, ...]:
    """Every trial with its verdict.

    What is repaired is confirmed "after repair" where what is printed fails; everything else simply
    holds or does not.

    Raises ValueError without a trial of what is printed.
    """
    trials = tuple(trials)
    if not any(trial.form == "printed" for trial in trials):
        raise ValueError(f"claim {claim.id!r} is not tested on anything that the paper printed")
    printed_fails = any(t.form == "printed" and not t.holds for t in trials)
    return tuple(
        ClaimOutcome(
            claim, t.model, t.form, t.value, claim.unit, t.limit, t.bound, t.why,
            _verdict(t, printed_fails),
        )
        for t in trials
    )  # fmt: skip


def overall(outcomes: Iterable[ClaimOutcome]) -> Verdict:
    """The verdict on a claim of the paper: by what is printed, then by its repair.

    outcomes : of one claim
    """
    outcomes = tuple(outcomes)
    repaired = [o.holds for o in outcomes if o.form == "repaired"]
    if all(o.holds for o in outcomes if o.form == "printed"):
        return "confirmed"
    return "confirmed after repair" if repaired and all(repaired) else "refuted"


def _verdict(trial: Trial, printed_fails: bool) -> Verdict:
    if not trial.holds:
        return "refuted"
    return "confirmed after repair" if trial.form == "repaired" and printed_fails else "confirmed"
