"""What a benchmark found, as values.

Benchmark ── Chapter ── Comparison ── Timing     times that were taken in turns
          ├─ OperationCount                      what a state costs on paper
          └─ Profile                             where a command's time goes
"""

from __future__ import annotations

from dataclasses import dataclass

from .._dynamics.symbolic.program import Operations
from .._robot.serial_arm import SerialArm

__all__ = ["Benchmark", "Chapter", "Comparison", "OperationCount", "Profile", "Timing"]


@dataclass(frozen=True)
class Timing:
    """One contestant.

    seconds : median over the rounds, for one unit of the chapter [s]
    spread : half the rounds lie within so much of each other, as a share of the median
    speed : how many times as fast as the first of the comparison
    off : largest distance from the first result of the comparison, in that result's own unit; None
        where there is nothing to compare
    """

    name: str
    seconds: float
    spread: float
    speed: float
    off: float | None = None


@dataclass(frozen=True)
class Comparison:
    """Contestants at the same work.

    subject : which work, where a chapter has several ("mass matrix", "12 joints")
    """

    subject: str
    timings: tuple[Timing, ...]

    def seconds(self, name: str) -> float | None:
        """The time of a contestant; None if it did not take part."""
        return next((t.seconds for t in self.timings if t.name == name), None)


@dataclass(frozen=True)
class Chapter:
    """One question.

    unit : what a time is for ("state", "run")
    said : how it was measured, in sentences
    series : whether its comparisons are one, at growing sizes
    """

    key: str
    title: str
    unit: str
    said: str
    comparisons: tuple[Comparison, ...]
    series: bool = False


@dataclass(frozen=True)
class OperationCount:
    """Operations of one quantity at one state: the recursion as it is written, and generated."""

    what: str
    as_written: Operations
    generated: Operations


@dataclass(frozen=True)
class Profile:
    """Seconds of one command, in all and by part, the longest part first."""

    command: str
    whole: float
    parts: tuple[tuple[str, float], ...]


@dataclass(frozen=True, eq=False)
class Benchmark:
    """Everything that was measured, in one run on one machine.

    machine : its processor, cores and system;  versions : of what was measured
    states, rounds, threads, seed : what was asked for
    """

    arm: SerialArm
    machine: dict[str, str | int]
    versions: dict[str, str]
    states: int
    rounds: int
    threads: int
    seed: int
    chapters: tuple[Chapter, ...]
    operations: tuple[OperationCount, ...]
    profiles: tuple[Profile, ...]

    def comparison(self, key: str, subject: str = "") -> Comparison | None:
        """One of them; None if it was not measured."""
        for chapter in self.chapters:
            for comparison in chapter.comparisons:
                if chapter.key == key and comparison.subject == subject:
                    return comparison
        return None
