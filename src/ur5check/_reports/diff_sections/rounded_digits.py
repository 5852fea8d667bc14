"""Digits: what rounded constants and the last printed digits cost in torque."""

from __future__ import annotations

from ..._comparison.explanation import Explanation
from ..._comparison.rounding.error_budget import BudgetItem
from ..document import Column, Row, Section, Table
from ..rounding_sentences import cause_in_words, places_in_words
from ..wording import figures, residue

__all__ = ["digits_section"]


def digits_section(e: Explanation) -> Section:
    """A row for each kind of digits, and the remainder that they do not explain."""
    budget, joints = e.budget, e.difference.pair.a.joints
    names = {"a": e.difference.pair.a.label, "b": e.difference.pair.b.label}
    worst = int(budget.remainder.argmax())
    if e.difference.rounding_explains:
        said = "Rounded digits explain the difference."
    elif e.difference.same_torques:
        said = "There is no difference to explain."
    elif budget.digits_suffice:
        said = "Rounded numbers alone explain the difference."
    else:
        said = (
            f"Rounded numbers explain up to {residue(float(budget.explained.max()))} N m RMS; "
            f"{figures(float(budget.remainder[worst]))} N m of "
            f"{figures(float(budget.total[worst]))} N m RMS remain at joint {worst + 1} "
            f"({joints[worst].name})."
        )
    table = Table(
        (
            Column("cause"),
            Column("in"),
            Column("where"),
            Column(""),
            Column("RMS [N m]", number=True),
            Column("max [N m]", number=True),
        ),
        tuple(_row(item, names[item.side]) for item in budget.items),
        note="At the joint with the largest effect. Recomputed: with the exact number. Bound: the "
        "most that the last printed digit of every number can change.",
    )
    return Section("Rounding", (said,), (table,) if table.rows else ())


def _row(item: BudgetItem, name: str) -> Row:
    return Row(
        (
            cause_in_words(item),
            name,
            places_in_words(item),
            "recomputed" if item.exact else "bound",
            residue(float(item.rms.max())),
            residue(float(item.maximum.max())),
        )
    )
