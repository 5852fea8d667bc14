"""The progress of a sweep: reported every few seconds, and saved as a checkpoint."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from time import monotonic
from types import TracebackType

from .checkpoint import Checkpoint, save
from .state_sample import BLOCK
from .statistics import Statistics
from .sweep_plan import Plan

__all__ = ["SweepProgress"]

_REPORT_EVERY = 5.0  # [s]


class SweepProgress:
    """Merges statistics in the order of their blocks; on exit, even by Ctrl-C, it saves them.

    path : of the checkpoint, or None;  every : seconds between two checkpoints
    done : the checkpoint to resume from, or None
    report : called with a sentence about the progress
    """

    def __init__(
        self,
        plan: Plan,
        path: Path | None,
        every: float,
        done: Checkpoint | None,
        report: Callable[[str], None],
    ) -> None:
        self._plan, self._path, self._every, self._report = plan, path, every, report
        self._done = done
        self._saved = done
        self._began = self._reported = self._written = monotonic()
        self._first = 0 if done is None else done.statistics.count
        if done is not None:
            self._report(f"resuming from {path}: {self._first:,} states are done")

    @property
    def blocks(self) -> int:
        """Number of blocks done, from the first on."""
        return 0 if self._done is None else self._done.blocks

    @property
    def statistics(self) -> Statistics:
        """Of all blocks done."""
        if self._done is None:
            raise ValueError("nothing is done yet")
        return self._done.statistics

    def add(self, statistics: Statistics) -> None:
        """The next blocks' statistics."""
        blocks = self.blocks + -(-statistics.count // BLOCK)
        whole = statistics if self._done is None else self._done.statistics.merge(statistics)
        self._done = Checkpoint(blocks, whole)
        now = monotonic()
        if now - self._reported >= _REPORT_EVERY:
            self._reported = now
            self._report(self._sentence())
        if now - self._written >= self._every:
            self._save()
            self._written = monotonic()

    def __enter__(self) -> SweepProgress:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._save()
        if kind is None:
            self._report(self._summary())
        elif self._path is not None and self._done is not None:
            self._report(
                f"{self._path} holds {self.statistics.count:,} states; repeat the command to resume"
            )

    def _save(self) -> None:
        if self._path is not None and self._done is not None and self._done is not self._saved:
            save(self._path, self._plan, self._done)
            self._saved = self._done

    def _rate(self) -> float:
        """States per second since the start or the resumption."""
        return (self.statistics.count - self._first) / max(monotonic() - self._began, 1e-9)

    def _sentence(self) -> str:
        count, total, rate = self.statistics.count, self._plan.sample.count, self._rate()
        left = duration((total - count) / rate)
        return f"{count:,} of {total:,} states, {rate:,.0f} per second, {left} left"

    def _summary(self) -> str:
        count, rate = self.statistics.count - self._first, self._rate()
        return f"{count:,} states in {monotonic() - self._began:.1f} s, {rate:,.0f} per second"


def duration(seconds: float) -> str:
    """`40 s`, `12 min`, `3.5 h`, `2.1 days`."""
    for limit, unit, name in ((120, 1, "s"), (7200, 60, "min"), (172_800, 3600, "h")):
        if seconds < limit:
            return f"{seconds / unit:.{0 if unit < 3600 else 1}f} {name}"
    return f"{seconds / 86_400:.1f} days"
