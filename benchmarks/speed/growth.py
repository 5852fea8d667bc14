"""The time of inverse dynamics against the number of joints, and of states in one call."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

from ur5check._io.loading import load
from ur5check._io.urdf.urdf_writer import urdf_of
from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.states import States, random_states
from ur5check._robot.transforms import Array

from .inverse_dynamics import kernels, parallel, pinocchio_loop, recursion
from .pinocchio_calls import PinocchioCalls
from .random_chain import chain
from .result import Chapter, Comparison
from .timing import Contestant, race

__all__ = ["joints", "numbers_of_states"]

_FEW = 10_000  # states: enough for a long chain
_AT_LEAST = 1_000  # states in a timing, well above the resolution of the clock


def joints(lengths: Sequence[int], seed: int, rounds: int) -> Chapter:
    """One comparison per number of joints."""
    return Chapter(
        "joints",
        "Longer arms",
        "state",
        f"Chains with random links, {_FEW:,} states, one thread. Pinocchio reads them as URDF.",
        tuple(_with_joints(n, seed, rounds) for n in lengths),
        series=True,
    )


def numbers_of_states(arm: SerialArm, most: int, seed: int, rounds: int) -> Chapter:
    """One comparison per power of ten, up to `most` states in one call."""
    counts = [10**k for k in range(len(str(most)))]
    return Chapter(
        "states",
        "One state, and many",
        "state",
        "States passed in one call; one thread.",
        tuple(_with_states(arm, count, seed, rounds) for count in counts),
        series=True,
    )


def _with_joints(n: int, seed: int, rounds: int) -> Comparison:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "chain.urdf"
        file.write_text(urdf_of(chain(n, seed)), encoding="utf-8")
        arm = load(file)
    states = random_states(n, _FEW, seed)
    contestants = [parallel(PinocchioCalls(arm, states, 1), 1), *kernels(arm, states)]
    return race(f"{n} joints", contestants, rounds)


def _with_states(arm: SerialArm, count: int, seed: int, rounds: int) -> Comparison:
    states: States = random_states(arm.n, count, seed)
    calls = PinocchioCalls(arm, states, 1)
    contestants = [
        parallel(calls, 1),
        pinocchio_loop(calls),
        recursion(arm, states),
        *kernels(arm, states),
    ]
    again = max(_AT_LEAST // count, 1)
    name = f"{count:,} state{'s' if count > 1 else ''}"
    return race(name, [_repeated(contestant, again) for contestant in contestants], rounds)


def _repeated(contestant: Contestant, again: int) -> Contestant:
    """`again` runs as one."""

    def run() -> Array | None:
        for _ in range(again - 1):
            contestant.run()
        return contestant.run()

    return Contestant(contestant.name, run, contestant.units * again)
