"""The recursion as an engine that steps in time."""

from __future__ import annotations

import numpy as np

import ur5check
from ur5check._dynamics.equations import acceleration_of
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._robot.states import random_states

ARM = ur5check.load("appendix")
STATE = random_states(6, 1, seed=1)
Q, QD, TAU = STATE.q[0], STATE.qd[0], np.array([10.0, -40.0, 5.0, 1.0, 2.0, 0.5])


def end_of(steps: int) -> np.ndarray:
    engine, q, qd = RecursionEngine(ARM), Q, QD
    for _ in range(steps):
        q, qd = engine.step(q, qd, TAU, 0.05 / steps)
    return np.concatenate([q, qd])


def test_a_step_is_of_order_eight():
    exact = end_of(64)
    errors = [np.abs(end_of(steps) - exact).max() for steps in (1, 2)]
    assert errors[0] / errors[1] > 2.0**7.0
    assert errors[1] < 1e-6


def test_a_short_step_follows_the_acceleration_under_the_engines_gravity():
    g, dt = np.array([1.0, -2.0, 3.0]), 1e-5
    engine = RecursionEngine(ARM, g)
    _, qd = engine.step(Q, QD, TAU, dt)
    qdd = acceleration_of(ARM, g)(Q, QD, TAU)
    np.testing.assert_allclose((qd - QD) / dt, qdd, rtol=1e-3, atol=1e-3 * np.abs(qdd).max())
    np.testing.assert_allclose(qdd, engine.forward_dynamics(Q, QD, TAU), rtol=1e-10)
    assert np.abs(qdd - acceleration_of(ARM)(Q, QD, TAU)).max() > 1.0
