"""Medians of several rounds in which all take their turn, so that a slow second hits all alike."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from .._robot.transforms import Array
from .result import Comparison, Timing

__all__ = ["Contestant", "race", "ranked"]


@dataclass(frozen=True)
class Contestant:
    """Something that takes time.

    run : does it once; returns what it found, one row a unit, or None
    units : how many states, or other units, one run sees to
    """

    name: str
    run: Callable[[], Array | None]
    units: int = 1


def race(subject: str, contestants: Sequence[Contestant], rounds: int) -> Comparison:
    """Time them, after one run of each that is not timed: it fills caches, and is compared."""
    found = [contestant.run() for contestant in contestants]
    offs = [_off(found[0] if len(found) else None, result) for result in found]
    del found
    times: list[list[float]] = [[] for _ in contestants]
    for _ in range(rounds):
        for contestant, own in zip(contestants, times, strict=True):
            began = perf_counter()
            contestant.run()
            own.append((perf_counter() - began) / contestant.units)
    return ranked(subject, [c.name for c in contestants], times, offs)


def ranked(
    subject: str,
    names: Sequence[str],
    times: Sequence[Sequence[float]],
    offs: Sequence[float | None] | None = None,
) -> Comparison:
    """The same from times that somebody else took, one list a contestant [s]."""
    first = statistics.median(times[0])
    return Comparison(
        subject,
        tuple(
            Timing(name, median, _spread(own) / median, first / median, off)
            for name, own, off in zip(names, times, offs or [None] * len(names), strict=True)
            if (median := statistics.median(own))
        ),
    )


def _spread(times: Sequence[float]) -> float:
    """Distance between the quartiles; no assumption on how times scatter."""
    low, high = np.percentile(times, (25, 75))
    return float(high - low)


def _off(first: Array | None, result: Array | None) -> float | None:
    """Largest difference over the units that both have seen."""
    if first is None or result is None or result is first:
        return None
    both = min(len(first), len(result))
    return float(np.abs(first[:both] - result[:both]).max())
