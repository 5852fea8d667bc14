"""How close the hand-written side comes to Pinocchio: bounds far below what anyone can measure."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from examples import UR5S, random_arm
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._robot.states import random_states


@pytest.mark.parametrize("name", UR5S)
def test_ten_thousand_states_of_every_ur5(name):
    arm, states = ur5check.load(name), random_states(6, 10_000, seed=0)
    reference = PinocchioEngine(arm)
    q, qd, qdd = states.q, states.qd, states.qdd
    tau_error = ur5check.rnea(arm, q, qd, qdd) - reference.inverse_dynamics(q, qd, qdd)
    assert np.abs(tau_error).max() <= 1e-11  # N m
    assert np.abs(ur5check.mass_matrix(arm, q) - reference.mass_matrix(q)).max() <= 1e-12  # kg m²
    rate_of_mass = ur5check.mass_matrix(arm, q + 1e-30j * qd).imag / 1e-30
    S = rate_of_mass - 2.0 * ur5check.coriolis_matrix(arm, q, qd)
    assert np.abs(S + S.swapaxes(-1, -2)).max() <= 1e-11  # N m s


@pytest.mark.parametrize("n", range(1, 31))
def test_random_chains(n):
    arm, states = random_arm(n, seed=n), random_states(n, 20, seed=n)
    reference = PinocchioEngine(arm)
    q, qd, qdd = states.q, states.qd, states.qdd
    for ours, theirs in (
        (ur5check.rnea(arm, q, qd, qdd), reference.inverse_dynamics(q, qd, qdd)),
        (ur5check.mass_matrix(arm, q), reference.mass_matrix(q)),
        (ur5check.forward_kinematics(arm, q), reference.forward_kinematics(q)),
        (
            ur5check.torque_regressor(arm, q, qd, qdd),
            reference.torque_regressor(q, qd, qdd),
        ),
    ):
        assert np.abs(ours - theirs).max() <= 1e-12 * np.abs(theirs).max()


def test_the_attribution_of_paper_and_appendix_leaves_no_residual():
    validation = ur5check.validate("paper", "appendix", samples=10_000)
    (residual,) = (o for o in validation.outcomes if o.id == "residual")
    assert residual.value <= 1e-9  # N m
