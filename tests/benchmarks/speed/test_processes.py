"""Measurements in separate processes: start-up, first calls, whole commands."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
from speed.first_use import COLD, IMPORT, WARM, first_use
from speed.random_chain import chain
from speed.start_up import start_up

from repository import REPOSITORY

SAMPLER = REPOSITORY / "benchmarks" / "speed" / "stack_sampler.py"


def test_start_up_is_held_against_bare_python() -> None:
    (comparison,) = start_up(1).comparisons
    assert [timing.name for timing in comparison.timings] == [
        "python -c pass",
        "import ur5check",
        "ur5check --help",
        "import numpy",
    ]


def test_a_first_call_finds_nothing_and_a_second_finds_code(monkeypatch) -> None:
    monkeypatch.setattr("speed.first_use.FIRST_CALLS", {"torques": "rnea"})
    torques, longer = first_use(chain(1, 0), (2,), 0, 1).comparisons
    assert [timing.name for timing in torques.timings] == [IMPORT, COLD, WARM]
    assert longer.subject == "torques, 2 joints"
    cold, warm = torques.seconds(COLD), torques.seconds(WARM)
    assert cold is not None
    assert warm is not None
    assert cold > warm  # a compilation against a read of what it left


def sampled(*words: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(SAMPLER), *words]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_the_parts_of_a_command_are_the_whole() -> None:
    done = sampled("validate", "--samples", "300")
    spent = json.loads(done.stdout)
    whole = spent.pop("whole")
    assert sum(spent.values()) == pytest.approx(whole, rel=0.1)
    assert {"imports", "reference engines", "recursion"} <= set(spent)


def test_a_command_that_fails_has_no_profile() -> None:
    done = sampled("diff", "paper", "nobody")
    assert done.returncode == 2
    assert done.stdout == ""
