"""A sweep on NumPy alone has the same states, to the bit, and the same torques, to rounding."""

from __future__ import annotations

import numpy as np
import pytest

from ur5check._dynamics.compiled import kernel
from ur5check._sweep import random_states
from ur5check._sweep.sweep import sweep
from ur5check._sweep.sweep_plan import _difference

ROUNDING = 1e-12  # [N m]: machine code and NumPy, on torques of 100 N m


@pytest.fixture
def numpy_alone(monkeypatch):
    """As if llvmlite were not installed."""
    _difference.cache_clear()
    monkeypatch.setattr(kernel, "default_path", lambda: "numpy")
    monkeypatch.setattr(random_states, "_LLVM", False)
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
