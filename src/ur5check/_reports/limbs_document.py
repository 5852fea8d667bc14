"""Two robots with several chains: a table of their limbs, or one line each on a screen."""

from __future__ import annotations

import textwrap

from .._comparison.limb_comparison import LimbComparison, LimbPair
from .diff_document import diff_document
from .difference_summary import summarize
from .document import Column, Document, Row, Section, Table, Verdict
from .provenance import Provenance
from .wording import MISSING, figures

__all__ = ["limbs_document", "limbs_text", "limbs_verdict"]

_LINES, _WIDTH, _NAME = 24, 80, 34


def limbs_verdict(c: LimbComparison) -> str:
    """How many limbs agree."""
    same = sum(limb.agrees for limb in c.limbs)
    return f"{c.a.robot.file} and {c.b.robot.file}: {same} of {len(c.limbs)} limbs agree."


def limbs_text(c: LimbComparison) -> str:
    """At most 24 lines of 80 columns; limbs that differ first."""
    word = "AGREE" if c.agrees else "DIFFER"
    head = textwrap.wrap(f"{word}  {limbs_verdict(c)}", _WIDTH, subsequent_indent="        ")[:4]
    rows = [f"{'':8}{'limb':{_NAME}}{'joints':>7}{'Δτ [N m]':>11}  at joint"]
    limbs = sorted(c.limbs, key=lambda limb: limb.agrees)
    left = _LINES - len(head) - 2
    for limb in limbs[: left if len(limbs) <= left else left - 1]:
        word, name, joints, torque, where = _cells(limb)
        name = name if len(name) < _NAME else f"{name[: _NAME - 2]}…"
        numbers = f"{joints:>7}{torque:>11}" if limb.difference is not None else ""
        rows.append(f"{word:8}{name:{_NAME}}{numbers}  {where}".rstrip()[:_WIDTH])
    if len(limbs) > left:
        rows.append(f"{'':8}… {len(limbs) - left + 1} more limbs (--full)")
    foot = "--full shows each; --tip-a LINK --tip-b LINK explains one"
    return "\n".join([*head, *rows, foot]) + "\n"


def limbs_document(c: LimbComparison, *, command: str = "") -> Document:
    """The table, and the report of each limb that differs."""
    columns = (
        Column("verdict"),
        Column("limb"),
        Column("joints", number=True),
        Column("Δτ [N m]", number=True),
        Column("at joint"),
    )
    rows = tuple(Row(_cells(limb), bad=not limb.agrees) for limb in c.limbs)
    sections = [Section("Limbs", (), (Table(columns, rows),))]
    for limb in c.limbs:
        if limb.difference is not None and not limb.agrees:
            lines = summarize(limb.difference)
            tables = [t for s in diff_document(limb.difference).sections for t in s.tables]
            sections.append(Section(_name(limb), lines, tuple(tables)))
    first = next((limb.difference for limb in c.limbs if limb.difference is not None), None)
    inputs = tuple(dict.fromkeys((*c.a.robot.inputs, *c.b.robot.inputs)))
    seed, samples = (None, None) if first is None else (first.seed, len(first.states))
    return Document(
        f"{c.a.robot.file} against {c.b.robot.file}",
        Verdict("AGREE" if c.agrees else "DIFFER", limbs_verdict(c), c.agrees),
        (),
        tuple(sections),
        Provenance(inputs, seed, samples, command),
    )


def _name(limb: LimbPair) -> str:
    return " / ".join(dict.fromkeys(name for name in (limb.a, limb.b) if name))


def _cells(limb: LimbPair) -> tuple[str, str, str, str, str]:
    d = limb.difference
    word = "AGREE" if limb.agrees else "DIFFER"
    if d is None:
        return word, _name(limb), MISSING, MISSING, limb.problem
    worst = int(d.torques.maximum.argmax())
    where = "" if d.same_torques else d.pair.a.joints[worst].name
    if d.same_torques and not limb.agrees:
        others = [other.quantity for other in d.others if other.moves_joints]
        faults = [fault.rule for found in d.faults.values() for fault in found]
        where = ", ".join(dict.fromkeys((*others, *faults)))
    return word, _name(limb), str(d.pair.a.n), figures(float(d.torques.maximum[worst])), where
