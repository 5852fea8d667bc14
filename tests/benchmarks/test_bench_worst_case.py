"""The benchmark of the worst-case search: its pairs, and the brute force that it compares with."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from repository import REPOSITORY
from ur5check import pair_up, worst_cases
from ur5check._robot import Inertia, Joint, Link, SerialArm, Transform

sys.path.insert(0, str(REPOSITORY / "benchmarks"))

import bench_worst_case as bench

LENGTH, G, ACCELERATION = 0.7, 9.81, 10.0


def pendulum(mass):
    body = Inertia(mass, np.zeros(3), np.zeros((3, 3)))
    tip = Transform.translation((LENGTH, 0, 0))
    return SerialArm("pendulum", (Joint("hinge", (0, 1, 0)),), (Link("rod", tip, body),))


def test_halves_share_no_pair():
    assert not set(bench.TUNING) & set(bench.REPORTING)
    assert len(bench.REPORTING) >= 10


@pytest.mark.parametrize("seed", [1, 2, 101, 110])
def test_a_pair_has_seven_joints_and_differs_in_every_body(seed):
    pair = bench.pair_of(seed)
    assert pair.a.n == 7
    assert pair.alignment.exact
    apart = pair.parameter_difference().reshape(7, 10)
    assert (np.abs(apart) > 0.0).all(axis=1).all()
    sliding = [joint.kind for joint in pair.a.joints].count("prismatic")
    assert sliding == seed % 2


def test_brute_force_finds_what_theory_says_and_so_does_the_search():
    """Δτ = Δm l (l q̈ − g cos q)."""
    pair = pair_up(pendulum(3.0), pendulum(2.0))
    expected = LENGTH * (G + ACCELERATION * LENGTH)
    (found,) = bench.brute_force(pair, 2_400, seed=0)
    assert found == pytest.approx(expected, rel=1e-6)
    assert worst_cases(pair, random_states=100)[0].value == pytest.approx(expected, rel=1e-9)


def test_a_search_that_stops_early_is_seen(monkeypatch):
    """Random states alone stay below brute force."""
    from ur5check._comparison.worst_case import worst_case

    pair = pair_up(pendulum(3.0), pendulum(2.0))
    monkeypatch.setattr(worst_case, "ascend", lambda gap, box, starts, *_, **__: starts)
    monkeypatch.setattr(worst_case, "STATES_PER_START", 1)
    found = worst_case.worst_cases(pair, starts=2, random_states=10)[0].value
    assert found < 0.99 * float(bench.brute_force(pair, 2_400, seed=0)[0])
