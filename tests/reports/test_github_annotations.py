"""Workflow commands of GitHub: read back as its runner reads them."""

from __future__ import annotations

import re

from judged_files import SPOILED, SPOILED_NAME, judged
from ur5check._reports.github_annotations import render_annotations

_COMMAND = re.compile(r"::(error|warning|notice) ([^:]*)::(.*)")


def commands(text: str) -> list[tuple[str, dict[str, str], str]]:
    """Each line as the runner reads it: command, properties and message, unescaped."""
    found = []
    for line in text.splitlines():
        match = _COMMAND.fullmatch(line)
        assert match is not None, line
        pairs = (part.partition("=") for part in match[2].split(","))
        found.append((match[1], {k: unescaped(v) for k, _, v in pairs}, unescaped(match[3])))
    return found


def unescaped(text: str) -> str:
    for code, character in (("%0D", "\r"), ("%0A", "\n"), ("%3A", ":"), ("%2C", ",")):
        text = text.replace(code, character)
    return text.replace("%25", "%")


def test_one_annotation_for_a_fault_on_its_line(here):
    verdicts, _ = judged(here)
    (pair, mass) = sorted(commands(render_annotations(verdicts)), key=lambda c: c[1]["title"])
    level, properties, message = mass
    assert level == "error"
    assert properties["file"] == SPOILED_NAME
    lines = SPOILED.splitlines()
    column = int(properties["col"])
    assert lines[int(properties["line"]) - 1][column - 1 :].startswith('-1"')
    assert properties["title"].startswith("INE101 link 'arm'")
    assert "fix: " in message.splitlines()[1]
    assert pair[1]["title"].startswith("CMP001")


def test_accepted_findings_give_none_and_errors_come_first(here):
    text = SPOILED.replace('name="j"', 'name="k"')  # the warning is no longer accepted
    verdicts, _ = judged(here, text)
    levels = [level for level, _, _ in commands(render_annotations(verdicts))]
    assert levels == ["error", "error", "warning"]
