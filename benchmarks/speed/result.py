"""Results of a benchmark.

Benchmark ── Chapter ── Comparison ── Timing     timed in turns
          ├─ OperationCount                      operations at one state
          └─ Profile                             the time of a command, by part
"""

from __future__ import annotations

from dataclasses import dataclass

from ur5check._dynamics.symbolic.program import Operations
from ur5check._robot.serial_arm import SerialArm

__all__ = ["Benchmark", "Chapter", "Comparison", "OperationCount", "Profile", "Timing"]


@dataclass(frozen=True)
class Timing:
    """One contestant.

    seconds : median over the rounds, for one unit of the chapter [s]
    spread : half the rounds lie within so much of each other, as a share of the median
    speed : ratio to the first contestant of the comparison
    deviation : largest difference from the first contestant's result, in its unit; None where
        there is no result to compare
    """

    name: str
    seconds: float
    spread: float
    speed: float
    deviation: float | None = None


@dataclass(frozen=True)
class Comparison:
    """Contestants that do the same work.

    subject : the work, where a chapter has several ("mass matrix", "12 joints")
    """

    subject: str
    timings: tuple[Timing, ...]

    def seconds(self, name: str) -> float | None:
        """The time of a contestant; None if it did not take part."""
        return next((t.seconds for t in self.timings if t.name == name), None)


@dataclass(frozen=True)
class Chapter:
    """One measurement.

    unit : of a time ("state", "process")
    method : how it was measured, in sentences
    series : whether its comparisons are one at growing sizes
    """

    key: str
    title: str
    unit: str
    method: str
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

    machine : its processor, cores and system;  versions : of the measured libraries
    states, rounds, threads, seed : the options
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
        """The comparison of a chapter; None if it was not measured."""
        for chapter in self.chapters:
            for comparison in chapter.comparisons:
                if chapter.key == key and comparison.subject == subject:
                    return comparison
        return None
