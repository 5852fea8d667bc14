"""Writes docs/diagnosis.md: the text of diagnosis.in.md, the known mistakes as tables, and what the
page's examples print.

python docs/generate_mistakes.py
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

from ur5check._comparison.diagnosis import mistake_search as search
from ur5check._comparison.diagnosis.arm_mistakes import ARM_MISTAKES
from ur5check._comparison.diagnosis.mistake import Mistake
from ur5check._comparison.diagnosis.mistakes import LINK_MISTAKES

HERE = Path(__file__).resolve().parent
PAGE = HERE / "diagnosis.md"
TEMPLATE = HERE / "diagnosis.in.md"

_BLOCK = re.compile(r"```python\n(.*?)```\n", re.S)


def page() -> str:
    """The whole page."""
    text = TEMPLATE.read_text(encoding="utf-8")
    text = re.sub(
        r"«(\w+)»", lambda found: f"{vars(search)[found[1]]:.10f}".rstrip("0").rstrip("."), text
    )
    for name, mistakes in (("links", LINK_MISTAKES), ("arm", ARM_MISTAKES)):
        text = text.replace(f"[[{name}]]", table(mistakes))
    return with_outputs(text)


def table(mistakes: Iterable[Mistake]) -> str:
    """A row for each mistake: rule, id, what it spoils, what happened, how to repair, where met."""
    lines = [
        "| rule | id | spoils | what happened | how to repair it | met by |",
        "|---|---|---|---|---|---|",
    ]
    for mistake in mistakes:
        met = ", ".join(_cited(source) for source in mistake.sources) or "—"
        cells = (mistake.spoils, mistake.says, mistake.repair, met)
        escaped = (cell.replace("|", chr(92) + "|") for cell in cells)
        lines.append(f"| {mistake.rule_id} | `{mistake.id}` | {' | '.join(escaped)} |")
    return "\n".join(lines)


def _cited(source: str) -> str:
    full_name, _, number = source.partition("#")
    if not number:
        return f"`{source}`"
    repository = full_name.partition("/")[2]
    return f"[{repository}#{number}](https://github.com/{full_name}/issues/{number})"


def with_outputs(text: str) -> str:
    """The text with each Python block followed by what it prints; blocks share their names."""
    names: dict[str, Any] = {}

    def run(block: re.Match[str]) -> str:
        printed = StringIO()
        with redirect_stdout(printed):
            exec(compile(block[1], TEMPLATE.name, "exec"), names)  # noqa: S102 - our own page
        lines = [line.rstrip() for line in printed.getvalue().splitlines()]
        return block[0] + ("\n```text\n" + "\n".join(lines) + "\n```\n" if lines else "")

    return _BLOCK.sub(run, text)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
