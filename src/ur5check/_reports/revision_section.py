"""What a commit changes beside the torques, for the report of `diff --against-git`."""

from __future__ import annotations

from dataclasses import replace

from .._finding import Finding
from .._validation.revision_change import RevisionChange
from .document import Column, Document, Row, Section, Table
from .wording import figures

__all__ = ["change_in_words", "with_change"]


def with_change(document: Document, change: RevisionChange) -> Document:
    """The report with the changes of mass and findings."""
    lines, section = change_in_words(change), _section(change)
    return replace(
        document,
        lines=(*document.lines, *lines),
        sections=(*([section] if section.tables else []), *document.sections),
    )


def change_in_words(change: RevisionChange) -> tuple[str, str]:
    """Mass, and how many findings came and went."""
    before, after = change.masses
    mass = (
        f"Mass of the robot: {figures(before)} kg at {change.revision}, {figures(after)} kg now."
        if before != after
        else f"The mass of the robot is the same, {figures(after)} kg."
    )
    new, gone = len(change.new), len(change.gone)
    return mass, f"Findings: {new} new, {gone} gone since {change.revision}."


def _section(change: RevisionChange) -> Section:
    rows = [*(_row("new", f) for f in change.new), *(_row("gone", f) for f in change.gone)]
    columns = tuple(
        Column(title) for title in ("", "severity", "rule", "place", "subject", "finding")
    )
    return Section(
        f"Findings since {change.revision}", tables=(Table(columns, tuple(rows)),) if rows else ()
    )


def _row(word: str, f: Finding) -> Row:
    cells = (word, f.severity, f.rule, str(f.place), f.subject, f.message)
    return Row(cells, bad=word == "new" and f.severity == "error")
