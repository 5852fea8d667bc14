"""`ur5check diff` of robots with several chains as JSON."""

from __future__ import annotations

import msgspec

from .._comparison.limb_comparison import LimbComparison
from .diff_json import Comparison, comparison_value
from .json_report import Report, head
from .limbs_document import limbs_verdict

__all__ = ["LimbsReport", "limbs_json"]


class LimbValue(msgspec.Struct, frozen=True, kw_only=True):
    """A limb by its last link in either robot, null where one has not got it."""

    a: str | None
    b: str | None
    agrees: bool
    problem: str | None
    comparison: Comparison | None


class LimbsReport(Report, frozen=True, kw_only=True, tag="ur5check.diff-limbs/2"):
    """Two robots compared limb by limb."""

    agrees: bool
    summary: list[str]
    limbs: list[LimbValue]


def limbs_json(c: LimbComparison, *, command: str = "") -> LimbsReport:
    """The report of `ur5check diff` of two robots."""
    first = next((limb.difference for limb in c.limbs if limb.difference is not None), None)
    arms = [] if first is None else [first.pair.a, first.pair.given_b]
    seed, samples = (None, None) if first is None else (first.seed, len(first.states))
    return LimbsReport(
        **head(arms, command, seed=seed, samples=samples),
        agrees=c.agrees,
        summary=[limbs_verdict(c)],
        limbs=[
            LimbValue(
                a=limb.a,
                b=limb.b,
                agrees=limb.agrees,
                problem=limb.problem or None,
                comparison=None if limb.difference is None else comparison_value(limb.difference),
            )
            for limb in c.limbs
        ],
    )
