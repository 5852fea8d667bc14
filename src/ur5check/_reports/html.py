"""A document as HTML, for a notebook: no styles of its own, everything escaped."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

from .document import Document, Section, Table

__all__ = ["render_html"]


def render_html(document: Document) -> str:
    """The whole document; sections are folded, their titles show."""
    verdict = document.verdict
    head = [] if verdict is None else [f"<b>{escape(verdict.word)}</b> {escape(verdict.text)}"]
    return "\n".join(
        [
            "<div>",
            *_paragraphs([f"<b>{escape(document.title)}</b>", *head]),
            *_paragraphs(escape(line) for line in document.lines),
            *(line for section in document.sections for line in _section(section)),
            "</div>",
        ]
    )


def _paragraphs(lines: Iterable[str]) -> list[str]:
    return [f"<p>{line}</p>" for line in lines]


def _section(section: Section) -> list[str]:
    return [
        f"<details><summary>{escape(section.title)}</summary>",
        *_paragraphs(escape(line) for line in section.lines),
        *(line for table in section.tables for line in _table(table)),
        "</details>",
    ]


def _table(table: Table) -> list[str]:
    lines = ["<table>"]
    if table.title:
        lines.append(f"<caption>{escape(table.title)}</caption>")
    lines.append(_row([column.title for column in table.columns], "th"))
    lines += [_row(row.cells, "td") for row in table.rows]
    return [*lines, "</table>", *_paragraphs([escape(table.note)] if table.note else [])]


def _row(cells: Iterable[str], tag: str) -> str:
    return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"
