"""What else differs: gravity, mass, tool, damping, friction, motors and limits."""

from __future__ import annotations

import numpy as np

from ..._comparison.difference import Difference
from ..._comparison.other_numbers import OtherNumber
from ..._finding import Place
from ..document import Column, Row, Table
from ..wording import MISSING, coordinates, figures

__all__ = ["others_table"]


def others_table(d: Difference) -> Table:
    """Each number with its values and places in both models."""
    return Table(
        (
            Column("joint"),
            Column("quantity"),
            Column(d.pair.a.label, number=True),
            Column(d.pair.b.label, number=True),
            Column("written at"),
        ),
        tuple(_row(other) for other in d.others),
        title=f"What else differs, in the joint coordinates and base frame of {d.pair.a.label}",
    )


def _row(other: OtherNumber) -> Row:
    places = (other.place_a, other.place_b)
    where = " / ".join(_line(place) for place in places) if any(map(str, places)) else MISSING
    quantity = f"{other.quantity} [{other.unit}]"
    return Row((other.joint or MISSING, quantity, _value(other.a), _value(other.b), where))


def _line(place: Place) -> str:
    return str(place) or MISSING


def _value(value: float | tuple[float, ...] | None) -> str:
    return coordinates(np.array(value)) if isinstance(value, tuple) else figures(value)
