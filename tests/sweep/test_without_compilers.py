"""A sweep on NumPy alone sees the same states, to the bit, and the same torques, to rounding."""

from __future__ import annotations

import numpy as np
import pytest

from ur5check._dynamics.compiled import kernel
from ur5check._sweep import loop_choice as loops
from ur5check._sweep import numpy_loops as rows
from ur5check._sweep.sweep import sweep
from ur5check._sweep.sweep_plan import _difference

ROUNDING = 1e-12  # [N m]: machine code and NumPy, on torques of 100 N m


@pytest.fixture
def numpy_alone(monkeypatch):
    """As if neither LLVM nor Numba were installed."""
    _difference.cache_clear()
    monkeypatch.setattr(kernel, "default_path", lambda: "numpy")
    monkeypatch.setattr(loops, "_NUMBA", False)
    yield
    _difference.cache_clear()


def test_torques_to_rounding(paper, appendix, numpy_alone, monkeypatch):
    plain = sweep(paper, appendix, states=5_000, seed=4, tolerance=1.0)
    assert plain.plan.engine == "numpy"
    monkeypatch.undo()
    _difference.cache_clear()
    found = sweep(paper, appendix, states=5_000, seed=4, tolerance=1.0)
    assert found.plan.engine == "llvm"
    np.testing.assert_allclose(plain.rms, found.rms, rtol=1e-12)
    np.testing.assert_allclose(plain.maximum, found.maximum, rtol=0, atol=ROUNDING)
    for joint in range(6):
        for one, other in zip(
            plain.worst_state(joint).values(), found.worst_state(joint).values(), strict=True
        ):
            assert np.array_equal(one, other)


def test_random_numbers_and_counts_to_the_bit():
    width, lower = np.array([2.0, 3.0, 1e-3]), np.array([-1.0, 0.5, 0.0])
    one, other = (way.drawn(7, 2**40 + 1, width, lower, 1000) for way in (rows, loops))
    assert np.array_equal(one, other)
    assert not np.array_equal(one, rows.drawn(7, 2**40 + 2, width, lower, 1000))
    plain, found = (way.row_statistics(one[0], 0.25) for way in (rows, loops))
    assert np.array_equal(plain.bins, found.bins)
    assert (plain.where, plain.passed) == (found.where, found.passed)
