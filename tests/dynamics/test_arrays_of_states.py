"""Shapes, broadcasting, blocks, complex numbers, and refusals."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._dynamics import batching
from ur5check._errors import StateError
from ur5check._robot.states import random_states

ARM = random_arm(4, seed=1)
STATES = random_states(4, 24, seed=2)
FUNCTIONS = {
    "rnea": (lambda q, qd, qdd: ur5check.rnea(ARM, q, qd, qdd), (4,)),
    "mass_matrix": (lambda q, qd, qdd: ur5check.mass_matrix(ARM, q), (4, 4)),
    "coriolis_matrix": (lambda q, qd, qdd: ur5check.coriolis_matrix(ARM, q, qd), (4, 4)),
    "gravity_torque": (lambda q, qd, qdd: ur5check.gravity_torque(ARM, q), (4,)),
    "forward_dynamics": (lambda q, qd, qdd: ur5check.forward_dynamics(ARM, q, qd, qdd), (4,)),
    "forward_kinematics": (lambda q, qd, qdd: ur5check.forward_kinematics(ARM, q), (4, 4)),
    "torque_regressor": (lambda q, qd, qdd: ur5check.torque_regressor(ARM, q, qd, qdd), (4, 40)),
    "kinetic_energy": (lambda q, qd, qdd: ur5check.kinetic_energy(ARM, q, qd), ()),
    "potential_energy": (lambda q, qd, qdd: ur5check.potential_energy(ARM, q), ()),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_leading_axes_are_kept(name):
    function, tail = FUNCTIONS[name]
    one_by_one = [function(*state) for state in zip(STATES.q, STATES.qd, STATES.qdd, strict=True)]
    shaped = [array.reshape(2, 3, 4, 4) for array in (STATES.q, STATES.qd, STATES.qdd)]
    together = function(*shaped)
    assert together.shape == (2, 3, 4, *tail)
    np.testing.assert_allclose(
        together.reshape(24, *tail), np.array(one_by_one), rtol=1e-13, atol=1e-13
    )


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_complex_state_gives_a_complex_result_with_the_same_real_part(name):
    function, _ = FUNCTIONS[name]
    real = function(STATES.q, STATES.qd, STATES.qdd)
    stepped = function(STATES.q + 1e-30j, STATES.qd, STATES.qdd)
    assert stepped.dtype == np.complex128
    np.testing.assert_allclose(stepped.real, real, rtol=1e-12, atol=1e-12)


def test_leading_axes_broadcast():
    tau = ur5check.rnea(ARM, STATES.q[:, None, :], STATES.qd[0], STATES.qdd[:3])
    assert tau.shape == (24, 3, 4)
    np.testing.assert_allclose(
        tau[5, 2], ur5check.rnea(ARM, STATES.q[5], STATES.qd[0], STATES.qdd[2]), rtol=1e-13
    )


def test_blocks_leave_no_seam(monkeypatch):
    whole = ur5check.rnea(ARM, STATES.q, STATES.qd, STATES.qdd)
    monkeypatch.setattr(batching, "BLOCK", 7)
    np.testing.assert_array_equal(ur5check.rnea(ARM, STATES.q, STATES.qd, STATES.qdd), whole)


def test_no_state_is_no_error():
    assert ur5check.rnea(ARM, np.empty((0, 4)), np.empty((0, 4)), np.empty((0, 4))).shape == (0, 4)


def test_integers_are_numbers():
    assert ur5check.rnea(ARM, [0, 1, 2, 3], [0] * 4, [0] * 4).dtype == np.float64


@pytest.mark.parametrize(
    ("q", "words"),
    [
        ([0.0, 0.0, 0.0], r"q has shape \(3,\), but arm 'chain_4' has 4 joints"),
        (0.0, r"q has shape \(\)"),
        ([0.0, np.nan, 0.0, 0.0], r"q\[1\] is nan"),
        ([0.0, 0.0, 0.0, np.inf], r"q\[3\] is inf"),
        (["a", "b", "c", "d"], "q must hold numbers"),
        ([[0.0] * 4, [0.0] * 3], "q is not an array of numbers"),
        ([True] * 4, "q must hold numbers, not bool"),
        ([None] * 4, "q must hold numbers"),
    ],
)
def test_a_state_that_is_none_is_refused(q, words):
    with pytest.raises(StateError, match=words):
        ur5check.rnea(ARM, q, [0.0] * 4, [0.0] * 4)


def test_shapes_that_do_not_broadcast_are_refused():
    with pytest.raises(StateError, match=r"do not broadcast: q \(3, 4\), qd \(2, 4\)"):
        ur5check.coriolis_matrix(ARM, np.zeros((3, 4)), np.zeros((2, 4)))


@pytest.mark.parametrize("gravity", [(0, 0), (0, 0, np.nan), "down", [[0, 0, -9.81]]])
def test_gravity_that_is_no_vector_is_refused(gravity):
    with pytest.raises(StateError, match="gravity must"):
        ur5check.gravity_torque(ARM, [0.0] * 4, gravity)


def test_an_arm_without_inertia_cannot_be_accelerated():
    weightless = ARM.with_inertias([type(ARM.links[0].inertia).zero()] * 4)
    with pytest.raises(StateError, match="mass matrix of arm 'chain_4' is singular"):
        ur5check.forward_dynamics(weightless, [0.0] * 4, [0.0] * 4, [1.0] * 4)
