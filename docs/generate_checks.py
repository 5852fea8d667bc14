"""Writes docs/checks.md: the registry of checks as tables, inside the text of checks.in.md.

python docs/generate_checks.py
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ur5check._validation.law import Check, Tolerance
from ur5check._validation.laws import LAWS
from ur5check._validation.pair_laws import BODIES, PAIRS

HERE = Path(__file__).resolve().parent
PAGE = HERE / "checks.md"


def page() -> str:
    """The whole page."""
    text = (HERE / "checks.in.md").read_text(encoding="utf-8")
    return text.format(laws=table(LAWS), bodies=table(BODIES), pairs=table(PAIRS))


def table(checks: Iterable[Check[Any]]) -> str:
    """One row a check; what its tolerance is, and why, below."""
    checks = list(checks)
    rows = ["| id | statement | formula | unit | tolerance | source |", "|---|---|---|---|---|---|"]
    for check in checks:
        cells = (
            f"`{check.id}`",
            check.statement,
            check.formula,
            check.unit,
            limit_in_words(check),
            check.source,
        )
        rows.append(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |")
    return "\n".join([*rows, "", *reasons(checks)])


def limit_in_words(check: Check[Any]) -> str:
    """As "≤ 32 n ε · size"."""
    tolerance = check.tolerance
    sign = ">" if check.positive else "≤"
    if tolerance.per_joint:
        factor = "" if tolerance.factor == 1 else f"{tolerance.factor:g} "
        return f"{sign} {factor}n ε · size"
    return f"{sign} {tolerance.factor:g}"


def reasons(checks: list[Check[Any]]) -> list[str]:
    """Each tolerance's reason, once, with the checks that it serves."""
    by_reason: dict[Tolerance, list[str]] = {}
    for check in checks:
        by_reason.setdefault(check.tolerance, []).append(f"`{check.id}`")
    if len(by_reason) == 1:
        (tolerance,) = by_reason
        return [f"Why this tolerance: {tolerance.reason}."]
    most = max(by_reason.values(), key=len)
    lines = ["Why these tolerances:", ""]
    for tolerance, ids in by_reason.items():
        whose = "all others" if ids is most and len(ids) > 1 else ", ".join(ids)
        lines.append(f"- {whose}: {tolerance.reason}.")
    return lines


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
