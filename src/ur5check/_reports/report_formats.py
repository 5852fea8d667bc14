"""The formats of a report: the one list that `--format`, `-o` and help read.

To add a format, add its record here; its renderer takes a document, or the typed JSON report.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .document import Document
    from .json_report import Report

__all__ = ["FORMATS", "Contents", "ReportFormat", "Screen", "format_of"]


@dataclass(frozen=True)
class Contents:
    """What a report can be rendered from; each is made when a format needs it."""

    document: Callable[[], Document]
    report: Callable[[], Report]


@dataclass(frozen=True)
class Screen:
    """Where a report is shown: its width in columns, and whether in colour."""

    width: int = 100
    colour: bool = False


@dataclass(frozen=True)
class ReportFormat:
    """A format of reports.

    name : as `--format` has it;  suffixes : of files that `-o` writes in it
    render : makes the report's text
    all_tables : whether a report in it has also the tables that are too long for a terminal
    """

    name: str
    suffixes: tuple[str, ...]
    render: Callable[[Contents, Screen], str]
    all_tables: bool = False


def _text(contents: Contents, screen: Screen) -> str:
    from .terminal import render_text

    return render_text(contents.document(), width=screen.width, colour=screen.colour)


def _json(contents: Contents, screen: Screen) -> str:
    from .json_report import json_text

    return json_text(contents.report())


def _markdown(contents: Contents, screen: Screen) -> str:
    from .markdown import render_markdown

    return render_markdown(contents.document())


#: All formats; the first is that of stdout and of files with other suffixes.
FORMATS = (
    ReportFormat("text", (".txt",), _text),
    ReportFormat("json", (".json",), _json),
    ReportFormat("markdown", (".md", ".markdown"), _markdown, all_tables=True),
)


def format_of(name: str | None, file: str | None) -> ReportFormat:
    """The format of that name; without a name, the one that the file's suffix stands for."""
    if name is not None:
        return next(form for form in FORMATS if form.name == name)
    suffix = PurePath(file or "").suffix.lower()
    return next((form for form in FORMATS if suffix in form.suffixes), FORMATS[0])
