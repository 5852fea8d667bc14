"""Findings as they are made: rule, place, numbers; severity, consequence and fix from the rule."""

from __future__ import annotations

from .._finding import SEVERITIES, Finding, Place, Severity
from .registry import rule_of

__all__ = ["FindingLog", "finding_of"]


def finding_of(
    rule: str,
    subject: str,
    message: str,
    *places: Place,
    value: float | str | None = None,
    bound: float | str | None = None,
    unit: str = "",
    severity: Severity | None = None,
    fix: str = "",
    effect: float | None = None,
) -> Finding:
    """A finding of a registered rule.

    severity : where it is less than the rule's own;  fix : where it is more exact than the rule's
    """
    record = rule_of(rule)
    if severity is not None and SEVERITIES.index(severity) < SEVERITIES.index(record.severity):
        raise ValueError(f"a finding of {rule} is at most a {record.severity}")
    return Finding(
        rule=rule,
        severity=severity or record.severity,
        subject=subject,
        message=message,
        places=tuple(one for place in places for one in (place, *place.via)),
        value=_plain(value),
        bound=_plain(bound),
        unit=unit,
        consequence=record.consequence,
        fix=fix or record.fix,
        effect=effect,
    )


def _plain(value: float | str | None) -> float | str | None:
    """A number without its text or array type."""
    return value if value is None or isinstance(value, str) else float(value)


class FindingLog:
    """What a reader found so far.  Reading goes on after each."""

    def __init__(self) -> None:
        self.findings: list[Finding] = []

    def add(self, rule: str, subject: str, message: str, *places: Place, **fields: object) -> None:
        """Record a finding; `fields` as in `finding_of`."""
        self.findings.append(finding_of(rule, subject, message, *places, **fields))  # type: ignore[arg-type]
