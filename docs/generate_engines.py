"""Writes docs/engines.md: the text of engines.in.md, and tables from a run over the whole fleet.

python docs/generate_engines.py

Numbers that only rounding makes are not printed, so that the page is the same on every machine.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

from ur5check._engines.audit.engine_comparison import SAME_ROBOT, EngineReport, compare_engines
from ur5check._engines.audit.fleet_comparison import FLEET_SAMPLES, FleetReport, compare_fleet
from ur5check._engines.audit.import_difference import KINDS
from ur5check._engines.registry import READERS, REFERENCE, REGISTRY
from ur5check._reports.engines_summary import fleet_verdict, import_clause

HERE = Path(__file__).resolve().parent
PAGE = HERE / "engines.md"
TEMPLATE = HERE / "engines.in.md"

_PYTHON = re.compile(r"```python\n(.*?)```\n", re.S)


def page(fleet: FleetReport, appendix: EngineReport) -> str:
    """The whole page."""
    reports = (appendix, *fleet.reports)
    parts = {
        "count": str(len(fleet.reports)),
        "engines": ", ".join(
            f"{r.title} {r.version}" for r in appendix.as_read.readings if r.key != REFERENCE
        ),
        "verdict": verdict(fleet),
        "arms": arms(reports),
        "counts": counts(reports),
        "known_issues": known_issues(),
        "kinds": table(
            ("kind", "what it means", "affects"),
            ((f"`{kind}`", meaning, bearing) for kind, (bearing, meaning) in KINDS.items()),
        ),
    }
    text = TEMPLATE.read_text(encoding="utf-8")
    for name, part in parts.items():
        text = text.replace(f"[[{name}]]", part)
    return _PYTHON.sub(with_output, text)


def verdict(fleet: FleetReport) -> str:
    """The outcome in a sentence or two."""
    explained = all(report.explained for report in fleet.reports)
    rest = "all of them explained" if explained else "not all of them explained"
    text = fleet_verdict(fleet, SAME_ROBOT)
    return f"{text[0].upper()}{text[1:]}. The differences as read are large, and {rest}."


def arms(reports: Sequence[EngineReport]) -> str:
    """A row an arm."""
    return table(
        ("arm", "joints", "as read [N m]", "with fixes [N m]", "why"),
        (
            (
                report.arm.name,
                str(report.arm.n),
                force(report.as_read.matrix.worst),
                force(report.final.matrix.worst),
                why(report),
            )
            for report in reports
        ),
    )


def force(value: float) -> str:
    """Three digits of what is a difference; "same" for what is rounding."""
    return "same" if value <= SAME_ROBOT else f"**{value:.3g}**"


def why(report: EngineReport) -> str:
    """Which engines import another arm, and what they did."""
    clauses = []
    for reading in report.as_read.readings[1:]:
        if reading.refused is not None:
            clauses.append(f"{reading.title} {import_clause(reading)}: {reason(reading.refused)}")
        elif report.as_read.matrix.between(REFERENCE, reading.key).torque > SAME_ROBOT:
            links = ", ".join(f"`{one.where}`" for one in reading.imported.harmful)
            clauses.append(f"{reading.title} {import_clause(reading)} ({links})")
    return "; ".join(clauses)


def reason(refused: str) -> str:
    """The reason in the engine's own message."""
    return refused.rpartition("Error: error ")[2] if "Error: error " in refused else refused


def counts(reports: Sequence[EngineReport]) -> str:
    """Kinds of difference by engine, with the number of arms."""
    keys = [reading.key for reading in reports[0].as_read.readings if reading.key != REFERENCE]
    rows = []
    for kind, (bearing, _) in KINDS.items():
        numbers = [
            sum(
                reading.imported is not None and reading.imported.kinds[kind] > 0
                for report in reports
                for reading in report.as_read.readings
                if reading.key == key
            )
            for key in keys
        ]
        if any(numbers):
            rows.append((f"`{kind}`", bearing, *(str(k) if k else "" for k in numbers)))
    return table(("kind", "affects", *(REGISTRY[key].title for key in keys)), rows)


def known_issues() -> str:
    """The known issues of all readers."""
    return table(
        ("engine", "known issue", "what happens", "torques", "fix"),
        (
            (
                f"{entry.title} {issue.measured}" if entry.make else issue.measured,
                f"`{issue.id}`",
                code(f"{issue.title}. {issue.explanation}"),
                "change" if issue.harmful else "stay",
                code(issue.fix),
            )
            for entry in READERS.values()
            for issue in entry.known_issues
        ),
    )


def code(text: str) -> str:
    """XML tags as Markdown code, unless they are code already."""
    return re.sub(r"(?<!`)((?:<[^<>`]+>)+)(?!`)", r"`\1`", text)


def table(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A Markdown table."""
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def with_output(block: re.Match[str]) -> str:
    """The Python block, followed by what it prints."""
    printed = StringIO()
    with redirect_stdout(printed):
        exec(compile(block[1], TEMPLATE.name, "exec"), {})  # noqa: S102 - our own page
    return f"{block[0]}\n```text\n{printed.getvalue()}```\n"


def run() -> tuple[FleetReport, EngineReport]:
    """What the page is about."""
    return compare_fleet(), compare_engines("appendix", samples=FLEET_SAMPLES)


if __name__ == "__main__":
    PAGE.write_text(page(*run()), encoding="utf-8")
