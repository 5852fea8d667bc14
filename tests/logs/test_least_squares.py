"""Intervals of the fit hold the truth as often as they say, also where errors are correlated."""

from __future__ import annotations

import numpy as np
import pytest

from ur5check._logs.least_squares import blocks_of, fit


@pytest.mark.parametrize("memory", [0.0, 0.9])
def test_intervals_hold_the_truth_in_95_percent(memory: float) -> None:
    rng = np.random.default_rng(7)
    t = np.arange(0.0, 40.0, 0.02)
    X = np.stack([np.sin(2.1 * t), np.cos(0.7 * t), np.ones_like(t)], axis=1)
    truth = np.array([2.0, -1.0, 0.5])
    blocks = blocks_of(t, np.zeros(len(t), dtype=int), 4.0)
    held = []
    for _ in range(200):
        error = rng.normal(size=len(t))
        for k in range(1, len(t)):
            error[k] += memory * error[k - 1]
        found = fit(X, X @ truth + error, blocks)
        held.append(np.abs(found.value - truth) <= found.half_width)
    assert 0.90 <= np.mean(held) <= 0.99


def test_a_direction_that_is_not_excited_gets_no_value() -> None:
    rng = np.random.default_rng(1)
    x = rng.normal(size=400)
    found = fit(np.stack([x, x, 2.0 * x], axis=1), 6.0 * x, np.arange(400) // 20)
    assert found.rank == 1
    assert np.abs(found.value).max() < 6.0
    assert np.abs(found.residual).max() < 1e-12


def test_no_block_spans_a_gap() -> None:
    t = np.concatenate([np.arange(0.0, 10.0, 0.01), np.arange(20.0, 30.0, 0.01)])
    segment = (t > 15.0).astype(int)
    blocks = blocks_of(t, segment, 5.0)
    assert len(np.unique(blocks)) <= 41
    assert not set(blocks[segment == 0]) & set(blocks[segment == 1])
