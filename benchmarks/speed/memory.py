"""The limit set by memory: a copy of as many bytes as inverse dynamics reads and writes.

A state of n joints is 3 n numbers in and n out, 144 + 48 bytes for six.  A copy of 2 n numbers
reads and writes as many bytes, so its time is a lower bound.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.states import States
from ur5check._robot.transforms import Array

from .inverse_dynamics import NUMPY, kernels, with_threads
from .result import Chapter
from .timing import Contestant, race

__all__ = ["COPY", "copy_of", "memory"]

COPY = "copy of as many bytes"


def memory(arm: SerialArm, states: States, threads: int, rounds: int) -> Chapter:
    """The copy, and the kernel, with one and with several threads."""
    count = len(states.q)
    contestants = []
    for number in sorted({1, threads}):
        contestants.append(
            Contestant(with_threads(COPY, number), copy_of(states.q, number)[0], count)
        )
        contestants += [
            kernel for kernel in kernels(arm, states, number) if not kernel.name.startswith(NUMPY)
        ]
    return Chapter(
        "memory",
        "The limit of memory",
        "state",
        f"{count:,} states: {24 * arm.n} bytes in and {8 * arm.n} out for each.",
        (race("", contestants, rounds),),
    )


def copy_of(q: Array, threads: int) -> tuple[Callable[[], None], Array, Array]:
    """(the copy, its source, its target), of as many bytes as `rnea` moves at q, shape (N, n)."""
    source = np.concatenate([q, q])
    target = np.zeros_like(source)
    parts = list(zip(np.array_split(source, threads), np.array_split(target, threads), strict=True))

    def copied(part: tuple[Array, Array]) -> None:
        np.copyto(part[1], part[0])  # releases the GIL

    def run() -> None:
        if threads == 1:
            copied(parts[0])
            return
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(copied, parts))

    return run, source, target
