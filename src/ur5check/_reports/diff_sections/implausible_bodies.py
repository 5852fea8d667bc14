"""Plausibility: findings about the bodies of both arms, worst first."""

from __future__ import annotations

from ..._comparison.explanation import Explanation
from ..._comparison.plausibility.plausible_body import Plausibility, Severity
from ..document import Column, Row, Section, Table
from ..wording import figures

__all__ = ["bodies_section"]

_GRAVEST_FIRST: tuple[Severity, ...] = ("impossible", "suspicious", "note")


def bodies_section(e: Explanation) -> Section:
    """Findings, worst first; they do not change the verdict."""
    pair = e.difference.pair
    found = [(pair.a.label, p) for p in e.plausible_a]
    # The same arm twice has the same findings.
    found += [(pair.b.label, p) for p in e.plausible_b if (pair.b.label, p) not in found]
    if not found:
        return Section("Plausibility", ("No findings about either arm's bodies.",))
    found.sort(key=lambda of: _GRAVEST_FIRST.index(of[1].severity))
    table = Table(
        (
            Column(""),
            Column("in"),
            Column("finding"),
            Column("found", number=True),
            Column("bound", number=True),
            Column("unit"),
        ),
        tuple(_row(name, p) for name, p in found),
        note="Impossible: for any body, or for a body of the shape of its mesh. Suspicious: "
        "outside the range of robot arms.",
    )
    return Section("Plausibility", tables=(table,))


def _row(name: str, p: Plausibility) -> Row:
    cells = (p.severity, name, p.sentence, figures(p.value), figures(p.bound), p.unit)
    return Row(cells, bad=p.severity == "impossible")
