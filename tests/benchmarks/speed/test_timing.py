"""Contestants take turns, and a different result is reported."""

from __future__ import annotations

import numpy as np
import pytest
from speed.timing import Contestant, race, ranked


def test_all_take_turns_after_one_run_that_is_not_timed() -> None:
    order: list[str] = []
    contestants = [Contestant(name, lambda name=name: order.append(name)) for name in "ab"]  # type: ignore[misc]
    race("", contestants, 3)
    assert "".join(order) == "ab" * 4


def test_one_slow_round_moves_no_median() -> None:
    (first, second) = ranked("", ["a", "b"], [[2.0, 2.0, 50.0], [1.0, 1.0, 1.0]]).timings
    assert (first.seconds, second.seconds) == (2.0, 1.0)
    assert (first.speed, second.speed) == (1.0, 2.0)
    assert first.spread > 1.0
    assert second.spread == 0.0


def test_a_time_is_for_one_unit() -> None:
    def work() -> None:
        sum(range(100_000))

    slow = race("", [Contestant("a", work)], 3).timings[0]
    shared = race("", [Contestant("a", work, 10**6)], 3).timings[0]
    assert shared.seconds < slow.seconds / 1000  # a millionth, whatever else the machine does


def test_a_different_result_is_reported() -> None:
    truth = np.arange(6.0).reshape(3, 2)
    contestants = [
        Contestant("first", lambda: truth),
        Contestant("same", truth.copy),
        Contestant("fewer", lambda: truth[:2] + 1e-3),
        Contestant("silent", lambda: None),
    ]
    deviations = [timing.deviation for timing in race("", contestants, 1).timings]
    assert deviations[:2] == [None, 0.0]
    assert deviations[2] == pytest.approx(1e-3)
    assert deviations[3] is None
