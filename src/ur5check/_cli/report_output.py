"""The reports of one run: one on stdout, or several, in several formats, to stdout and files.

The suffix of a file of -o chooses its format.  Formats that --format names go to the files whose
suffix says nothing, in order; the rest goes to stdout.
"""

from __future__ import annotations

import argparse
import os
import shutil
import sys
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from .._errors import UsageError
from .._reports.report_formats import FORMATS, Contents, Target, format_named, format_of_file
from .output import check_output, emit

__all__ = ["add_report_options", "check_reports", "is_report", "report_targets", "write_reports"]

_PIPE_WIDTH = 100
_LEAST_WIDTH = 40


def add_report_options(parser: argparse.ArgumentParser, *, findings: bool = False) -> None:
    """--format, -o, --quiet.

    findings : for a command that judges files, which has formats of findings
    """
    parser.add_argument(
        "--format",
        dest="formats",
        action="append",
        choices=[form.name for form in FORMATS if findings or not form.of_findings],
        metavar="NAME",
        default=[],
        help="format on stdout, or of a -o without a known suffix, repeatable: %(choices)s "
        "(default: text)",
    )
    parser.add_argument(
        "-o",
        "--output",
        dest="outputs",
        action="append",
        metavar="FILE",
        default=[],
        help="write to this file instead, in the format of its suffix; repeatable",
    )
    parser.add_argument("--quiet", action="store_true", help="show no progress on stderr")
    parser.set_defaults(findings=findings)


def report_targets(args: argparse.Namespace) -> tuple[Target, ...]:
    """What is written where.

    Raises UsageError for a file whose format is not known, or that two reports would have.
    """
    named = [format_named(name) for name in args.formats]
    files = []
    for file in args.outputs:
        form = format_of_file(file)
        if form is None and named:
            form = named.pop(0)
        elif form is None and _is_device(file):
            form = FORMATS[0]
        if form is None:
            known = [form for form in FORMATS if args.findings or not form.of_findings]
            suffixes = ", ".join(form.suffixes[0] for form in known)
            raise UsageError(f"-o {file}: no format has this suffix; use {suffixes}, or --format")
        if form.of_findings and not args.findings:
            raise UsageError(f"-o {file}: {form.name} lists findings; only validate writes it")
        files.append(Target(form, file))
    paths = [Path(file).resolve() for file in args.outputs if not _is_device(file)]
    if len(set(paths)) < len(paths):
        raise UsageError("-o names one file twice; give each report a file of its own")
    shown = named or ([] if files else [FORMATS[0]])
    return (*(Target(form) for form in shown), *files)


def check_reports(args: argparse.Namespace, inputs: Iterable[Path] = ()) -> None:
    """Refuse, before any work, reports that cannot or must not be written.  Raises UsageError."""
    inputs = tuple(inputs)
    for file in args.outputs:
        check_output(file, inputs)
    report_targets(args)


def is_report(args: argparse.Namespace, file: str) -> bool:
    """Whether a report is to be written to this file."""
    return Path(file).resolve() in {Path(output).resolve() for output in args.outputs}


def write_reports(args: argparse.Namespace, contents: Contents) -> None:
    """Render and write all that is asked for.  Raises UsageError for what cannot be written."""
    interactive = sys.stdout.isatty()
    columns = shutil.get_terminal_size().columns if interactive else _PIPE_WIDTH
    width, colour = max(columns, _LEAST_WIDTH), _colour(interactive)
    targets = [
        replace(target, width=width, colour=colour) if target.file is None else target
        for target in report_targets(args)
    ]
    texts = [target.form.render(contents, target) for target in targets]
    for target, text in zip(targets, texts, strict=True):
        emit(text, target.file)


def _colour(interactive: bool) -> bool:
    """NO_COLOR and FORCE_COLOR count where they are not empty (no-color.org, force-color.org)."""
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return interactive and os.environ.get("TERM") != "dumb"


def _is_device(file: str) -> bool:
    path = Path(file)
    return path.exists() and not path.is_file() and not path.is_dir()
