"""Who does the work: threads of this process.  (`cluster` has another executor, with the same
face.)

A executor takes the blocks from a given one on, a span of them at a time, and hands back the spans'
statistics in order, so that whoever listens can say at any moment: all blocks before this one are
done.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TypeVar

from .statistics import Statistics
from .sweep_plan import Plan

__all__ = ["Executor", "Span", "fair", "in_order", "spans", "threads"]

Span = tuple[int, int]  # blocks start … stop − 1
Executor = Callable[[Plan, int], Generator[Statistics]]  # of a plan, from this block on

#: A quarter of a million states, a fraction of a second: Ctrl-C and progress need no more patience.
_MOST = 16
_SHARES = 8  # spans for each thread, so that none waits long for the last

J = TypeVar("J")
T = TypeVar("T")
F = TypeVar("F")


def spans(start: int, stop: int, batch: int) -> Iterator[Span]:
    """Blocks start … stop − 1, `batch` at a time."""
    for first in range(start, stop, batch):
        yield first, min(first + batch, stop)


def fair(blocks: int, workers: int, most: int) -> int:
    """A batch that gives every worker several, and is no larger than `most`."""
    return min(max(blocks // (_SHARES * workers), 1), most)


def threads(count: int, batch: int | None = None) -> Executor:
    """`count` threads of this process, which take `batch` blocks at a time."""

    def work(plan: Plan, start: int) -> Generator[Statistics]:
        blocks = plan.blocks - start
        todo = spans(start, plan.blocks, batch or fair(blocks, count, _MOST))
        if count == 1:
            yield from (plan.statistics(*span) for span in todo)
            return
        pool = ThreadPoolExecutor(count, "sweep")
        try:
            yield from in_order(
                todo, lambda span: pool.submit(plan.statistics, *span), _got, 2 * count
            )
        finally:
            pool.shutdown(wait=True, cancel_futures=True)

    return work


def in_order(
    todo: Iterable[J], submit: Callable[[J], F], result: Callable[[F], T], ahead: int
) -> Iterator[T]:
    """Results in order, with at most `ahead` jobs under way: memory does not grow with the work."""
    waiting: deque[F] = deque()
    for job in todo:
        waiting.append(submit(job))
        if len(waiting) >= ahead:
            yield result(waiting.popleft())
    while waiting:
        yield result(waiting.popleft())


def _got(future: Future[Statistics]) -> Statistics:
    return future.result()
