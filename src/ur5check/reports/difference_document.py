"""What `diff` shows."""

from __future__ import annotations

import numpy as np

from ..comparison.alignment import SAME_LENGTH
from ..comparison.difference import Difference
from ..comparison.parameters import LinkParameters
from ..comparison.story import tell
from .document import Column, Document, Row, Section, Table, Verdict
from .pair_parts import alignment_lines, owner_table, torque_table
from .provenance import Provenance, inputs_of
from .wording import coordinates, figures, link_label

__all__ = ["difference_document"]

# Two numbers of a body agree if they differ by less than a millionth of its size: fewer digits than
# any table or file carries.
_SAME_PART = 1e-6


def difference_document(d: Difference, *, command: str = "") -> Document:
    """The report of `ur5check diff`."""
    verdict, *lines = tell(d)
    a, b = d.pair.a, d.pair.given_b
    return Document(
        f"{a.name} against {b.name}",
        Verdict("AGREE" if d.agrees else "DIFFER", verdict, d.agrees),
        tuple(lines),
        (_kinematics(d), _bodies(d), _torques(d)),
        Provenance(inputs_of((a, b)), d.seed, len(d.states), command),
    )


def _kinematics(d: Difference) -> Section:
    tables = []
    if not d.pair.alignment.exact:
        tables = [table for table in (_axis_table(d), _reach_table(d)) if table.rows]
    return Section("Kinematics", alignment_lines(d), tuple(tables))


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
        title="What is left between the axes at q = 0",
    )


def _reach_table(d: Difference) -> Table:
    return Table(
        (
            Column("link"),
            Column(f"{d.pair.a.name} [mm]"),
            Column(f"{d.pair.b.name} [mm]"),
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
        title="From joint to far end, where they differ",
    )


def _bodies(d: Difference) -> Section:
    """The rows that differ; a link's name stands in its first."""
    rows: list[Row] = []
    count = 0
    for link in d.parameters:
        label = link_label(link.name_a, link.name_b)
        for quantity, unit, a, b in _differing(link):
            shown = (f"{quantity} [{unit}]", figures(a), figures(b), _relative(a, b))
            rows.append(Row((label, *shown)))
            label = ""
        count += len(link.rows())
    said = f"{count - len(rows)} of {count} numbers agree to a millionth of the body's size"
    if not rows:
        return Section("Masses, centres, tensors", (f"{said}.",))
    table = Table(
        (
            Column("link"),
            Column("quantity"),
            Column(d.pair.a.name, number=True),
            Column(d.pair.b.name, number=True),
            Column("change [%]", number=True),
        ),
        tuple(rows),
    )
    frames = f"in the frames of {d.pair.a.name}'s own file, tensors about the centre of mass"
    return Section("Masses, centres, tensors", (f"{said}; the others, {frames}:",), (table,))


def _differing(link: LinkParameters) -> list[tuple[str, str, float, float]]:
    largest = max(np.abs(link.a.tensor).max(), np.abs(link.b.tensor).max())
    same = {
        "kg": _SAME_PART * max(abs(link.a.mass), abs(link.b.mass)),
        "m": SAME_LENGTH,
        "kg m²": _SAME_PART * float(largest),
    }
    return [row for row in link.rows() if abs(row[2] - row[3]) > same[row[1]]]


def _relative(a: float, b: float) -> str:
    # A change from zero has no size that a percentage could tell.
    return "from 0" if a == 0.0 else figures(100.0 * (b - a) / abs(a))


def _torques(d: Difference) -> Section:
    said = f"{len(d.states):,} random states; torques of speeds and accelerations included."
    remainder = figures(float(np.abs(d.attribution.remainder).max()))
    closed = f"The owners' parts add up to the difference within {remainder} N m."
    owners = owner_table(d)
    tables = (torque_table(d), owners) if owners.rows else (torque_table(d),)
    return Section("Torques", (said, closed), tables)
