"""Our own integrator moves arms as physics does, and its energy adds up."""

from __future__ import annotations

import numpy as np
import pytest
from moving_arms import APPENDIX, CASE_9, pendulum

import ur5check
from examples import random_arm
from ur5check._dynamics.equations import acceleration_of
from ur5check._errors import StateError, UsageError
from ur5check._robot import Inertia
from ur5check._simulation.free_motion import integrated
from ur5check._simulation.integration import REFERENCE, WORKING, integrate
from ur5check._simulation.joint_range import joint_range_of
from ur5check._simulation.motion_result import energy_balance
from ur5check._simulation.torque_sources import ConstantTorque, GravityCompensation

REST = np.zeros(6)


@pytest.mark.parametrize("seed", range(3))
def test_one_sweep_gives_the_accelerations_of_many(seed):
    arm = random_arm(4, seed).with_armature([0.1, 0.0, 0.3, 0.02])
    rng = np.random.default_rng(seed)
    q, qd, tau = rng.normal(size=(3, 4))
    expected = ur5check.forward_dynamics(arm, q, qd, tau)
    np.testing.assert_allclose(acceleration_of(arm)(q, qd, tau), expected, rtol=1e-11)


def test_an_arm_that_moves_no_mass_is_refused():
    arm = pendulum(mass=1.0).with_inertias([Inertia.zero()])
    with pytest.raises(StateError, match="moves no mass"):
        acceleration_of(arm)(np.zeros(1), np.zeros(1), np.ones(1))


def test_a_constant_torque_without_gravity_gives_a_parabola():
    arm = pendulum(length=0.5, mass=2.0).with_gravity((0, 0, 0))
    t = np.linspace(0.0, 1.0, 11)
    motion = integrated(arm, ConstantTorque(np.array([1.0])), np.zeros(1), np.zeros(1), t)
    np.testing.assert_allclose(motion.q[:, 0], 0.5 * 2.0 * t**2, atol=1e-9)  # τ / m l² = 2
    np.testing.assert_allclose(motion.work, motion.q[:, 0], atol=1e-9)


def test_energy_is_conserved_in_free_fall():
    motion = integrated(APPENDIX, ConstantTorque(REST), CASE_9, REST, np.linspace(0.0, 0.4, 21))
    balance = energy_balance(APPENDIX, motion)
    assert balance.turned_over > 10.0
    # Some hundred steps of a relative error of rtol each.
    assert balance.relative < 100 * WORKING.rtol


def test_energy_includes_the_work_of_changing_torques():
    model = ur5check.load("erd-ur5")
    motion = integrated(
        APPENDIX, GravityCompensation(model), CASE_9, REST, np.linspace(0.0, 0.3, 11)
    )
    assert np.abs(motion.work).max() > 0.01
    assert energy_balance(APPENDIX, motion).relative < 100 * WORKING.rtol


def test_the_balance_shows_a_bad_integrator():
    """Fixed steps of a twentieth of a second are too long for a falling arm."""
    t = np.linspace(0.0, 0.4, 9)
    motion = integrated(APPENDIX, ConstantTorque(REST), CASE_9, REST, t, step=0.05)
    assert energy_balance(APPENDIX, motion).relative > 1e3 * WORKING.rtol


def test_the_balance_shows_torques_of_another_arm():
    motion = integrated(APPENDIX, ConstantTorque(REST), CASE_9, REST, np.linspace(0.0, 0.2, 5))
    assert energy_balance(ur5check.load("paper"), motion).relative > 1e-2


def test_a_tighter_tolerance_moves_the_end_by_less_than_the_looser_one_allows():
    ends = [
        integrated(
            APPENDIX, ConstantTorque(REST), CASE_9, REST, np.array([0.0, 0.15]), precision=p
        ).q[-1]
        for p in (WORKING, REFERENCE)
    ]
    assert 0.0 < np.abs(ends[0] - ends[1]).max() < 1e-7


def test_motion_ends_at_the_limit_and_not_a_step_later():
    arm = pendulum(length=0.5, mass=2.0, upper=0.25).with_gravity((0, 0, 0))
    start = np.zeros(1)
    motion = integrated(
        arm, ConstantTorque(np.array([1.0])), start, start, np.linspace(0.0, 1.0, 5),
        joint_range=joint_range_of(arm, start),
    )  # fmt: skip
    assert motion.stopped
    assert motion.t[-1] == pytest.approx(0.5)  # ½ · 2 · t² = ¼
    assert motion.q[-1, 0] == pytest.approx(0.25)


def test_without_limits_an_arm_is_followed_for_a_full_turn():
    joint_range = joint_range_of(pendulum(), np.array([1.0]))
    assert joint_range.upper - joint_range.lower == pytest.approx(4.0 * np.pi)
    assert joint_range.margin(np.array([1.0 + 2.0 * np.pi + 1e-6])) < 0.0


def test_a_start_beyond_a_limit_is_refused():
    with pytest.raises(UsageError, match=r"'pivot'.*starts at 1 rad.*limits -6.283 and 0.5"):
        joint_range_of(pendulum(upper=0.5, lower=-2 * np.pi), np.array([1.0]))


def test_a_state_that_runs_away_is_said():
    with pytest.raises(UsageError, match="diverges before 2 s"):
        integrate(lambda t, y: y**2, np.ones(1), np.array([0.0, 2.0]))  # y = 1 / (1 − t)
