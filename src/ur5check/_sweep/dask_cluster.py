r"""The executor for many machines: spans of blocks as tasks of a Dask cluster.

    span  span  span  span   …   one task each, on any free worker
       \   |     |   /
          batch              …   merged on a worker; only this is sent back

A task is a pure function of the plan and its span.  When a worker dies, Dask runs its tasks on
another, with the same digits.
"""

from __future__ import annotations

import pickle
from collections.abc import Generator, Iterable, Iterator
from concurrent.futures import CancelledError
from functools import lru_cache
from itertools import islice
from typing import Any

import numpy as np

from .._errors import UsageError
from .._version import __version__
from .executor import Executor, Span, batch_size, in_order, spans
from .statistics import Statistics, merged
from .sweep_plan import Plan

__all__ = ["cluster"]

_MOST = 1024  # blocks per task: seconds, against milliseconds for its scheduling
_BATCH_NODE = 8  # spans that are merged before they are sent
_AHEAD = 2  # unfinished tasks per thread of the workers
_PATIENCE = 10.0  # [s] for the scheduler to answer


def cluster(address: str, batch: int | None = None) -> Executor:
    """The workers of the scheduler at `address` ("tcp://192.0.2.7:8786"), `batch` blocks per task.

    The executor raises UsageError if no scheduler answers, or if its workers have other versions or
    another engine than this process.
    """

    def work(plan: Plan, start: int) -> Generator[Statistics]:
        payload, expected = pickle.dumps(plan), _versions(plan)
        with _client(address) as client:

            def batch_node(group: tuple[Span, ...]) -> Any:
                tasks = [
                    client.submit(_task, payload, expected, span, pure=False) for span in group
                ]
                return client.submit(merged, tasks, pure=False)

            workers = sum(client.nthreads().values())
            blocks = plan.blocks - start
            todo = spans(start, plan.blocks, batch or batch_size(blocks, workers, _MOST))
            ahead = 2 + _AHEAD * workers // _BATCH_NODE
            yield from in_order(_batch_nodes(todo), batch_node, _got, ahead)

    return work


def _batch_nodes(todo: Iterable[Span]) -> Iterator[tuple[Span, ...]]:
    rest = iter(todo)
    while batch_node := tuple(islice(rest, _BATCH_NODE)):
        yield batch_node


def _client(address: str) -> Any:
    try:
        from distributed import Client
    except ImportError:
        raise UsageError(
            "a cluster needs Dask; install it with `pip install 'ur5check[distributed]'`"
        ) from None
    try:
        client: Any = Client(  # type: ignore[no-untyped-call]
            address, timeout=_PATIENCE, set_as_default=False
        )
    except (OSError, ValueError) as error:
        raise UsageError(
            f"no scheduler answers at {address} ({error}); start one with `dask scheduler`"
        ) from None
    if not client.nthreads():
        client.close()
        raise UsageError(
            f"the scheduler at {address} has no workers; start some with `dask worker {address}`"
        )
    return client


def _got(future: Any) -> Statistics:
    from distributed import KilledWorker

    try:
        statistics: Statistics = future.result()
    except KilledWorker as error:
        raise UsageError(f"workers died while computing; see their logs ({error})") from None
    except CancelledError:
        raise UsageError(
            "the connection to the scheduler was lost; restart it, and resume with --checkpoint"
        ) from None
    return statistics


def _task(payload: bytes, expected: dict[str, str], span: Span) -> Statistics:
    """One task, run on a worker."""
    plan = _plan(payload)
    if (ours := _versions(plan)) != expected:
        raise UsageError(
            f"a worker has {_listed(ours)}, the sweep {_listed(expected)}; install the same on both"
        )
    return plan.statistics(*span)


@lru_cache(maxsize=4)
def _plan(payload: bytes) -> Plan:
    """Unpacked once per process, so that a kernel is compiled once."""
    plan: Plan = pickle.loads(payload)  # noqa: S301 - a cluster executes what its client sends
    return plan


def _versions(plan: Plan) -> dict[str, str]:
    """What two processes must have in common to give the same digits."""
    return {"ur5check": __version__, "numpy": np.__version__, "engine": plan.engine}


def _listed(versions: dict[str, str]) -> str:
    return ", ".join(f"{name} {version}" for name, version in versions.items())
