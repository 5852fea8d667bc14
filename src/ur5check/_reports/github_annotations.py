"""Findings as workflow commands of GitHub Actions, which annotate the lines of a pull request.

The format: https://docs.github.com/actions/reference/workflow-commands-for-github-actions.  GitHub
shows ten errors and ten warnings of a step, so that the worst findings of all files come first.
"""

from __future__ import annotations

from .._finding import SEVERITIES, Finding
from .._validation.verdict import VerdictSet
from .file_places import first_place
from .verdict_summary import failed_laws

__all__ = ["render_annotations"]

_COMMANDS = {"error": "error", "warning": "warning", "note": "notice"}


def render_annotations(verdicts: VerdictSet) -> str:
    """One line a finding that counts."""
    found = [(f, v.judgement.file) for v in verdicts.models for f in v.findings.open]
    found += [(f, pair.file) for pair in verdicts.pairs for f in pair.findings.open]
    found.sort(key=lambda entry: SEVERITIES.index(entry[0].severity))  # stable: files in order
    lines = [_line("error", {"file": file}, text) for file, text in failed_laws(verdicts)]
    lines += [_annotation(finding, file) for finding, file in found]
    return "".join(f"{line}\n" for line in lines)


def _annotation(f: Finding, file: str) -> str:
    place = first_place(f, file)
    properties = {"file": place.file}
    if place.line:
        properties["line"] = str(place.line)
        if place.column:
            properties["col"] = str(place.column)
    properties["title"] = f"{f.rule} {f.subject}"
    message = f"{f.message}\nfix: {f.fix}" if f.fix else f.message
    return _line(_COMMANDS[f.severity], properties, message)


def _line(command: str, properties: dict[str, str], message: str) -> str:
    said = ",".join(f"{key}={_property(value)}" for key, value in properties.items())
    return f"::{command} {said}::{_data(message)}"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
