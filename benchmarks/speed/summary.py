"""The summary of a benchmark in sentences, the ratio to Pinocchio first."""

from __future__ import annotations

from .inverse_dynamics import LLVM, LOOP, NUMPY, PARALLEL, with_threads
from .memory import COPY
from .result import Benchmark, Comparison

__all__ = ["summarize"]


def summarize(b: Benchmark) -> list[str]:
    """One sentence per measured result."""
    sentences = [*_torques(b), *_memory(b), *_operations(b), *_profiles(b)]
    return [sentence for sentence in sentences if sentence]


def _torques(b: Benchmark) -> list[str]:
    torques = b.comparison("torques")
    if torques is None:
        return []
    sentences = []
    for ours in (LLVM, NUMPY):
        faster = [
            f"{ratio:.3g} times as fast as {PARALLEL}, {_threads(number)} each"
            for number in sorted({1, b.threads})
            if (
                ratio := _ratio(torques, with_threads(PARALLEL, number), with_threads(ours, number))
            )
        ]
        if loop := _ratio(torques, LOOP, with_threads(ours, 1)):
            faster.append(f"{loop:.3g} times as fast as a {LOOP}")
            sentences.append(f"The {ours}: {', '.join(faster)}.")
    largest = max((t.deviation for t in torques.timings if t.deviation is not None), default=None)
    return [*sentences, "" if largest is None else f"The largest difference is {largest:.1e} N m."]


def _memory(b: Benchmark) -> list[str]:
    memory = b.comparison("memory")
    share = memory and _ratio(memory, with_threads(COPY, 1), with_threads(LLVM, 1))
    if not share:
        return []
    return [f"Memory would allow {1.0 / share:.2g} times the kernel's rate, on one thread."]


def _operations(b: Benchmark) -> list[str]:
    if not b.operations:
        return []
    torques = b.operations[0]
    return [
        f"A state's torques take {torques.generated.total} operations, {torques.as_written.total} "
        "as the recursion is written."
    ]


def _profiles(b: Benchmark) -> list[str]:
    return [
        f"{profile.command} takes {profile.whole:.2g} s, most of it for {profile.parts[0][0]} "
        f"({profile.parts[0][1]:.2g} s)."
        for profile in b.profiles
    ]


def _threads(number: int) -> str:
    return f"{number} thread{'s' if number > 1 else ''}"


def _ratio(comparison: Comparison, slow: str, fast: str) -> float | None:
    """Ratio of their times; None if either did not take part."""
    long, short = comparison.seconds(slow), comparison.seconds(fast)
    return long / short if long and short else None
