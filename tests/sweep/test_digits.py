"""The digits depend on neither threads, batches nor interruptions."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from ur5check._errors import UsageError
from ur5check._sweep import progress as sweep_progress
from ur5check._sweep.checkpoint import statistics_value
from ur5check._sweep.executor import threads
from ur5check._sweep.state_sample import BLOCK
from ur5check._sweep.statistics import merged
from ur5check._sweep.sweep import sweep

STATES = 6 * BLOCK + 100


def digits(found) -> dict:
    return statistics_value(found.statistics)


@pytest.fixture(scope="module")
def whole(paper, appendix):
    return sweep(paper, appendix, states=STATES, seed=11, tolerance=1.0)


@pytest.mark.parametrize("options", [{"threads": 2, "batch": 1}, {"threads": 3}, {"batch": 4}])
def test_no_digit_depends_on_how_the_work_is_shared(paper, appendix, whole, options):
    shared = sweep(paper, appendix, states=STATES, seed=11, tolerance=1.0, **options)
    assert digits(shared) == digits(whole)


def test_merging_is_the_same_in_any_order_and_grouping(whole):
    parts = [whole.plan.statistics(k, k + 1) for k in range(whole.plan.blocks)]
    mixed = [parts[k] for k in (3, 6, 0, 5, 1, 4, 2)]
    halves = [merged(mixed[:2]), merged(mixed[2:])]
    assert statistics_value(merged(halves)) == digits(whole)


def test_merging_changes_none_of_the_parts(whole):
    parts = [whole.plan.statistics(k, k + 1) for k in range(3)]
    before = [statistics_value(part) for part in parts]
    merged(parts)
    parts[0].merge(parts[1])
    assert [statistics_value(part) for part in parts] == before


def test_of_equal_maxima_the_earlier_state_is_kept(whole):
    statistics = whole.plan.statistics(0, 1)
    later = whole.plan.statistics(0, 1)
    object.__setattr__(later, "worst", statistics.worst + BLOCK)
    for both in (statistics.merge(later), later.merge(statistics)):
        assert (both.worst == statistics.worst).all()


def test_another_seed_gives_other_digits(paper, appendix, whole):
    other = sweep(paper, appendix, states=STATES, seed=12, tolerance=1.0)
    assert digits(other) != digits(whole)


class InterruptionError(Exception):
    """Raised in the middle of a sweep."""


@pytest.mark.parametrize("how", [{}, {"threads": 2}])
def test_an_interrupted_sweep_goes_on_to_the_same_digits(
    paper, appendix, whole, tmp_path, monkeypatch, how
):
    monkeypatch.setattr(sweep_progress, "_REPORT_EVERY", 0.0)
    file = tmp_path / "checkpoint.json"
    lines: list[str] = []

    def interrupt(line: str) -> None:
        lines.append(line)
        if len(lines) == 3:
            raise InterruptionError

    options = {
        "states": STATES,
        "seed": 11,
        "tolerance": 1.0,
        "batch": 1,
        "checkpoint": file,
        **how,
    }
    with pytest.raises(InterruptionError):
        sweep(paper, appendix, **options, progress=interrupt)
    assert json.loads(file.read_text())["blocks"] == 3
    again = sweep(paper, appendix, **options, progress=lines.append)
    assert any("resuming" in line and f"{3 * BLOCK:,}" in line for line in lines)
    assert digits(again) == digits(whole)
    assert list(tmp_path.iterdir()) == [file]
    # And once more: nothing is left to do.
    assert digits(sweep(paper, appendix, **options)) == digits(whole)


def test_a_killed_process_loses_only_what_is_not_on_disk(paper, appendix, tmp_path):
    file = tmp_path / "checkpoint.json"
    program = (
        "from ur5check import sweep; "
        f"sweep('paper', 'appendix', states={15 * STATES}, seed=11, tolerance=1.0, batch=1, "
        f"checkpoint={str(file)!r}, checkpoint_every=0.0)"
    )
    process = subprocess.Popen([sys.executable, "-c", program])
    while not file.exists() and process.poll() is None:
        time.sleep(0.02)
    process.send_signal(signal.SIGKILL)
    process.wait()
    kept = json.loads(file.read_text())
    assert kept["blocks"] < 15 * 6
    long = sweep(paper, appendix, states=kept["blocks"] * BLOCK, seed=11, tolerance=1.0)
    assert kept["statistics"] == digits(long)


def change(file: Path, **values) -> None:
    kept = json.loads(file.read_text())
    file.write_text(json.dumps({**kept, **values}))


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"seed": 12}, "sample"),
        ({"states": STATES + 1}, "states"),
        ({"tolerance": 2.0}, "tolerance"),
        ({"gravity": (0, 0, -1.6)}, "model A, model B"),
        ({"sample": "sobol"}, "sample"),
        ({"within_limits": True}, "sample"),
    ],
)
def test_the_checkpoint_of_another_sweep_is_refused(paper, appendix, tmp_path, options, named):
    file = tmp_path / "checkpoint.json"
    given = {"states": STATES, "seed": 11, "tolerance": 1.0, "checkpoint": file}
    sweep(paper, appendix, **{**given, "states": BLOCK})
    before = file.read_bytes()
    if "states" not in options:
        given["states"] = BLOCK
    with pytest.raises(UsageError, match=rf"another sweep \(different: {named}\)"):
        sweep(paper, appendix, **{**given, **options})
    assert file.read_bytes() == before


def test_another_model_and_another_version_are_refused(paper, appendix, tmp_path):
    file = tmp_path / "checkpoint.json"
    sweep(paper, appendix, states=100, checkpoint=file)
    with pytest.raises(UsageError, match=r"different: model B\)"):
        sweep(paper, paper, states=100, checkpoint=file)
    change(file, of={**json.loads(file.read_text())["of"], "version": "0.0.1"})
    with pytest.raises(UsageError, match=r"different: version\)"):
        sweep(paper, appendix, states=100, checkpoint=file)


@pytest.mark.parametrize(
    "content", [b"", b"{", b"[]", b'{"format": "other"}', b"\xff\xfe", b'{"blocks": 3}']
)
def test_what_is_no_checkpoint_is_refused(paper, appendix, tmp_path, content):
    file = tmp_path / "checkpoint.json"
    file.write_bytes(content)
    with pytest.raises(UsageError, match="checkpoint"):
        sweep(paper, appendix, states=100, checkpoint=file)
    assert file.read_bytes() == content


def test_a_truncated_checkpoint_is_refused(paper, appendix, tmp_path):
    file = tmp_path / "checkpoint.json"
    sweep(paper, appendix, states=100, checkpoint=file)
    value = json.loads(file.read_text())
    del value["statistics"]["worst"]
    file.write_text(json.dumps(value))
    with pytest.raises(UsageError, match="is not a checkpoint"):
        sweep(paper, appendix, states=100, checkpoint=file)


def test_a_checkpoint_without_a_folder_is_refused_before_any_work(paper, appendix, tmp_path):
    with pytest.raises(UsageError, match="there is no such folder"):
        sweep(paper, appendix, states=10**12, checkpoint=tmp_path / "no" / "checkpoint.json")


@pytest.mark.parametrize("count", [1, 2])
def test_an_error_in_a_block_ends_the_sweep(whole, count):
    def broken(start: int, stop: int):
        raise InterruptionError

    class Broken:
        statistics = staticmethod(broken)
        blocks = 2

    with pytest.raises(InterruptionError):
        list(threads(count)(Broken, 0))


def test_digits_would_show_a_lost_block(whole):
    """The comparison above can fail: one block less is another statistics."""
    assert statistics_value(whole.plan.statistics(0, whole.plan.blocks - 1)) != digits(whole)
    assert np.isfinite(whole.rms).all()
