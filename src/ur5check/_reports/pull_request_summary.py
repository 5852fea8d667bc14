"""Verdicts as a short Markdown summary for a pull request: a table of files, findings folded."""

from __future__ import annotations

from html import escape

from .._finding import SEVERITIES, Finding
from .._validation.fingerprints import path_from
from .._validation.verdict import VerdictSet
from .file_places import first_place
from .markdown import as_cells, escaped
from .verdict_summary import failed_laws, summarize_verdicts

__all__ = ["render_summary"]

#: Findings of one file that are shown: GitHub takes 1 MiB a step.
_MOST = 50


def render_summary(verdicts: VerdictSet) -> str:
    """The verdict, a row a file, and under each file's name its findings, folded."""
    word = "PASS" if verdicts.passed else "FAIL"
    blocks = [f"### ur5check: {word}", escaped(summarize_verdicts(verdicts)), _files(verdicts)]
    blocks += [f"- {escaped(f'{file}: {text}')}" for file, text in failed_laws(verdicts)]
    for v in verdicts.models:
        blocks += _folded(v.judgement.file, v.findings.open)
    for pair in verdicts.pairs:
        blocks += _folded(pair.file, pair.findings.open, title=pair.label)
    return "\n\n".join(blocks) + "\n"


def _files(verdicts: VerdictSet) -> str:
    rows = [
        as_cells(["", "file", "errors", "warnings", "notes", "accepted", "mass [kg]"]),
        as_cells([":--", ":--", "--:", "--:", "--:", "--:", "--:"]),
    ]
    for v in verdicts.models:
        counts = [sum(f.severity == word for f in v.findings.open) for word in SEVERITIES]
        excused = len(v.findings.accepted) + len(v.findings.known)
        robot = v.judgement.robot
        mass = "" if robot is None else f"{robot.mass:.4g}"
        name = escaped(path_from(None, v.judgement.file))
        word = "PASS" if v.passed else "**FAIL**"
        rows.append(as_cells([word, name, *map(str, counts), str(excused), mass]))
    return "\n".join(rows)


def _folded(file: str, findings: tuple[Finding, ...], *, title: str = "") -> list[str]:
    if not findings:
        return []
    rows = [
        as_cells(["severity", "rule", "place", "finding", "fix"]),
        as_cells([":--"] * 5),
    ]
    for f in findings[:_MOST]:
        place = str(first_place(f, file))
        cells = (f.severity, f.rule, place, f"{f.subject}: {f.message}", f.fix)
        rows.append(as_cells([escaped(cell) for cell in cells]))
    name = escape(title or path_from(None, file))  # in HTML nothing is read as Markdown
    count = f"{len(findings)} finding{'s' if len(findings) > 1 else ''}"
    more = [f"… and {len(findings) - _MOST} more."] if len(findings) > _MOST else []
    return [
        f"<details><summary>{name}: {count}</summary>",
        "\n".join(rows),
        *more,
        "</details>",
    ]
