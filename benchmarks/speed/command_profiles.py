"""The time of `validate` and `diff` by part: imports, reference engines, recursion, …"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
from pathlib import Path

from .result import Profile

__all__ = ["COMMANDS", "profiles"]

COMMANDS = ("validate", "diff paper appendix")
_MOST = 3  # rounds
_SAMPLER = Path(__file__).with_name("stack_sampler.py")


def profiles(rounds: int) -> tuple[Profile, ...]:
    """Each command in its own process, under the sampler of `stack_sampler.py`."""
    return tuple(_profile(command, min(rounds, _MOST)) for command in COMMANDS)


def _profile(command: str, rounds: int) -> Profile:
    runs = [_run(command) for _ in range(rounds)]
    names = {name for run in runs for name in run}
    spent = {name: statistics.median(run.get(name, 0.0) for run in runs) for name in names}
    whole = spent.pop("whole")
    parts = sorted(spent.items(), key=lambda part: part[1], reverse=True)
    return Profile(f"ur5check {command}", whole, tuple(parts))


def _run(command: str) -> dict[str, float]:
    done = subprocess.run(
        [sys.executable, _SAMPLER, *command.split()],
        stdout=subprocess.PIPE,
        check=True,
    )
    found: dict[str, float] = json.loads(done.stdout)
    return found
