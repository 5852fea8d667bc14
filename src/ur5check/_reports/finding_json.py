"""A finding as JSON."""

from __future__ import annotations

from typing import Literal

import msgspec

from .._finding import Finding
from .json_values import Number

__all__ = ["FindingValue", "PlaceValue", "finding_value"]


class PlaceValue(msgspec.Struct, frozen=True, kw_only=True):
    """Where something is written; line and column from 1, null where unknown."""

    file: str
    line: int | None
    column: int | None
    element: str


class FindingValue(msgspec.Struct, frozen=True, kw_only=True):
    """One thing that is wrong (docs/rules.md)."""

    rule: str
    severity: Literal["error", "warning", "note"]
    subject: str
    message: str
    places: list[PlaceValue]
    value: Number | str | None
    bound: Number | str | None
    unit: str
    consequence: str
    fix: str
    effect: Number | None


def finding_value(f: Finding) -> FindingValue:
    """A finding's fields."""
    return FindingValue(
        rule=f.rule,
        severity=f.severity,
        subject=f.subject,
        message=f.message,
        places=[
            PlaceValue(file=p.file, line=p.line or None, column=p.column or None, element=p.element)
            for p in f.places
        ],
        value=f.value,
        bound=f.bound,
        unit=f.unit,
        consequence=f.consequence,
        fix=f.fix,
        effect=f.effect,
    )
