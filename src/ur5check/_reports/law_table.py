"""The laws as one compact table: law, deviation, tolerance."""

from __future__ import annotations

import math

from .._validation.law import Outcome
from .._validation.validation import Validation
from .document import Column, Row, Table
from .wording import residue

__all__ = ["law_table"]

# With more models than this, a column each would not fit: the worst of them is shown.
_MOST_COLUMNS = 3


def law_table(v: Validation) -> Table:
    """One row a law, what fails first."""
    by_law: dict[str, list[Outcome]] = {}
    for outcome in v.outcomes:
        if outcome.about == "algorithm":
            by_law.setdefault(outcome.id, []).append(outcome)
    laws = sorted(by_law.values(), key=lambda law: all(o.passed for o in law))
    names = [model.arm.label for model in v.models]
    wide = len(names) <= _MOST_COLUMNS
    columns = [Column(name, number=True) for name in names] if wide else []
    if not wide:
        columns = [Column("worst", number=True), Column("on")]
    return Table(
        (Column(""), Column("law"), *columns, Column("must be", number=True), Column("unit")),
        tuple(_row(law, wide) for law in laws),
        note="Values: the worst over all states.",
    )


def _row(law: list[Outcome], wide: bool) -> Row:
    holds = all(o.passed for o in law)
    tightest = _tightest(law)
    values = [residue(o.value) for o in law]
    if not wide:
        worst = max(law, key=_used)
        values = [residue(worst.value), worst.subject]
    limit = f"{'>' if law[0].positive else '≤'} {residue(tightest.tolerance)}"
    cells = ("ok" if holds else "FAILS", law[0].statement, *values, limit, law[0].unit)
    return Row(cells, bad=not holds)


def _tightest(law: list[Outcome]) -> Outcome:
    choose = max if law[0].positive else min
    return choose(law, key=lambda o: o.tolerance)


def _used(outcome: Outcome) -> tuple[bool, float]:
    """Failing laws first, then by value."""
    if math.isnan(outcome.value):
        return True, math.inf
    return not outcome.passed, -outcome.value if outcome.positive else outcome.value
