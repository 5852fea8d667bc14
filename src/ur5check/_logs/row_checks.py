"""Rows of a recording that cannot be right: garbage, repeated or turned-back time, gaps.

Positions move continuously: a row is kept where it can be reached from its neighbours at a speed
that a robot has.  A short run of rows between two jumps is garbage, whatever it holds; a long one
is a part of the recording of its own.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from .._errors import UsageError
from .._finding import Place
from .._rules.finding_log import FindingLog
from .recording import Recording

__all__ = ["GAP", "kept_rows"]

#: A step of the clock longer than this many median steps is a gap.
GAP = 5.0

#: A jump is a speed beyond this many times that of the 99th percentile of the recording; never
#: below the first [rad/s or m/s], which industrial wrists reach, and always above the second, twice
#: that of the fastest delta robots.
_JUMP, _FAST, _FASTEST = 10.0, 10.0, 60.0

#: Fewer rows than this between two jumps are garbage.
_SHORTEST = 20

#: Beyond this no position [rad, m], velocity [1/s], torque [N m] or current [A] is a measurement.
_LARGEST = {"q": 1e4, "qd": 1e4, "tau": 1e6, "current": 1e5, "model_tau": 1e6}


def kept_rows(recording: Recording, log: FindingLog) -> Recording:
    """The recording without the rows that cannot be right; each kind is a finding.

    Raises UsageError where fewer than 2 · _SHORTEST rows are left.
    """
    recording = _drop(recording, ~_readable(recording), "LOG101", "hold no finite number", log)
    recording = _drop(recording, ~_forward(recording), "LOG102", "repeat or turn back time", log)
    recording = _drop(
        recording, _garbage(recording), "LOG104", "cannot be reached from the rows beside them", log
    )
    if recording.count < 2 * _SHORTEST:
        raise UsageError(
            f"{recording.file}: only {recording.count} usable rows; record more, or say what the "
            "columns are: --columns"
        )
    _clock(recording, log)
    return recording


def _drop(
    recording: Recording, bad: NDArray[np.bool_], rule: str, what: str, log: FindingLog
) -> Recording:
    count = int(bad.sum())
    if not count:
        return recording
    first = int(np.flatnonzero(bad)[0])
    log.add(
        rule,
        "rows",
        f"{count} row{'s' if count > 1 else ''} of {recording.count} {what}: left out",
        place_of(recording, first),
        value=float(count),
        bound=0.0,
    )
    return recording.selected(~bad)


def place_of(recording: Recording, sample: int) -> Place:
    """Where a sample stands in its file."""
    return Place(recording.file, int(recording.rows[sample]))


def _readable(recording: Recording) -> NDArray[np.bool_]:
    good = np.isfinite(recording.t)
    for name, largest in _LARGEST.items():
        values = getattr(recording, name)
        if values is not None:
            with np.errstate(invalid="ignore"):
                good &= (np.abs(values) < largest).all(axis=1)
    return good


def _forward(recording: Recording) -> NDArray[np.bool_]:
    """Rows whose time lies after that of every row before them."""
    t = recording.t
    latest = np.maximum.accumulate(t)
    return np.concatenate([[True], t[1:] > latest[:-1]])


def _garbage(recording: Recording) -> NDArray[np.bool_]:
    t, q = recording.t, recording.q
    if recording.count < 2:
        return np.zeros(recording.count, dtype=bool)
    step = np.diff(t)
    # Clock jitter must not turn a slow motion into a jump: at least the median step counts.
    speed = np.abs(np.diff(q, axis=0)).max(axis=1) / np.maximum(step, np.median(step))
    fastest = float(np.clip(_JUMP * np.quantile(speed, 0.99), _FAST, _FASTEST))
    jumps = np.flatnonzero(speed > fastest) + 1
    bad = np.zeros(recording.count, dtype=bool)
    edges = [0, *jumps.tolist(), recording.count]
    for begin, end in pairwise(edges):
        if end - begin < _SHORTEST and len(edges) > 2:
            bad[begin:end] = True
    return bad


def _clock(recording: Recording, log: FindingLog) -> None:
    step = np.diff(recording.t)
    median = float(np.median(step))
    gaps = np.flatnonzero(step > GAP * median)
    if len(gaps):
        log.add(
            "LOG105",
            "clock",
            f"{len(gaps)} gap{'s' if len(gaps) > 1 else ''}, the longest of {step.max():.3g} s",
            place_of(recording, int(gaps[0]) + 1),
            value=float(step.max()),
            bound=GAP * median,
            unit="s",
        )
    shortest, longest = np.percentile(step, (1, 99)).tolist()
    jitter = longest - shortest
    nominal = recording.duration / (recording.count - 1)
    if jitter > 0.5 * median or abs(nominal / median - 1.0) > 0.01:
        log.add(
            "LOG106",
            "clock",
            f"steps of {1e3 * shortest:.3g} to {1e3 * longest:.3g} ms; the file's times are used",
            Place(recording.file),
            value=jitter,
            bound=0.5 * median,
            unit="s",
        )
