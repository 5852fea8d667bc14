"""The formats of a report: the one list that `--format`, `-o` and help read.

To add a format, add its record here; its renderer takes a document, the typed JSON report, or the
findings of `validate`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    from .._validation.configuration import Configuration
    from .._validation.verdict import VerdictSet
    from .document import Document
    from .json_report import Report

__all__ = ["FORMATS", "Contents", "ReportFormat", "Target", "format_named", "format_of_file"]


@dataclass(frozen=True)
class Contents:
    """What a report can be rendered from; each is made when a format needs it.

    text : the report as text, of a command that does not show its document
    verdicts, configuration : of a command that judges files;  command : that made the report
    """

    document: Callable[[Target], Document]
    report: Callable[[], Report]
    text: Callable[[Target], str] | None = None
    verdicts: VerdictSet | None = None
    configuration: Configuration | None = None
    command: str = ""

    @classmethod
    def of_text(cls, text: str) -> Contents:
        """Of a report that is wanted as text only."""

        def none(*_: object) -> NoReturn:
            raise AssertionError("only text is asked for")

        return cls(none, none, lambda target: text)


@dataclass(frozen=True)
class ReportFormat:
    """A format of reports.

    name : as `--format` has it;  suffixes : of files that `-o` writes in it
    render : makes the report's text
    all_tables : whether a report in it has also the tables that are too long for a terminal
    of_findings : whether it says findings only, so that `validate` alone writes it
    """

    name: str
    suffixes: tuple[str, ...]
    render: Callable[[Contents, Target], str]
    all_tables: bool = False
    of_findings: bool = False


@dataclass(frozen=True)
class Target:
    """One report that is asked for.

    file : None for stdout;  width : of its lines, in columns
    """

    form: ReportFormat
    file: str | None = None
    width: int = 100
    colour: bool = False


def _text(contents: Contents, target: Target) -> str:
    if contents.text is not None:
        return contents.text(target)
    from .terminal import render_text

    return render_text(contents.document(target), width=target.width, colour=target.colour)


def _json(contents: Contents, target: Target) -> str:
    from .json_report import json_text

    return json_text(contents.report())


def _markdown(contents: Contents, target: Target) -> str:
    from .markdown import render_markdown

    return render_markdown(contents.document(target))


def _sarif(contents: Contents, target: Target) -> str:
    from .sarif import render_sarif

    return render_sarif(_verdicts(contents), command=contents.command)


def _junit(contents: Contents, target: Target) -> str:
    from .._validation.configuration import Configuration
    from .junit import render_junit

    return render_junit(_verdicts(contents), contents.configuration or Configuration())


def _github(contents: Contents, target: Target) -> str:
    from .github_annotations import render_annotations

    return render_annotations(_verdicts(contents))


def _summary(contents: Contents, target: Target) -> str:
    from .pull_request_summary import render_summary

    return render_summary(_verdicts(contents))


def _json_lines(contents: Contents, target: Target) -> str:
    from .verdict_json import json_lines

    return json_lines(_verdicts(contents))


def _verdicts(contents: Contents) -> VerdictSet:
    if contents.verdicts is None:
        raise ValueError("a command without findings offers no format of findings")
    return contents.verdicts


#: All formats; the first is that of stdout.
FORMATS = (
    ReportFormat("text", (".txt",), _text),
    ReportFormat("json", (".json",), _json),
    ReportFormat("markdown", (".md", ".markdown"), _markdown, all_tables=True),
    ReportFormat("sarif", (".sarif", ".sarif.json"), _sarif, of_findings=True),
    ReportFormat("junit", (".xml",), _junit, of_findings=True),
    ReportFormat("github", (".annotations",), _github, of_findings=True),
    ReportFormat("summary", (".summary.md",), _summary, of_findings=True),
    ReportFormat("jsonl", (".jsonl",), _json_lines, of_findings=True),
)


def format_named(name: str) -> ReportFormat:
    """The format of that name."""
    return next(form for form in FORMATS if form.name == name)


def format_of_file(file: str) -> ReportFormat | None:
    """The format that the longest fitting suffix of a file's name stands for, None without one."""
    fitting = [
        (len(suffix), form)
        for form in FORMATS
        for suffix in form.suffixes
        if file.lower().endswith(suffix)
    ]
    return max(fitting, key=lambda entry: entry[0])[1] if fitting else None
