"""The known mistakes found, the effect of repairing them, and what remains unexplained."""

from __future__ import annotations

from ..._comparison.diagnosis.diagnosis import Diagnosis, RecognizedMistake
from ..._comparison.explanation import Explanation
from ..document import Column, Row, Section, Table
from ..explanation_summary import removed
from ..mistake_sentences import advice, details, remark, sentence
from ..wording import MISSING, figures, joined, residue

__all__ = ["findings_section"]

_NOTE = (
    "Removes: share of the RMS difference, repaired in the order of the rows. Tried: candidate "
    "values for each number; the more were tried, the likelier is a match by chance."
)
_NO_TORQUE = f" {MISSING}: changes no torque, once the arms are aligned."


def findings_section(e: Explanation) -> Section:
    """The mistakes: evidence, explanation, details of each link; then unexplained numbers."""
    diagnosis = e.diagnosis
    lines = [] if diagnosis.mistakes else [_none(e)]
    # What changes no torque comes last; sorting keeps the order of repairing.
    numbered = list(enumerate(sorted(diagnosis.mistakes, key=_idle), 1))
    by_link = [row for k, f in numbered for row in _details(k, f)]
    tables = []
    if numbered:
        tables += [_evidence(e, numbered), _words(e, numbered)]
    if by_link:
        columns = (Column("", number=True), Column("link", number=True), Column("how"))
        tables.append(Table(columns, tuple(by_link), title="Link by link"))
    if diagnosis.unexplained:
        tables.append(_unexplained(diagnosis))
    return Section("Mistakes found", tuple(lines), tuple(tables))


def _none(e: Explanation) -> str:
    if e.difference.same_torques:
        return "Nothing: there is no difference to explain."
    return "No single known mistake explains the difference."


def _idle(found: RecognizedMistake) -> bool:
    return found.before == found.after


def _evidence(e: Explanation, numbered: list[tuple[int, RecognizedMistake]]) -> Table:
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
                    found.id,
                    names[found.side],
                    ", ".join(map(str, found.links)) or "whole arm",
                    *_effect(found, e.diagnosis),
                    str(found.choices),
                )
            )
            for number, found in numbered
        ),
        note=_NOTE + (_NO_TORQUE if any(_idle(f) for _, f in numbered) else ""),
    )


def _effect(found: RecognizedMistake, diagnosis: Diagnosis) -> tuple[str, str]:
    """(removes, before → after)."""
    if _idle(found):
        return MISSING, MISSING
    removes = 100 * removed(found, diagnosis)
    return f"{removes:.1f} %", f"{residue(found.before)} → {residue(found.after)}"


def _words(e: Explanation, numbered: list[tuple[int, RecognizedMistake]]) -> Table:
    return Table(
        (Column("", number=True), Column("explanation"), Column("repair")),
        tuple(Row((str(number), _in_words(f, e.diagnosis), advice(f))) for number, f in numbered),
        title="Explanation and repair",
    )


def _in_words(found: RecognizedMistake, diagnosis: Diagnosis) -> str:
    equals = f". Explained as well by: {joined(found.equals)}" if found.equals else ""
    return f"{sentence(found, diagnosis.pair)}{equals}"


def _details(number: int, found: RecognizedMistake) -> list[Row]:
    rows = []
    shown = str(number)
    for link, detail in zip(found.links, details(found), strict=found.difference is None):
        rows.append(Row((shown, str(link), detail.removeprefix(f"link {link}: "))))
        shown = ""
    return rows


def _unexplained(diagnosis: Diagnosis) -> Table:
    return Table(
        (
            Column("link", number=True),
            Column("number"),
            Column("difference [%]", number=True),
            Column("remark"),
        ),
        tuple(
            Row((str(m.link + 1), m.quantity, figures(100 * m.gap), remark(m, diagnosis)))
            for m in diagnosis.unexplained
        ),
        title="Unexplained",
    )
