"""Inertia tensors: which formula made each, and which did not."""

from __future__ import annotations

from ..._paper.reproduction import Reproduction
from ..document import Column, Row, Section, Table
from ..wording import MISSING, figures

__all__ = ["formulas_section"]


def formulas_section(r: Reproduction) -> Section:
    """A row a link."""
    rows = []
    for f in r.formulas:
        cells = (
            str(f.link),
            f"{f.across:.9f}",
            MISSING if f.radius is None else f"{f.radius:g}",
            MISSING if f.length is None else f"{f.length:g}",
            "none known" if f.formula is None else f.formula.text,
            f"{f.honest:.9f}",
            f"{100.0 * f.honest_error:.1f}",
            figures(f.honest_length),
        )
        rows.append(Row(cells, bad=f.formula is None or not f.formula.honest))
    table = Table(
        (
            Column("link"),
            Column("I_xx = I_yy as printed", number=True),
            Column("radius [m]", number=True),
            Column("length [m]", number=True),
            Column("formula that gives it"),
            Column("eq. 3 gives", number=True),
            Column("off by [%]", number=True),
            Column("eq. 3 would need a length of [m]", number=True),
        ),
        tuple(rows),
        note="I in kg m². Cylinders are the appendix's. A formula is accepted if it gives "
        "every printed digit.",
    )
    return Section("The inertia formulas, eqs 3 to 8", tables=(table,))
