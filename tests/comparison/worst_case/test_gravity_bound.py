"""At rest the difference has an upper bound, which holds, and which simple arms reach."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from examples import planar_arm, random_arm
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.worst_case import gravity_bound
from ur5check._comparison.worst_case.gravity_bound import gravity_bounds
from ur5check._comparison.worst_case.state_box import state_box
from ur5check._comparison.worst_case.worst_case import worst_cases


def doubled(arm):
    """A pair whose gravity torques differ by those of the first arm."""
    return pair_up(
        arm.with_inertias([replace(x.inertia, mass=2.0 * x.inertia.mass) for x in arm.links]), arm
    )


def bounds_of(pair):
    return gravity_bounds(pair, state_box(pair, 10.0))


def test_a_planar_arm_reaches_its_bound():
    """Stretched out, joint 1 carries m1 l1 + m2 (l1 + l2), joint 2 carries m2 l2."""
    pair = doubled(planar_arm((0.5, 0.3), (2.0, 1.0)))
    expected = 9.81 * np.array([2.0 * 0.5 + 1.0 * 0.8, 1.0 * 0.3])
    assert bounds_of(pair) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_no_state_exceeds_the_bound(seed):
    pair = doubled(random_arm(4, seed))
    box = state_box(pair, 10.0)
    q = box.draw(50_000, seed).q
    delta = ur5check.gravity_torque(pair.a, q) - ur5check.gravity_torque(pair.b, q)
    bounds = bounds_of(pair)
    assert (np.abs(delta).max(axis=0) <= bounds * (1 + 1e-9)).all()
    # Four joints, at most three of them on a grid: the bound is not far away either.
    for case in worst_cases(pair, random_states=500)[5:9]:
        assert case.value <= case.bound * (1 + 1e-9)


def test_the_ur5_is_bounded_to_two_per_cent():
    pair = pair_up(ur5check.load("paper"), ur5check.load("appendix"))
    for case in worst_cases(pair, random_states=2_000):
        assert (case.bound is not None) is case.static
        if case.static and case.starts:
            assert case.value <= case.bound * (1 + 1e-9)
            assert case.bound <= 1.02 * case.value


def test_the_factor_of_the_grid_is_needed(monkeypatch):
    """cos(q1 − 45°) cos(q2) is at most 1; on four points of the circle of q1 it is at most 0.71."""
    monkeypatch.setattr(gravity_bound, "_MOST_PER_ANGLE", 4)
    coefficients = np.zeros((3, 3))
    coefficients[1:, 1] = np.sqrt(0.5)
    bound = gravity_bound._grid_bound(coefficients)
    assert bound == pytest.approx(1.0, rel=1e-12)
    assert bound * np.cos(np.pi / 4) < 0.75  # without the factor it would be no bound


def test_no_bound_of_very_long_arms():
    assert bounds_of(doubled(planar_arm((0.1,) * 14, (1.0,) * 14))) is None
