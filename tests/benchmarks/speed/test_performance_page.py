"""docs/performance.md holds one run whole, its words say what that run's tables say, and the
commands on it run."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import bench_speed
import pytest
from speed.command_profiles import COMMANDS
from speed.first_use import COLD, FIRST_CALLS, IMPORT, WARM
from speed.inverse_dynamics import LLVM, LOOP, NUMPY, PARALLEL, with_threads

from repository import REPOSITORY

PAGE = (REPOSITORY / "docs" / "performance.md").read_text(encoding="utf-8")


def table(title: str) -> dict[str, list[str]]:
    """Cells by the first cell of each row, of all tables under a heading."""
    text = PAGE.replace("\\", "").partition(f"# {title}\n")[2]
    body = re.split(r"^#{1,3} ", text, maxsplit=1, flags=re.M)[0]
    rows = [
        [cell.strip() for cell in line.strip("|").split("|")]
        for line in body.splitlines()
        if line.startswith("|") and not set(line) <= set("|:- ")
    ]
    return {row[0]: row[1:] for row in rows}


def number(cell: str) -> float:
    return float(cell.replace(",", ""))


def times_as_fast(slow: str, fast: str) -> float:
    torques = table("Inverse dynamics")
    return number(torques[slow][0]) / number(torques[fast][0])


def slowest_first_call(kind: str) -> float:
    """Of the UR5's quantities [s]; the longer arms stand behind them."""
    return max(map(number, table("The first call of a kernel")[kind][: len(FIRST_CALLS)])) / 1e3


MEASURED = {
    "kernel against `pin.rneaInParallel`, 1 thread": lambda: times_as_fast(
        with_threads(PARALLEL, 1), with_threads(LLVM, 1)
    ),
    "the same, 2 threads": lambda: times_as_fast(with_threads(PARALLEL, 2), with_threads(LLVM, 2)),
    "kernel against the Python loop": lambda: times_as_fast(LOOP, with_threads(LLVM, 1)),
    "NumPy path against `pin.rneaInParallel`, 1 thread": lambda: times_as_fast(
        with_threads(PARALLEL, 1), with_threads(NUMPY, 1)
    ),
    "operations for the torques": lambda: number(table("Operations")["torques"][1]),
    "largest difference from Pinocchio": lambda: max(
        float(cells[3]) for cells in table("Inverse dynamics").values() if cells[3][0].isdigit()
    ),
    "slowest first call, nothing on disk": lambda: slowest_first_call(COLD),
    "the same, code on disk": lambda: slowest_first_call(WARM),
}


@pytest.mark.parametrize("goal", MEASURED)
def test_a_goal_is_held_against_the_run(goal: str) -> None:
    wanted, said = table("Goals")[goal]
    measured = MEASURED[goal]()
    figure = float(said.split()[0])
    assert figure == pytest.approx(measured, rel=0.006)  # three digits, of figures of three digits
    bound = float(re.findall(r"[\d.]+(?:e-\d+)?", wanted)[0])
    assert figure >= bound if "≥" in wanted else figure < bound


def test_every_goal_is_measured() -> None:
    goals = {name for name in table("Goals") if name}
    assert set(MEASURED) | {"goal"} >= goals


def test_the_run_is_whole() -> None:
    for title in ("The limit of memory", "Matrices", "One state, and many", "Longer arms"):
        assert with_threads(LLVM, 1) in table(title), title
    assert {IMPORT, COLD, WARM} <= set(table("The first call of a kernel"))
    assert {"python -c pass", "import ur5check", "ur5check --help"} <= set(table("Start-up"))
    page = PAGE.replace("\\", "")
    assert all(f"ur5check {command} [s]" in page for command in COMMANDS)


def test_commands_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (block, *_) = re.findall(r"```sh\n(.*?)```", PAGE, re.S)
    for line in block.splitlines():
        program, script, *words = shlex.split(line)
        assert (program, script) == ("python", "benchmarks/bench_speed.py")
        # The same command, on the measurement that takes a second.
        assert (
            bench_speed.main([*words, "--only", "start-up", "--rounds", "1", "--states", "10"]) == 0
        )
    assert capsys.readouterr().out or list(tmp_path.iterdir())
