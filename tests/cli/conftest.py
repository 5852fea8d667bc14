"""Running the real command, in this process or in one of its own."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import NamedTuple

import pytest

from ur5check._cli.main import main


class Said(NamedTuple):
    """What a command said."""

    code: int
    out: str
    err: str


Command = Callable[..., Said]


@pytest.fixture
def ur5check(capsys: pytest.CaptureFixture[str]) -> Command:
    """`ur5check(*arguments)` in this process."""

    def run(*arguments: object) -> Said:
        code = main([str(argument) for argument in arguments])
        return Said(code, *capsys.readouterr())

    return run


@pytest.fixture
def process() -> Command:
    """`python -m ur5check *arguments` in a process of its own."""

    def run(*arguments: object) -> Said:
        command = [sys.executable, "-m", "ur5check", *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
        return Said(done.returncode, done.stdout, done.stderr)

    return run
