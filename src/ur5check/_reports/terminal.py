"""A Document as text for a terminal, a pipe or a file.

Colour repeats what the words say already; without it nothing is lost.
"""

from __future__ import annotations

import io
import textwrap
import unicodedata

from rich import box
from rich.cells import cell_len
from rich.console import Console
from rich.table import Table as RichTable
from rich.text import Text

from .document import Column, Document, Section, Table
from .provenance import Provenance

__all__ = ["render_text"]

# Enough to compare by eye; Markdown and JSON have all 64 digits.
_HASH_DIGITS = 16
_GAP = 2  # between columns; rich draws one blank of it itself, where other boxes have a line
_NARROWEST_TEXT = 14
_NARROWEST_HEADER = 9


def render_text(document: Document, *, width: int = 100, colour: bool = False) -> str:
    """The report in lines of at most `width`, wider only where a table's numbers need it."""
    console = Console(
        file=io.StringIO(),
        width=width,
        force_terminal=colour,
        color_system="standard" if colour else None,
        highlight=False,
        markup=False,
        emoji=False,
        legacy_windows=False,
    )
    with console.capture() as capture:
        console.print(Text(_clean(document.title), "bold"))
        if document.verdict is not None:
            style = "bold green" if document.verdict.good else "bold red"
            text = f"{document.verdict.word}: {document.verdict.text}"
            console.print()
            _say(console, text, style=style)
        if document.lines:
            console.print()
            for line in document.lines:
                _say(console, line, bullet="· ")
        for section in document.sections:
            _section(console, section)
        _provenance(console, document.provenance)
    lines = (line.rstrip() for line in capture.get().splitlines())
    return "\n".join(lines) + "\n"


def _say(console: Console, text: str, bullet: str = "", style: str = "") -> None:
    """A paragraph, with its further lines under its first word."""
    wrapped = textwrap.fill(
        _clean(text),
        console.width,
        initial_indent=bullet,
        subsequent_indent=" " * len(bullet),
        break_long_words=False,
        break_on_hyphens=False,
    )
    console.print(Text(wrapped, style), no_wrap=True, crop=False, overflow="ignore")


def _section(console: Console, section: Section) -> None:
    console.print()
    line = "─" * max(3, console.width - cell_len(section.title) - 4)
    console.print(Text.assemble("── ", (section.title, "bold"), f" {line}"[: console.width]))
    for text in section.lines:
        _say(console, text)
    for table in section.tables:
        console.print()
        if table.title:
            _say(console, table.title, style="bold")
        shown, given = _table(table), console.width
        console.width = max(given, _least_width(shown))  # rather a long line than half a number
        console.print(shown)
        console.width = given
        if table.note:
            _say(console, table.note, style="dim")
    if section.pictures:
        console.print()
    for picture in section.pictures:
        _say(console, f"picture: {picture.path}: {picture.says}", style="dim")


def _table(table: Table) -> RichTable:
    shown = RichTable(
        box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False, padding=(0, _GAP - 1, 0, 0)
    )
    columns = []
    for i, column in enumerate(table.columns):
        cells = [_clean(row.cells[i]) for row in table.rows]
        columns.append(_add_column(shown, column, cells))
    for k, row in enumerate(table.rows):
        shown.add_row(*(Text(cells[k], "bold red" if row.bad else "") for cells in columns))
    return shown


def _add_column(shown: RichTable, column: Column, cells: list[str]) -> list[str]:
    """The column's cells as they are to be set."""
    if not column.number:
        widest = min(max(map(cell_len, cells), default=0), _NARROWEST_TEXT)
        shown.add_column(Text(_clean(column.title)), overflow="fold", min_width=widest)
        return cells
    cells = _on_the_point(cells)
    words, bracket, unit = _clean(column.title).partition(" [")
    lines = textwrap.wrap(words, max(_NARROWEST_HEADER, *map(cell_len, cells)))
    if bracket:
        lines.append(f"[{unit}")
    # rich takes the blanks from the end of what it sets to the right: everything is padded here.
    width = max(map(cell_len, [*lines, *cells]))
    shown.add_column(Text("\n".join(line.rjust(width) for line in lines)), no_wrap=True)
    return [cell.rjust(width) for cell in cells]


def _least_width(shown: RichTable) -> int:
    """What the numbers need, and the text at its narrowest."""
    width = 0
    for column in shown.columns:
        lines = [line for cell in (column.header, *column.cells) for line in str(cell).splitlines()]
        widest = max(map(cell_len, lines), default=0)
        width += _GAP + (widest if column.no_wrap else min(widest, _NARROWEST_TEXT))
    return width


def _on_the_point(cells: list[str]) -> list[str]:
    """Numbers padded behind, so that set to the right their points stand under each other."""
    tails = [len(cell) - cell.index(".") if "." in cell else 0 for cell in cells]
    return [cell + " " * (max(tails) - tail) for cell, tail in zip(cells, tails, strict=True)]


def _clean(text: str) -> str:
    """A name out of a file may hold what would steer a terminal."""
    steering = ("Cc", "Cf", "Cs")
    return "".join("\ufffd" if unicodedata.category(c) in steering else c for c in text)


def _provenance(console: Console, provenance: Provenance) -> None:
    console.print()
    console.print(Text("─" * console.width))
    if provenance.command:
        _say(console, f"command: {provenance.command}", style="dim")
    _say(console, f"versions: {provenance.made_by}", style="dim")
    if provenance.samples is not None:
        said = f"states: {provenance.samples:,}, drawn from seed {provenance.seed}"
        _say(console, said, style="dim")
    for name, digest in provenance.inputs:
        _say(console, f"read: sha256 {digest[:_HASH_DIGITS]}…  {name}", style="dim")
