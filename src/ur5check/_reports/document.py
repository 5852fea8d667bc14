"""A report before it is rendered: a small tree of text and tables.

    Document ── verdict, main results
             ├─ Section ── lines
             │          ├─ Table ── columns, rows of text
             │          └─ Picture ── a file that was drawn beside the report
             └─ Provenance

A renderer (`terminal`, `markdown`) shows any Document; what is in one is decided in
`validate_document`, `diff_document` and `show_document`.  All numbers are text by then.
"""

from __future__ import annotations

from dataclasses import dataclass

from .provenance import Provenance

__all__ = ["Column", "Document", "Picture", "Row", "Section", "Table", "Verdict"]


@dataclass(frozen=True)
class Column:
    """A column of a table.

    title : with the unit, if all its numbers share one ("RMS [N m]")
    number : its cells are set on their decimal points and never broken into lines
    """

    title: str
    number: bool = False


@dataclass(frozen=True)
class Row:
    """One row; `bad` if it is about something that failed."""

    cells: tuple[str, ...]
    bad: bool = False


@dataclass(frozen=True)
class Table:
    """Rows under columns.

    title : above it;  note : below it, how to read it
    """

    columns: tuple[Column, ...]
    rows: tuple[Row, ...]
    title: str = ""
    note: str = ""

    def __post_init__(self) -> None:
        for row in self.rows:
            if len(row.cells) != len(self.columns):
                raise ValueError(f"{len(row.cells)} cells under {len(self.columns)} columns")


@dataclass(frozen=True)
class Picture:
    """A drawn file.

    path : as seen from where the report is;  says : what there is to see in it
    """

    path: str
    says: str


@dataclass(frozen=True)
class Section:
    """A heading with what belongs under it."""

    title: str
    lines: tuple[str, ...] = ()
    tables: tuple[Table, ...] = ()
    pictures: tuple[Picture, ...] = ()


@dataclass(frozen=True)
class Verdict:
    """The result in one word and one sentence.

    word : PASS, FAIL, AGREE, DIFFER, …;  text : a sentence;  good : whether the exit code is 0
    """

    word: str
    text: str
    good: bool


@dataclass(frozen=True)
class Document:
    """A whole report.

    lines : main results, one sentence each
    """

    title: str
    verdict: Verdict | None
    lines: tuple[str, ...]
    sections: tuple[Section, ...]
    provenance: Provenance
