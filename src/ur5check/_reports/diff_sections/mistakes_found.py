"""What went wrong: the mistakes that were found, what repairing them does, and what is left."""

from __future__ import annotations

from ..._comparison.diagnosis.diagnosis import Diagnosis, Finding
from ..._comparison.difference_summary import listed
from ..._comparison.explanation import Explanation
from ..document import Column, Row, Section, Table
from ..explanation_summary import removed
from ..wording import MISSING, figures, residue

__all__ = ["findings_section"]

_NOTE = (
    "Removes: part of the whole RMS difference, repaired from the top. Tried: repaired values for "
    "each number; the more, the more could fit by chance."
)
_NO_TORQUE = f" {MISSING}: changes no torque, once the arms are laid together."


def findings_section(e: Explanation) -> Section:
    """The findings with their evidence, in words, link by link; then what nothing explains."""
    diagnosis = e.diagnosis
    lines = [] if diagnosis.findings else [_none(e)]
    # What changes no torque comes last; sorting keeps the order of repairing.
    numbered = list(enumerate(sorted(diagnosis.findings, key=_idle), 1))
    details = [row for k, f in numbered for row in _details(k, f)]
    tables = []
    if numbered:
        tables += [_evidence(e, numbered), _words(numbered)]
    if details:
        columns = (Column("", number=True), Column("link", number=True), Column("how"))
        tables.append(Table(columns, tuple(details), title="Link by link"))
    if diagnosis.unexplained:
        tables.append(_unexplained(diagnosis))
    return Section("What went wrong", tuple(lines), tuple(tables))


def _none(e: Explanation) -> str:
    if e.difference.agrees:
        return "Nothing: there is no difference to explain."
    return "No single known mistake explains the difference."


def _idle(finding: Finding) -> bool:
    return finding.before == finding.after


def _evidence(e: Explanation, numbered: list[tuple[int, Finding]]) -> Table:
    names = {"a": e.difference.pair.a.label, "b": e.difference.pair.b.label, None: "either"}
    return Table(
        (
            Column("", number=True),
            Column("mistake"),
            Column("in"),
            Column("links"),
            Column("removes", number=True),
            Column("RMS [N m]"),
            Column("tried", number=True),
        ),
        tuple(
            Row(
                (
                    str(number),
                    finding.id,
                    names[finding.side],
                    ", ".join(map(str, finding.links)) or "whole arm",
                    *_effect(finding, e.diagnosis),
                    str(finding.choices),
                )
            )
            for number, finding in numbered
        ),
        note=_NOTE + (_NO_TORQUE if any(_idle(f) for _, f in numbered) else ""),
    )


def _effect(finding: Finding, diagnosis: Diagnosis) -> tuple[str, str]:
    """(removes, before → after)."""
    if _idle(finding):
        return MISSING, MISSING
    removes = 100 * removed(finding, diagnosis)
    return f"{removes:.1f} %", f"{residue(finding.before)} → {residue(finding.after)}"


def _words(numbered: list[tuple[int, Finding]]) -> Table:
    return Table(
        (Column("", number=True), Column("what happened"), Column("to repair it")),
        tuple(Row((str(number), _in_words(f), f.advice)) for number, f in numbered),
        title="In words",
    )


def _in_words(finding: Finding) -> str:
    equals = f". Explained as well by: {listed(list(finding.equals))}" if finding.equals else ""
    return f"{finding.sentence}{equals}"


def _details(number: int, finding: Finding) -> list[Row]:
    rows = []
    shown = str(number)
    for link, detail in zip(finding.links, finding.details, strict=True):
        rows.append(Row((shown, str(link), detail.removeprefix(f"link {link}: "))))
        shown = ""
    return rows


def _unexplained(diagnosis: Diagnosis) -> Table:
    return Table(
        (
            Column("link", number=True),
            Column("number"),
            Column("apart [%]", number=True),
            Column("what is known of it"),
        ),
        tuple(
            Row((str(s.link + 1), s.quantity, figures(100 * s.gap), remark or MISSING))
            for s, remark in zip(diagnosis.unexplained, diagnosis.remarks, strict=True)
        ),
        title="Unexplained",
    )
