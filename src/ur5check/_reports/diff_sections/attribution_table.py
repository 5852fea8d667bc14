"""The attribution of a torque difference: to groups of parameters, terms, single parameters."""

from __future__ import annotations

import numpy as np

from ..._comparison.attribution import Attribution
from ..._comparison.attribution_detail import TermAttribution
from ..._comparison.difference import Difference
from ..document import Column, Row, Section, Table
from ..pair_parts import contribution_rows, contribution_table
from ..wording import figures, residue

__all__ = ["contributions_section"]


def contributions_section(
    d: Difference, terms: TermAttribution | None, parameters: Attribution | None
) -> Section:
    """Contributions, terms of the equation of motion, and parameters.

    terms : None in a quick report;  parameters : with --by-parameter
    """
    tables = [contribution_table(d)]
    if terms is not None:
        tables.append(_term_table(d, terms))
    if parameters is not None:
        tables.append(_parameter_table(d, parameters))
    remainder = residue(float(np.abs(d.attribution.remainder).max()))
    closed = f"The contributions add up to the difference; the residual is {remainder} N m."
    lines = [closed]
    if d.attribution.cancels:
        lines.append("Contributions cancel: together they are much larger than the difference.")
    return Section("Attribution", tuple(lines), tuple(table for table in tables if table.rows))


def _term_table(d: Difference, terms: TermAttribution) -> Table:
    parts = (terms.gravity, terms.coriolis, terms.inertial)
    rms = np.array([np.sqrt((part.delta**2).mean(axis=0)) for part in parts])
    rows = (
        Row((joint.name, *(figures(float(value)) for value in rms[:, i])))
        for i, joint in enumerate(d.pair.a.joints)
    )
    return Table(
        (
            Column("joint"),
            *(Column(f"{name} [N m]", number=True) for name in ("gravity", "Coriolis", "inertial")),
        ),
        tuple(rows) if rms.any() else (),
        title="RMS of each term of the difference",
        note="Gravity: at rest. Coriolis: speeds alone. Inertial: accelerations alone.",
    )


def _parameter_table(d: Difference, parameters: Attribution) -> Table:
    rows, note = contribution_rows(d, parameters)
    return Table(
        (
            Column("parameter"),
            Column("weight [%]", number=True),
            Column("share [%]", number=True),
            Column("RMS [N m]", number=True),
            Column("most at joint"),
        ),
        rows,
        title="Parameter by parameter",
        note=f"In {d.pair.a.label}'s link frames, tensors about their origins. {note}",
    )
