"""Who does the work: threads of this process.  (`cluster` has another crew, with the same face.)

A crew takes spans of blocks and hands back their tallies in the spans' order, so that whoever
listens can say at any moment: all blocks before this one are done.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TypeVar

from .plan import Plan
from .tally import Tally

__all__ = ["Crew", "Span", "in_order", "spans", "threads"]

Span = tuple[int, int]  # blocks start … stop − 1
Crew = Callable[[Plan, Iterable[Span]], Generator[Tally]]

J = TypeVar("J")
T = TypeVar("T")
F = TypeVar("F")


def spans(start: int, stop: int, batch: int) -> Iterator[Span]:
    """Blocks start … stop − 1, `batch` at a time."""
    for first in range(start, stop, batch):
        yield first, min(first + batch, stop)


def threads(count: int) -> Crew:
    """`count` threads of this process."""

    def work(plan: Plan, todo: Iterable[Span]) -> Generator[Tally]:
        if count == 1:
            yield from (plan.tally(*span) for span in todo)
            return
        pool = ThreadPoolExecutor(count, "sweep")
        try:
            yield from in_order(todo, lambda span: pool.submit(plan.tally, *span), _got, 2 * count)
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


def _got(future: Future[Tally]) -> Tally:
    return future.result()
