"""Pinocchio's derivatives of inverse dynamics against a complex step through our own recursion."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given

import ur5check
from examples import UR5S, random_arm
from ur5check import strategies as ur5
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._robot import Joint, Limits
from ur5check._robot.states import random_states

_STEP = 1e-30


def complex_step(arm, q, qd, qdd):
    """∂τ/∂q, ∂τ/∂q̇, ∂τ/∂q̈ with no step-size error: τ(x + ih e_j).imag / h is column j."""
    state = np.stack([q, qd, qdd])
    slopes = []
    for part in range(3):
        columns = []
        for j in range(arm.n):
            step = np.zeros_like(state, dtype=complex)
            step[part, ..., j] = 1j * _STEP
            columns.append(ur5check.rnea(arm, *(state + step)).imag / _STEP)
        slopes.append(np.stack(columns, axis=-1))
    return slopes


def assert_same(arm, states, engine=None):
    found = (engine or PinocchioEngine(arm)).inverse_dynamics_gradient(
        states.q, states.qd, states.qdd
    )
    for slope, wanted in zip(
        found, complex_step(arm, states.q, states.qd, states.qdd), strict=True
    ):
        assert slope.shape == (*states.q.shape, arm.n)
        np.testing.assert_allclose(slope, wanted, rtol=0, atol=1e-11 * max(1, abs(wanted).max()))


@pytest.mark.parametrize("name", UR5S)
def test_gradient_is_the_complex_steps(name):
    arm = ur5check.load(name)
    assert_same(arm, random_states(arm.n, 20, seed=3))


@given(ur5.arms_and_states())
def test_gradient_is_the_complex_steps_for_any_arm(arm_and_states):
    assert_same(*arm_and_states)


def test_last_part_is_the_mass_matrix_and_one_state_needs_no_list():
    arm = random_arm(5, seed=1)
    states = random_states(5, 1, seed=2)
    engine = PinocchioEngine(arm)
    q, qd, qdd = states.q[0], states.qd[0], states.qdd[0]
    *_, M = engine.inverse_dynamics_gradient(q, qd, qdd)
    np.testing.assert_allclose(M, ur5check.mass_matrix(arm, q), atol=1e-12)
    torque, slope = engine.torque_and_slope(q, qd, qdd)
    np.testing.assert_allclose(torque, ur5check.rnea(arm, q, qd, qdd), atol=1e-12)
    np.testing.assert_array_equal(slope[:, -5:], M)


def test_continuous_joint_is_differentiated_by_its_angle(tmp_path):
    """Pinocchio holds such a joint as (cos q, sin q)."""
    from ur5check._io.urdf.urdf_writer import urdf_of

    arm = random_arm(3, seed=8, prismatic=False)
    file = tmp_path / "continuous.urdf"
    file.write_text(urdf_of(arm), encoding="utf-8")
    read = ur5check.load(file)
    assert [joint.limits for joint in read.joints] == [Limits()] * 3
    assert PinocchioEngine(read).route == "URDF text, own parser"
    assert_same(read, random_states(3, 5, seed=4))


@pytest.mark.parametrize("fault", ["gravity", "axis", "mass"])
def test_a_planted_fault_is_seen(fault):
    """The same comparison, with the engine holding a slightly different arm."""
    from dataclasses import replace

    arm = random_arm(4, seed=5)
    if fault == "gravity":
        other = arm.with_gravity(arm.gravity * 1.0001)
    elif fault == "axis":
        joints = list(arm.joints)
        joints[1] = Joint(joints[1].name, -joints[1].axis, joints[1].kind)
        other = replace(arm, joints=tuple(joints))
    else:
        inertias = [link.inertia for link in arm.links]
        inertias[-1] = replace(inertias[-1], mass=inertias[-1].mass * 1.0001)
        other = arm.with_inertias(inertias)
    with pytest.raises(AssertionError):
        assert_same(arm, random_states(4, 5, seed=6), PinocchioEngine(other))
