"""The first contact: greeting, completion, counts as people write them, colour as they set it."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from ur5check._cli.main import COMMANDS

if TYPE_CHECKING:
    from .conftest import Command


def test_alone_it_shows_the_commands_most_used(ur5check: Command) -> None:
    said = ur5check()
    assert (said.code, said.err) == (0, "")
    lines = said.out.splitlines()
    shown = [line.split()[1] for line in lines if line.startswith("  ur5check ")]
    assert len(shown) == 5
    assert set(shown) < set(COMMANDS)
    assert max(map(len, lines)) <= 80


@pytest.mark.parametrize("number", ["200", "2e2", "0_200"])
def test_counts_are_written_as_people_do(ur5check: Command, number: str) -> None:
    said = ur5check("validate", "paper", "--samples", number, "--quiet", "--format", "json")
    assert json.loads(said.out)["samples"] == 200


@pytest.mark.parametrize("number", ["1e-1", "2.5", "nan", "1e999", ""])
def test_what_is_no_count_is_refused(ur5check: Command, number: str) -> None:
    assert ur5check("validate", "paper", "--samples", number).code == 2


@pytest.mark.parametrize(
    ("name", "value", "coloured"),
    [
        ("FORCE_COLOR", "1", True),
        ("FORCE_COLOR", "", False),
        ("NO_COLOR", "1", False),
        ("NO_COLOR", "", False),
    ],
)
def test_colour_of_what_is_piped(
    ur5check: Command, monkeypatch: pytest.MonkeyPatch, name: str, value: str, coloured: bool
) -> None:
    for variable in ("FORCE_COLOR", "NO_COLOR"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setenv(name, value)
    said = ur5check("diff", "paper", "appendix", "--quick", "--samples", 20, "--quiet", "--full")
    assert ("\x1b[" in said.out) == coloured


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_completion_knows_every_command(ur5check: Command, shell: str) -> None:
    said = ur5check("--completion", shell)
    assert said.code == 0
    assert all(command in said.out for command in COMMANDS)


def test_bash_completes_commands_and_options() -> None:
    script = subprocess.run(
        [sys.executable, "-m", "ur5check", "--completion", "bash"],
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    ).stdout

    def completed(*words: str) -> set[str]:
        line = " ".join(f"'{word}'" for word in ("ur5check", *words))
        ask = (
            f"COMP_WORDS=({line}); COMP_CWORD={len(words)}; _shtab_ur5check; echo ${{COMPREPLY[@]}}"
        )
        done = subprocess.run(
            ["bash", "-c", f"{script}\n{ask}"],
            capture_output=True,
            text=True,
            timeout=60,
            check=True,
        )
        return set(done.stdout.split())

    assert completed("val") == {"validate"}
    assert "--baseline" in completed("validate", "--base")
