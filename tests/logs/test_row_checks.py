"""Rows that cannot be right are left out, each kind as a finding with its row; right ones stay."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from logs.recorded import Motion
from ur5check import Ur5checkError
from ur5check._finding import Finding
from ur5check._logs.recording import Recording
from ur5check._logs.row_checks import kept_rows
from ur5check._robot.transforms import Array
from ur5check._rules.finding_log import FindingLog


def recording_of(table: Array) -> Recording:
    """Of columns t, q, qd, tau."""
    n = (table.shape[1] - 1) // 3
    t, q, qd, tau = np.split(table, np.cumsum([1, n, n]), axis=1)
    joints = tuple(f"joint {k + 1}" for k in range(n))
    return Recording("run.csv", joints, t[:, 0], q, qd, tau, np.arange(1, len(table) + 1))


def kept(table: Array) -> tuple[Recording, list[Finding]]:
    log = FindingLog()
    return kept_rows(recording_of(table), log), log.findings


def test_a_good_recording_is_kept_whole(motion: Motion) -> None:
    recording, findings = kept(motion.table())
    assert recording.count == len(motion.t)
    assert findings == []


def not_a_number(table: Array) -> Array:
    table[40, 2] = np.nan
    return table


def garbage_with_zeros(table: Array) -> Array:
    # The first row is right, but nothing tells it from the rows after it.
    table[1:10, 1:] = 0.0
    table[1:10:2, 1:] = 3.1e154
    return table


def zeros(table: Array) -> Array:
    table[300:306, 1:] = 0.0
    return table


def repeated(table: Array) -> Array:
    table[77, 0] = table[76, 0]
    return table


def clock_set_back(table: Array) -> Array:
    table[500:530, 0] -= 2.0
    return table


def gap(table: Array) -> Array:
    return np.delete(table, slice(800, 870), axis=0)


def jitter(table: Array) -> Array:
    steps = np.random.default_rng(1).uniform(0.002, 0.014, len(table))
    table[:, 0] = np.cumsum(steps)
    return table


@pytest.mark.parametrize(
    ("spoil", "rule", "row", "dropped"),
    [
        (not_a_number, "LOG101", 41, 1),
        (garbage_with_zeros, "LOG101", 2, 10),
        (zeros, "LOG104", 301, 6),
        (repeated, "LOG102", 78, 1),
        (clock_set_back, "LOG102", 501, 30),
        (gap, "LOG105", 801, 0),
        (jitter, "LOG106", 0, 0),
    ],
)
def test_what_is_wrong_is_found_where_it_stands(
    motion: Motion, spoil: Callable[[Array], Array], rule: str, row: int, dropped: int
) -> None:
    table = spoil(motion.table().copy())
    recording, findings = kept(table)
    found = {finding.rule: finding for finding in findings}
    assert rule in found
    assert found[rule].places[0].line == row
    assert len(table) - recording.count == dropped
    assert np.abs(recording.q).max() < 10.0


def test_a_recording_without_usable_rows_is_refused(motion: Motion) -> None:
    table = motion.table()[:100].copy()
    table[10:, 1] = np.nan
    with pytest.raises(Ur5checkError, match="only 10 usable rows"):
        kept(table)
