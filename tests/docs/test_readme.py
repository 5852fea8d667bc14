"""The README's commands and code run, and the output that it shows is that of a fresh run.

The two installing commands are run by .ci/run, as they are written, in a copy of the checkout.
"""

from __future__ import annotations

import importlib.util
import re
import shlex
from pathlib import Path

import pytest

from repository import REPOSITORY
from ur5check._cli.main import COMMANDS, main

README = (REPOSITORY / "README.md").read_text("utf-8")
SHOWN = [
    line.partition("#")[0].strip()
    for block in re.findall(r"```sh\n(.*?)```", README, re.DOTALL)
    for line in block.splitlines()
    if line.startswith("ur5check ")
]
PYTHON = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
#: Arms that differ, or do not stay at rest, are exit code 1; everything else passes.
EXPECTED = {"diff": 1, "sweep": 1, "simulate": 1}
#: The same commands on fewer states, for less time.
FASTER = {
    "validate": ["--samples", "200"],
    "diff": ["--samples", "200"],
    "sweep": ["--states", "2000"],
    "engines": ["--samples", "20"],
    "simulate": ["--seconds", "0.5"],
}


def generator():
    """docs/generate_readme.py, as a module."""
    path = REPOSITORY / "docs" / "generate_readme.py"
    spec = importlib.util.spec_from_file_location("generate_readme", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def example_files(tmp_path, monkeypatch):
    """The user's files that the README speaks of, in the current folder."""
    monkeypatch.chdir(tmp_path)
    generator().write_example_files(Path())


def test_every_command_is_shown():
    assert {shlex.split(line)[1] for line in SHOWN} == set(COMMANDS)
    assert len(PYTHON) == 2


@pytest.mark.parametrize("command", SHOWN)
def test_a_command_runs(command, example_files, capsys):
    _, *arguments = shlex.split(command)
    if arguments[0] == "sweep":
        arguments = [word for word in arguments if word not in ("--states", "1e6")]
    assert main([*arguments, *FASTER.get(arguments[0], []), "--quiet"]) == EXPECTED.get(
        arguments[0], 0
    )
    if "-o" not in arguments:
        assert capsys.readouterr().out


def test_the_shown_output_is_that_of_a_fresh_run(example_files):
    """If it is not: python docs/generate_readme.py"""
    shown = generator().BLOCK.findall(README)
    assert [len(text.splitlines()) >= 10 for _, _, text, _ in shown] == [True, True]
    assert generator().with_fresh_outputs(README) == README


@pytest.mark.parametrize("code", PYTHON)
def test_the_code_runs(code):
    exec(compile(code, "README.md", "exec"), {"__name__": "readme"})  # noqa: S102 - our own page


def test_the_commands_that_ci_runs_are_one_line_each():
    for name in ("main", "tests"):
        _, _, block = README.partition(f"<!-- command: {name} -->\n```sh\n")
        command, _, rest = block.partition("\n")
        assert command.startswith("python3 -m venv .venv && ")
        assert rest.startswith("```\n")
