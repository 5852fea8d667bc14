"""Alignment of the arms, the parameters that differ, and the torque difference."""

from __future__ import annotations

import numpy as np

from ..._comparison.alignment import SAME_LENGTH
from ..._comparison.difference import Difference
from ..._comparison.parameter_table import LinkParameters
from ..document import Column, Row, Section, Table
from ..pair_parts import alignment_lines, torque_table
from ..wording import coordinates, figures, link_label
from .other_numbers import others_table

__all__ = ["numbers_section"]

# Two numbers of a body agree if they differ by less than a millionth of its size: fewer digits than
# any table or file carries.
_SAME_PART = 1e-6


def numbers_section(d: Difference) -> Section:
    """Alignment, geometry where axes differ, the numbers that differ, torques joint by joint."""
    geometry = () if d.pair.alignment.exact else (_axis_table(d), _reach_table(d))
    said, bodies = _bodies(d)
    tables = (
        table for table in (*geometry, bodies, others_table(d), torque_table(d)) if table.rows
    )
    states = f"{len(d.states):,} random states; torques of speeds and accelerations included."
    return Section("The numbers", (*alignment_lines(d), said, states), tuple(tables))


def _axis_table(d: Difference) -> Table:
    alignment = d.pair.alignment
    return Table(
        (
            Column("joint"),
            Column("angle between axes [rad]", number=True),
            Column("distance [mm]", number=True),
        ),
        tuple(
            Row((joint.name, figures(angle), figures(1e3 * distance)))
            for joint, angle, distance in zip(
                d.pair.a.joints, alignment.axis_angle, alignment.axis_distance, strict=True
            )
        ),
        title="Angle and distance between corresponding axes at q = 0",
    )


def _reach_table(d: Difference) -> Table:
    return Table(
        (
            Column("link"),
            Column(f"{d.pair.a.label} [mm]"),
            Column(f"{d.pair.b.label} [mm]"),
        ),
        tuple(
            Row(
                (
                    link_label(link.name_a, link.name_b),
                    coordinates(link.reach_a, 1e-3),
                    coordinates(link.reach_b, 1e-3),
                )
            )
            for link in d.parameters
            if float(np.abs(link.reach_a - link.reach_b).max()) > SAME_LENGTH
        ),
        title="Vectors from joint to tip frame that differ",
    )


def _bodies(d: Difference) -> tuple[str, Table]:
    """How many numbers agree; the rows that differ, a link's name in its first."""
    rows: list[Row] = []
    count = 0
    for link in d.parameters:
        label = link_label(link.name_a, link.name_b)
        for quantity, unit, a, b in _differing(link):
            shown = (f"{quantity} [{unit}]", figures(a), figures(b), _relative(a, b))
            rows.append(Row((label, *shown)))
            label = ""
        count += len(link.rows())
    said = (
        f"{count - len(rows)} of {count} masses, centres and tensor entries agree to a millionth "
        "of the body's size."
    )
    columns = (
        Column("link"),
        Column("quantity"),
        Column(d.pair.a.label, number=True),
        Column(d.pair.b.label, number=True),
        Column("change [%]", number=True),
    )
    frames = f"in the frames of {d.pair.a.label}'s own file, tensors about the centre of mass"
    return said, Table(columns, tuple(rows), title=f"Numbers that differ, {frames}")


def _differing(link: LinkParameters) -> list[tuple[str, str, float, float]]:
    largest = max(np.abs(link.a.tensor).max(), np.abs(link.b.tensor).max())
    same = {
        "kg": _SAME_PART * max(abs(link.a.mass), abs(link.b.mass)),
        "m": SAME_LENGTH,
        "kg m²": _SAME_PART * float(largest),
    }
    return [row for row in link.rows() if abs(row[2] - row[3]) > same[row[1]]]


def _relative(a: float, b: float) -> str:
    # A change from zero has no percentage.
    return "from 0" if a == 0.0 else figures(100.0 * (b - a) / abs(a))
