"""The README's commands and code run, and its links lead somewhere.

The two installing commands are run by .ci/run, as they are written, in a clean clone.
"""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from repository import REPOSITORY
from ur5check._cli.main import main

ROOT = REPOSITORY
README = (ROOT / "README.md").read_text("utf-8")
COMMANDS = [
    line.partition("#")[0].strip()
    for block in re.findall(r"```sh\n(.*?)```", README, re.DOTALL)
    for line in block.splitlines()
    if line.startswith("ur5check ")
]
PYTHON = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
#: Arms that differ, or do not stand, are exit code 1; everything else passes.
EXPECTED = {"diff": 1, "sweep": 1, "simulate": 1}
#: The same commands on fewer states, for less time.
FASTER = {
    "validate": ["--samples", "200"],
    "diff": ["--samples", "200"],
    "sweep": ["--states", "2000"],
    "engines": ["--samples", "20"],
    "simulate": ["--seconds", "0.5"],
}


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """A folder with the user's files that the README speaks of."""
    monkeypatch.chdir(tmp_path)
    assert main(["expand", "appendix", "--quiet", "-o", "good.urdf"]) == 0
    good = Path("good.urdf").read_text("utf-8")
    Path("my_arm.urdf").write_text(good, "utf-8")
    bad = good.replace('xyz="0.0 0.0 0.28"', 'xyz="0.0 0.0 -0.28"')
    assert bad != good
    Path("bad.urdf").write_text(bad, "utf-8")
    return tmp_path


def test_there_are_commands_and_code():
    assert len(COMMANDS) >= 6
    assert len(PYTHON) == 2


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_runs(command, desk, capsys):
    _, *arguments = shlex.split(command)
    if arguments[0] == "sweep":
        arguments = [word for word in arguments if word not in ("--states", "1e6")]
    assert main([*arguments, *FASTER.get(arguments[0], []), "--quiet"]) == EXPECTED.get(
        arguments[0], 0
    )
    if "-o" not in arguments:
        assert capsys.readouterr().out


@pytest.mark.parametrize("code", PYTHON)
def test_the_code_runs(code):
    exec(compile(code, "README.md", "exec"), {"__name__": "readme"})  # noqa: S102 - our own page


def test_the_commands_that_ci_runs_are_marked():
    for name in ("main", "tests"):
        assert f"<!-- command: {name} -->\n```sh\n" in README


@pytest.mark.parametrize("page", [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))])
def test_links_lead_somewhere(page):
    text = page.read_text("utf-8")
    for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text):
        if not target.startswith(("http:", "https:", "mailto:")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"
