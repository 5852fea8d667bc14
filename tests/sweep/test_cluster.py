"""Many machines: a real cluster of processes, one of them killed, and the digits stay."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest
from distributed import Client, LocalCluster

from ur5check._errors import StateError, UsageError
from ur5check._sweep import dask_cluster as cluster
from ur5check._sweep import progress as sweep_progress
from ur5check._sweep.checkpoint import statistics_value
from ur5check._sweep.state_sample import BLOCK
from ur5check._sweep.sweep import sweep

STATES = 40 * BLOCK - 5


@pytest.fixture(scope="module")
def workers():
    """Two processes of one thread each, on this machine's loopback."""
    with LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=True,
        host="127.0.0.1",
        dashboard_address="127.0.0.1:0",
    ) as local:
        yield local


def pids(local) -> set[int]:
    with Client(local.scheduler_address, set_as_default=False) as client:
        return set(client.run(os.getpid).values())


def test_a_worker_killed_in_the_middle_changes_nothing(
    workers, paper, appendix, tmp_path, monkeypatch
):
    monkeypatch.setattr(sweep_progress, "_REPORT_EVERY", 0.0)
    before = pids(workers)
    killed: list[int] = []

    def kill_one(line: str) -> None:
        if not killed:
            assert line.startswith(f"{8 * BLOCK:,} of {STATES:,} states")  # in the middle
            killed.append(min(before))
            os.kill(killed[0], signal.SIGKILL)

    options = {"states": STATES, "seed": 3, "tolerance": 1.0}
    found = sweep(
        paper,
        appendix,
        **options,
        scheduler=workers.scheduler_address,
        batch=1,
        checkpoint=tmp_path / "checkpoint.json",
        progress=kill_one,
    )
    assert killed
    alone = sweep(paper, appendix, **options)
    assert statistics_value(found.statistics) == statistics_value(alone.statistics)
    assert killed[0] not in pids(workers)


def test_a_cluster_goes_on_from_what_threads_began(workers, paper, appendix, tmp_path):
    """A checkpoint does not care who writes it or who reads it."""
    file = tmp_path / "checkpoint.json"
    options = {"states": 12 * BLOCK, "checkpoint": file}

    class EnoughError(Exception):
        pass

    def stop(line: str) -> None:
        raise EnoughError

    with pytest.MonkeyPatch.context() as patch, pytest.raises(EnoughError):
        patch.setattr(sweep_progress, "_REPORT_EVERY", 0.0)
        sweep(paper, appendix, **options, batch=5, progress=stop)
    found = sweep(paper, appendix, **options, scheduler=workers.scheduler_address, batch=2)
    alone = sweep(paper, appendix, states=12 * BLOCK)
    assert statistics_value(found.statistics) == statistics_value(alone.statistics)


def test_an_error_on_a_worker_is_the_error_here(workers, paper, appendix, tmp_path):
    log = tmp_path / "run.csv"
    header = ",".join(f"{part}{i}" for part in ("q", "qd", "qdd") for i in range(1, 7))
    log.write_text(f"{header}\n{','.join(['0'] * 17)},fast\n")
    with pytest.raises(StateError, match=r"run\.csv:2: column 'qdd6' is not a finite number"):
        sweep(paper, appendix, sample=log, scheduler=workers.scheduler_address)


def test_a_worker_of_another_version_is_refused(workers, paper, appendix, monkeypatch):
    monkeypatch.setattr(cluster, "__version__", "9.9.9")
    with pytest.raises(UsageError, match=r"a worker has ur5check .*, the sweep ur5check 9\.9\.9"):
        sweep(paper, appendix, states=100, scheduler=workers.scheduler_address)


def test_nobody_at_the_address(paper, appendix, monkeypatch):
    monkeypatch.setattr(cluster, "_PATIENCE", 0.3)
    with pytest.raises(UsageError, match=r"no scheduler answers at tcp://127\.0\.0\.1:9"):
        sweep(paper, appendix, states=100, scheduler="tcp://127.0.0.1:9")
    with pytest.raises(UsageError, match="no scheduler answers"):
        sweep(paper, appendix, states=100, scheduler="nonsense://x")


def test_a_scheduler_without_workers(paper, appendix):
    with (
        LocalCluster(n_workers=0, host="127.0.0.1", dashboard_address="127.0.0.1:0") as empty,
        pytest.raises(UsageError, match="has no workers; start some"),
    ):
        sweep(paper, appendix, states=100, scheduler=empty.scheduler_address)


def test_without_dask_it_says_what_to_install():
    program = (
        "import sys; sys.modules['distributed'] = None; from ur5check import sweep; "
        "sweep('paper', 'paper', states=10, scheduler='tcp://127.0.0.1:1')"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False
    )
    assert "pip install 'ur5check[distributed]'" in done.stderr
