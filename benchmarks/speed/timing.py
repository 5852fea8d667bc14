"""Medians over rounds in which all contestants take turns: a slow second affects all alike."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from ur5check._robot.transforms import Array

from .result import Comparison, Timing

__all__ = ["Contestant", "race", "ranked"]


@dataclass(frozen=True)
class Contestant:
    """Something to be timed.

    run : one run; returns its result, one row per unit, or None
    units : states (or other units) per run
    """

    name: str
    run: Callable[[], Array | None]
    units: int = 1


def race(subject: str, contestants: Sequence[Contestant], rounds: int) -> Comparison:
    """Time them, after an untimed run of each, which fills caches and whose result is compared."""
    found = [contestant.run() for contestant in contestants]
    deviations = [_deviation(found[0] if len(found) else None, result) for result in found]
    del found
    times: list[list[float]] = [[] for _ in contestants]
    for _ in range(rounds):
        for contestant, own in zip(contestants, times, strict=True):
            began = perf_counter()
            contestant.run()
            own.append((perf_counter() - began) / contestant.units)
    return ranked(subject, [c.name for c in contestants], times, deviations)


def ranked(
    subject: str,
    names: Sequence[str],
    times: Sequence[Sequence[float]],
    deviations: Sequence[float | None] | None = None,
) -> Comparison:
    """The same from given times, one list per contestant [s]."""
    first = statistics.median(times[0])
    return Comparison(
        subject,
        tuple(
            Timing(name, median, _spread(own) / median, first / median, deviation)
            for name, own, deviation in zip(
                names, times, deviations or [None] * len(names), strict=True
            )
            if (median := statistics.median(own))
        ),
    )


def _spread(times: Sequence[float]) -> float:
    """Distance between the quartiles."""
    low, high = np.percentile(times, (25, 75))
    return float(high - low)


def _deviation(first: Array | None, result: Array | None) -> float | None:
    """Largest difference over the units that both computed."""
    if first is None or result is None or result is first:
        return None
    both = min(len(first), len(result))
    return float(np.abs(first[:both] - result[:both]).max())
