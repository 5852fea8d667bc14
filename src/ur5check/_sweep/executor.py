"""Executors of a sweep: threads of this process (`dask_cluster` has another, for many machines).

An executor computes the blocks from a given one on, a span of blocks per task, and yields the
statistics of the spans in order, so that at any moment all blocks before the last one yielded are
done.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TypeVar

from .statistics import Statistics
from .sweep_plan import Plan

__all__ = ["Executor", "Span", "batch_size", "in_order", "spans", "threads"]

Span = tuple[int, int]  # blocks start … stop − 1
Executor = Callable[[Plan, int], Generator[Statistics]]  # of a plan, from a block on

#: Blocks per task: a fraction of a second, for progress and Ctrl-C.
_MOST = 16
_SHARES = 8  # tasks per worker, so that none waits long for the last

J = TypeVar("J")
T = TypeVar("T")
F = TypeVar("F")


def spans(start: int, stop: int, batch: int) -> Iterator[Span]:
    """Blocks start … stop − 1, `batch` at a time."""
    for first in range(start, stop, batch):
        yield first, min(first + batch, stop)


def batch_size(blocks: int, workers: int, most: int) -> int:
    """A batch of at most `most` blocks that gives every worker several tasks."""
    return min(max(blocks // (_SHARES * workers), 1), most)


def threads(count: int, batch: int | None = None) -> Executor:
    """`count` threads of this process, with `batch` blocks per task."""

    def work(plan: Plan, start: int) -> Generator[Statistics]:
        blocks = plan.blocks - start
        todo = spans(start, plan.blocks, batch or batch_size(blocks, count, _MOST))
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
    """Results in order, with at most `ahead` unfinished jobs, so that memory is bounded."""
    waiting: deque[F] = deque()
    for job in todo:
        waiting.append(submit(job))
        if len(waiting) >= ahead:
            yield result(waiting.popleft())
    while waiting:
        yield result(waiting.popleft())


def _got(future: Future[Statistics]) -> Statistics:
    return future.result()
