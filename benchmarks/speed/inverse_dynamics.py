"""Inverse dynamics of the same states by Pinocchio, the recursion, kernels, JAX, MuJoCo, Drake."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ur5check._dynamics.compiled import kernel
from ur5check._dynamics.recursion import rnea
from ur5check._engines.registry import REGISTRY, installed, make_engine
from ur5check._errors import EngineError
from ur5check._robot.serial_arm import SerialArm, Source
from ur5check._robot.states import States
from ur5check._robot.transforms import Array

from .jax_calls import jax_contestant
from .pinocchio_calls import PinocchioCalls
from .result import Chapter
from .timing import Contestant, race

__all__ = [
    "LLVM",
    "LOOP",
    "NUMPY",
    "PARALLEL",
    "RECURSION",
    "TRANSPOSED",
    "inverse_dynamics",
    "kernels",
    "parallel",
    "pinocchio_loop",
    "recursion",
    "with_threads",
]

LOOP = "Python loop over pin.rnea"
PARALLEL = "pin.rneaInParallel"
RECURSION = "ur5check.rnea"
NUMPY, LLVM = "kernel on NumPy", "kernel by LLVM"
TRANSPOSED = "kernel by LLVM, arrays (n, N)"

#: The time per state of a Python loop does not depend on its length; these are enough states.
_IN_A_LOOP, _IN_A_SLOW_LOOP = 100_000, 5_000
_OTHERS = ("mujoco", "drake")


def inverse_dynamics(arm: SerialArm, states: States, threads: int, rounds: int) -> Chapter:
    """All contestants in one comparison."""
    calls, count = PinocchioCalls(arm, states, threads), len(states.q)
    contestants = [
        parallel(calls, 1),
        pinocchio_loop(calls),
        recursion(arm, states),
        *kernels(arm, states),
        *_transposed(arm, states),
        *([jax] if (jax := jax_contestant(arm, states)) else []),
        *_other_engines(arm, states),
    ]
    if threads > 1:
        contestants += [parallel(calls, threads), *kernels(arm, states, threads)]
    return Chapter(
        "torques",
        "Inverse dynamics",
        "state",
        f"{count:,} states; {min(count, _IN_A_LOOP):,} for the loop over Pinocchio, "
        f"{min(count, _IN_A_SLOW_LOOP):,} for those over other engines. Results go to "
        "existing arrays.",
        (race("", contestants, rounds),),
    )


def with_threads(name: str, threads: int) -> str:
    """The name of a contestant with so many threads."""
    return f"{name}, {threads} thread{'s' if threads > 1 else ''}"


def parallel(calls: PinocchioCalls, threads: int) -> Contestant:
    """Pinocchio's own loop in C++."""
    return Contestant(
        with_threads(PARALLEL, threads), lambda: calls.in_parallel(threads), len(calls.states.q)
    )


def pinocchio_loop(calls: PinocchioCalls) -> Contestant:
    """A Python loop."""
    count = min(len(calls.states.q), _IN_A_LOOP)
    return Contestant(LOOP, calls.loop("pin.rnea", count), count)


def recursion(arm: SerialArm, states: States) -> Contestant:
    """The hand-written recursion, on blocks of states."""
    return Contestant(RECURSION, lambda: rnea(arm, states.q, states.qd, states.qdd), len(states.q))


def kernels(arm: SerialArm, states: States, threads: int = 1) -> list[Contestant]:
    """The generated code, on NumPy and, where it is installed, by LLVM."""
    paths: list[tuple[str, kernel.Path]] = [(NUMPY, "numpy")] * (threads == 1)
    if kernel.default_path() == "llvm":
        paths.append((LLVM, "llvm"))
    return [
        Contestant(with_threads(name, threads), _kernel(arm, states, threads, path), len(states.q))
        for name, path in paths
    ]


def _kernel(arm: SerialArm, states: States, threads: int, path: kernel.Path) -> Callable[[], Array]:
    compute, out = kernel.compile(arm, threads, path=path).rnea, np.empty_like(states.q)
    return lambda: compute(states.q, states.qd, states.qdd, out=out)


def _transposed(arm: SerialArm, states: States) -> list[Contestant]:
    """The kernel on arrays with one row per joint."""
    if kernel.default_path() != "llvm":
        return []
    rows = [np.ascontiguousarray(part.T) for part in (states.q, states.qd, states.qdd)]
    compute, out = kernel.compile(arm, path="llvm").rnea, np.empty_like(rows[0])

    def run() -> Array:
        return compute(*rows, layout="joints", out=out).T

    return [Contestant(with_threads(TRANSPOSED, 1), run, len(states.q))]


def _other_engines(arm: SerialArm, states: States) -> list[Contestant]:
    """Installed engines that accept the arm (built joint by joint, not read from a file)."""
    found = []
    few = [part[:_IN_A_SLOW_LOOP] for part in (states.q, states.qd, states.qdd)]
    for key in _OTHERS:
        if key not in installed():
            continue
        try:
            engine = make_engine(key, replace(arm, source=Source()))
        except EngineError:
            continue
        compute = engine.inverse_dynamics
        name = f"Python loop over {REGISTRY[key].title}"
        found.append(Contestant(name, lambda compute=compute: compute(*few), len(few[0])))
    return found
