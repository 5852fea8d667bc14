"""The recursion runs on symbols as it runs on numbers."""

from __future__ import annotations

import numpy as np
import sympy

import ur5check
from examples import planar_arm
from ur5check._dynamics.batching import JointState
from ur5check._dynamics.chain_constants import chain_of
from ur5check._dynamics.recursion import joint_torques


def test_the_recursion_traces_into_a_closed_form():
    arm = planar_arm((0.5, 0.3), (3.0, 2.0))
    q, qd, qdd = (sympy.symbols(f"{name}1:3") for name in ("q", "v", "a"))
    state = JointState(q, [sympy.cos(x) for x in q], [sympy.sin(x) for x in q], qd, qdd)
    chain = chain_of(arm)
    closed = joint_torques(chain, state, chain.inner_gravity(arm.gravity))
    values = [0.3, -1.1, 0.7, 2.0, -3.0, 4.0]
    at = dict(zip((*q, *qd, *qdd), values, strict=True))
    numbers = [float(expression.subs(at)) for expression in closed]
    np.testing.assert_allclose(
        numbers, ur5check.rnea(arm, values[:2], values[2:4], values[4:]), rtol=1e-13
    )
    # Zeros of the chain leave no trace: a torque about y never meets an x or z component.
    assert all(sympy.count_ops(expression) < 200 for expression in closed)
