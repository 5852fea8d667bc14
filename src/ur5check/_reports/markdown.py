"""A Document as Markdown, with GitHub's tables."""

from __future__ import annotations

import re
from urllib.parse import quote

from .document import Document, Row, Section, Table
from .provenance import Provenance

__all__ = ["as_cells", "escaped", "render_markdown"]


def render_markdown(document: Document) -> str:
    """The report as Markdown."""
    blocks = [f"# {escaped(document.title)}"]
    if document.verdict is not None:
        blocks.append(f"**{document.verdict.word}: {escaped(document.verdict.text)}**")
    if document.lines:
        blocks.append("\n".join(f"- {escaped(line)}" for line in document.lines))
    for section in document.sections:
        blocks.extend(_section(section))
    blocks.extend(_provenance(document.provenance))
    return "\n\n".join(blocks) + "\n"


def _section(section: Section) -> list[str]:
    blocks = [f"## {escaped(section.title)}", *map(escaped, section.lines)]
    for table in section.tables:
        if table.title:
            blocks.append(f"### {escaped(table.title)}")
        blocks.append(_table(table))
        if table.note:
            blocks.append(escaped(table.note))
    blocks += [f"![{escaped(p.says)}]({quote(p.path)})" for p in section.pictures]
    return blocks


def _table(table: Table) -> str:
    lines = [
        as_cells([escaped(column.title) for column in table.columns]),
        as_cells(["--:" if column.number else ":--" for column in table.columns]),
    ]
    return "\n".join([*lines, *(as_cells(_cells(row)) for row in table.rows)])


def _cells(row: Row) -> list[str]:
    cells = [escaped(" ".join(cell.split())) for cell in row.cells]
    return [f"**{cell}**" if cell else "" for cell in cells] if row.bad else cells


def as_cells(cells: list[str]) -> str:
    """One row of a table."""
    return f"| {' | '.join(cells)} |"


def escaped(text: str) -> str:
    """Text that Markdown shows as it stands: a file's names may hold any character."""
    return re.sub(r"([\\`*_|<>\[\]#])", r"\\\1", text.replace("&", "&amp;")).replace("\n", " ")


def _provenance(provenance: Provenance) -> list[str]:
    lines = [f"- versions: {escaped(provenance.made_by)}"]
    if provenance.samples is not None:
        lines.append(f"- {provenance.samples:,} states, drawn from seed {provenance.seed}")
    lines += [f"- read {escaped(name)}, SHA-256 `{digest}`" for name, digest in provenance.inputs]
    blocks = ["## How to repeat this report", "\n".join(lines)]
    if provenance.command:
        blocks.append(f"```sh\n{provenance.command}\n```")
    return blocks
