"""How far a sweep is: said aloud now and then, and kept on disk."""

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

_SAY_EVERY = 5.0  # [s]


class SweepProgress:
    """Takes statistics in the order of their blocks.  Leaving it, even by Ctrl-C, saves what is
    done.

    done : where to go on from, if anywhere
    """

    def __init__(
        self,
        plan: Plan,
        path: Path | None,
        every: float,
        done: Checkpoint | None,
        say: Callable[[str], None],
    ) -> None:
        self._plan, self._path, self._every, self._say = plan, path, every, say
        self._done = done
        self._saved = done
        self._began = self._said = self._written = monotonic()
        self._first = 0 if done is None else done.statistics.count
        if done is not None:
            self._say(f"going on from {path}: {self._first:,} states are done")

    @property
    def blocks(self) -> int:
        """Blocks done, from the first on."""
        return 0 if self._done is None else self._done.blocks

    @property
    def statistics(self) -> Statistics:
        """Of all that is done."""
        if self._done is None:
            raise ValueError("nothing is done yet")
        return self._done.statistics

    def add(self, statistics: Statistics) -> None:
        """The next blocks' statistics."""
        blocks = self.blocks + -(-statistics.count // BLOCK)
        whole = statistics if self._done is None else self._done.statistics.merge(statistics)
        self._done = Checkpoint(blocks, whole)
        now = monotonic()
        if now - self._said >= _SAY_EVERY:
            self._said = now
            self._say(self._sentence())
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
            self._say(self._summary())
        elif self._path is not None and self._done is not None:
            self._say(
                f"{self._path} keeps {self.statistics.count:,} states; the same command goes on"
            )

    def _save(self) -> None:
        if self._path is not None and self._done is not None and self._done is not self._saved:
            save(self._path, self._plan, self._done)
            self._saved = self._done

    def _rate(self) -> float:
        """States a second, of those done here."""
        return (self.statistics.count - self._first) / max(monotonic() - self._began, 1e-9)

    def _sentence(self) -> str:
        count, total, rate = self.statistics.count, self._plan.sample.count, self._rate()
        left = duration((total - count) / rate)
        return f"{count:,} of {total:,} states, {rate:,.0f} a second, {left} left"

    def _summary(self) -> str:
        count, rate = self.statistics.count - self._first, self._rate()
        return f"{count:,} states in {monotonic() - self._began:.1f} s, {rate:,.0f} a second"


def duration(seconds: float) -> str:
    """`40 s`, `12 min`, `3.5 h`, `2.1 days`."""
    for limit, unit, name in ((120, 1, "s"), (7200, 60, "min"), (172_800, 3600, "h")):
        if seconds < limit:
            return f"{seconds / unit:.{0 if unit < 3600 else 1}f} {name}"
    return f"{seconds / 86_400:.1f} days"
