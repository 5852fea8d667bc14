"""Identifiability: the inertial parameters that joint torques determine, alone or combined."""

from __future__ import annotations

from ..._comparison.explanation import Explanation
from ..._comparison.identifiability.identifiability import Identifiability, Label
from ..._robot.inertia import PARAMETERS
from ..document import Column, Row, Section, Table
from ..explanation_summary import doubt_in_words, equivalence_in_words
from ..wording import MISSING, figures, residue

__all__ = ["unseen_section"]

_LABELS: tuple[Label, ...] = ("identifiable", "in combination", "invisible")


def unseen_section(e: Explanation, *, written_out: bool) -> Section:
    """Rank, verdict, a row a link.

    written_out : whether each combination is shown too
    """
    seen = e.identifiability
    if seen.certain:
        certain = f"with certainty: the singular values have a gap of {seen.gap:.0e}"
    else:
        certain = f"without certainty: {doubt_in_words(seen)}"
    lines = (
        f"Joint torques determine {seen.rank} combinations of {e.difference.pair.a.label}'s "
        f"{seen.columns} inertial parameters, {certain}.",
        equivalence_in_words(e.equivalence),
    )
    tables = [_label_table(e)]
    if written_out:
        tables.append(_combination_table(e))
    return Section("Identifiability", lines, tuple(tables))


def _label_table(e: Explanation) -> Table:
    links = e.difference.pair.a.links
    rows = (
        Row((link.name, *(_names(e.identifiability, i, label) for label in _LABELS)))
        for i, link in enumerate(links)
    )
    return Table(
        (Column("link"), *(Column(label) for label in _LABELS)),
        tuple(rows),
        note="Parameters in link frames: first moments mx = m·x, tensors about the frame's origin.",
    )


def _names(seen: Identifiability, link: int, label: Label) -> str:
    labels = seen.labels[10 * link : 10 * link + 10]
    named = [name for name, own in zip(PARAMETERS, labels, strict=True) if own == label]
    return " ".join(named) or MISSING


def _combination_table(e: Explanation) -> Table:
    a, b = e.difference.pair.a, e.difference.pair.b
    values = e.identifiability.base_parameters(a.parameters())
    apart = e.equivalence.split.base
    rows = (
        Row((combination, figures(float(value)), residue(float(difference))))
        for combination, value, difference in zip(
            e.identifiability.combinations(), values, apart, strict=True
        )
    )
    return Table(
        (
            Column("combination"),
            Column(a.label, number=True),
            Column(f"less {b.label}'s", number=True),
        ),
        tuple(rows),
        title="Identifiable combinations",
        note="In kg, kg m and kg m². A parameter's number is its link's.",
    )
