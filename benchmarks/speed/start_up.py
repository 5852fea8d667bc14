"""Time of importing the package and of `--help`, against bare Python."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable

from .result import Chapter
from .timing import Contestant, race

__all__ = ["start_up"]

_ATTEMPTS = 3  # processes per round: each takes a few hundredths of a second, with scatter


def start_up(rounds: int) -> Chapter:
    """Imports of the package, and the help of the command."""
    python = [sys.executable]
    contestants = [
        _process("python -c pass", [*python, "-c", "pass"]),
        _process("import ur5check", [*python, "-c", "import ur5check"]),
        _process("ur5check --help", [*python, "-m", "ur5check", "--help"]),
        _process("import numpy", [*python, "-c", "import numpy"]),
    ]
    return Chapter(
        "start-up", "Start-up", "process", "Whole processes.", (race("", contestants, rounds),)
    )


def _process(name: str, words: list[str]) -> Contestant:
    return Contestant(name, _started(words), _ATTEMPTS)


def _started(words: list[str]) -> Callable[[], None]:
    def run() -> None:
        for _ in range(_ATTEMPTS):
            subprocess.run(words, check=True, stdout=subprocess.DEVNULL)

    return run
