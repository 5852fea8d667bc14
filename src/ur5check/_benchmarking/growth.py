"""What a torque costs as the arm grows longer, and as more states are asked for at once."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from .._io.loading import load
from .._io.urdf.urdf_writer import urdf_of
from .._robot.inertia import Inertia
from .._robot.serial_arm import Joint, Link, SerialArm
from .._robot.states import States, random_states
from .._robot.transforms import Array, Transform
from .pinocchio_calls import PinocchioCalls
from .result import Chapter, Comparison
from .timing import Contestant, race
from .torques import kernels, parallel, pinocchio_loop, recursion

__all__ = ["chain", "joints", "numbers_of_states"]

_FEW = 10_000  # states: enough for a long chain
_AT_LEAST = 1_000  # states a timing, or the clock's own grain would show


def joints(lengths: Sequence[int], seed: int, rounds: int) -> Chapter:
    """One comparison a number of joints."""
    return Chapter(
        "joints",
        "Longer arms",
        "state",
        f"Chains with random links, {_FEW:,} states, one thread. Pinocchio reads them as URDF.",
        tuple(_with_joints(n, seed, rounds) for n in lengths),
        series=True,
    )


def numbers_of_states(arm: SerialArm, most: int, seed: int, rounds: int) -> Chapter:
    """One comparison a power of ten, up to `most` states in one call."""
    counts = [10**k for k in range(len(str(most)))]
    return Chapter(
        "states",
        "One state, and many",
        "state",
        "States that are asked for in one call, on one thread.",
        tuple(_with_states(arm, count, seed, rounds) for count in counts),
        series=True,
    )


def chain(n: int, seed: int) -> SerialArm:
    """A chain of n joints about z, each link a possible body, in no particular frames."""
    rng = np.random.default_rng((seed, n))
    links = []
    for i in range(1, n + 1):
        points = rng.normal(size=(4, 3)) * 0.1  # a quarter of the mass in each
        links.append(
            Link(
                f"link_{i}",
                Transform.from_rpy(
                    rng.normal(size=3) * 0.3, rng.uniform(-np.pi, np.pi, 3).tolist()
                ),
                _body(rng.uniform(0.5, 5.0), points),
            )
        )
    turning = [Joint(f"joint_{i}", np.array([0.0, 0.0, 1.0])) for i in range(1, n + 1)]
    return SerialArm(f"chain of {n}", tuple(turning), tuple(links))


def _body(mass: float, points: Array) -> Inertia:
    com = points.mean(axis=0)
    second_moment = mass * np.cov(points.T, bias=True)
    return Inertia(mass, com, np.trace(second_moment) * np.eye(3) - second_moment)


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
    """So many runs as one."""

    def run() -> Array | None:
        for _ in range(again - 1):
            contestant.run()
        return contestant.run()

    return Contestant(contestant.name, run, contestant.units * again)
