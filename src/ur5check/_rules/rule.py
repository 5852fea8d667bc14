"""A rule: what is checked, why it matters, and an example that it refuses, in one record."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, Literal, get_args

from .._finding import Finding, Severity

__all__ = ["FAMILIES", "Family", "Rule"]

Family = Literal["XML", "XAC", "TRE", "INE", "GEO", "JNT", "ROB", "ENG", "CMP", "LOG"]

#: What each family of rules is about.
FAMILIES: dict[Family, str] = {
    "XML": "the file's format",
    "XAC": "xacro expansion",
    "TRE": "the tree of links and joints",
    "INE": "masses, centres of mass and inertia tensors",
    "GEO": "shapes",
    "JNT": "joints and their limits",
    "ROB": "the robot as a whole",
    "ENG": "what a physics engine imports",
    "CMP": "two models of one robot",
    "LOG": "recordings",
}


@dataclass(frozen=True, eq=False)
class Rule:
    """One rule.

    id : family and number, "INE102": never used again for anything else
    name : a short name in words with hyphens, "triangle-inequality"
    severity : of its findings, at most
    checks : what is checked, in one sentence
    why : why it matters
    consequence : what a simulator or controller does with such a model, for the report
    bad, good : what the rule refuses and what it accepts: a file's text (of the format `example`),
        or words where the example is a pair of files or a recording
    fix : what to do
    report : the public report that shows it (address or citation), "" where there is none
    check : yields findings of a subject; None where the check is part of reading or comparing
    example : suffix of the format that `bad` and `good` are written in
    """

    id: str
    name: str
    severity: Severity
    checks: str
    why: str
    consequence: str
    bad: str
    good: str
    fix: str
    report: str = ""
    check: Callable[[Any], Iterable[Finding]] | None = None
    example: str = ".urdf"

    def __post_init__(self) -> None:
        """A rule that cannot be shown to refuse anything is none."""
        family = self.id[:3]
        if family not in get_args(Family) or not re.fullmatch(r"[A-Z]{3}\d{3}", self.id):
            raise ValueError(f"{self.id!r} is no rule id: a family and three digits")
        texts = (self.bad, self.good, self.checks, self.why, self.consequence, self.fix)
        if not all(text.strip() for text in texts):
            raise ValueError(
                f"rule {self.id} needs a bad and a good example, a reason, a consequence and a fix"
            )

    @property
    def family(self) -> Family:
        """The three letters of its id."""
        return next(family for family in FAMILIES if self.id.startswith(family))
