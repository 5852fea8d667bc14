"""No engine simulates an arm other than the one it was given."""

from __future__ import annotations

import numpy as np
import pytest
from moving_arms import APPENDIX, CASE_9

from ur5check._dynamics.equations import acceleration_of
from ur5check._engines.known_issues import repaired
from ur5check._engines.registry import REFERENCE, make_engine, steppers
from ur5check._errors import EngineError, UsageError
from ur5check._simulation.free_motion import integrated, stepped
from ur5check._simulation.require_same_model import checked_stepper, require_same_model
from ur5check._simulation.torque_sources import ConstantTorque

engines = pytest.mark.parametrize("key", [key for key in steppers() if key != REFERENCE])


@engines
def test_hidden_masses_are_turned_away(key):
    with pytest.raises(EngineError, match=r"has imported another arm than 'appendix'.*ee_link"):
        require_same_model(make_engine(key, APPENDIX), APPENDIX)


@engines
def test_an_engine_with_a_heavier_arm_is_turned_away(key):
    link = APPENDIX.links[1].inertia
    other = [link.inertia for link in APPENDIX.links]
    other[1] = type(link)(link.mass * (1 + 1e-6), link.com, link.tensor)
    engine = make_engine(key, repaired(APPENDIX, key))
    with pytest.raises(EngineError, match=r"upper_arm_link.*8\.393 kg, where .* 8\.39301 kg"):
        require_same_model(engine, APPENDIX.with_inertias(other))


@engines
def test_after_its_remedies_an_engine_accelerates_the_arm_as_we_do(key):
    admitted = checked_stepper(key, APPENDIX)
    assert any("ee_link" in line for line in admitted.repaired)
    state = CASE_9, np.array([0.3, -0.2, 0.5, 1.0, -1.0, 2.0]), np.arange(6.0)
    ours = acceleration_of(APPENDIX)(*state)
    np.testing.assert_allclose(admitted.engine.forward_dynamics(*state), ours, rtol=1e-10)


def test_an_engine_that_cannot_step_is_refused():
    with pytest.raises(UsageError, match="'pinocchio' moves no arm in time; choose from ur5check"):
        checked_stepper("pinocchio", APPENDIX)


@engines
def test_a_step_is_the_integrators_own(key):
    """One step of semi-implicit Euler: velocities first, positions with the new ones."""
    engine, dt, rest = checked_stepper(key, APPENDIX).engine, 1e-3, np.zeros(6)
    q, qd = engine.step(CASE_9, rest, rest, dt)
    expected = dt * acceleration_of(APPENDIX)(CASE_9, rest, rest)
    np.testing.assert_allclose(qd, expected, rtol=1e-10)
    np.testing.assert_allclose(q - CASE_9, dt * expected, rtol=1e-9)


def test_rk4_and_our_own_integrator_arrive_at_the_same_place():
    engine, rest = checked_stepper("mujoco", APPENDIX).engine, np.zeros(6)
    theirs = stepped(
        engine, ConstantTorque(rest), CASE_9, rest, dt=1e-3, steps=200, integrator="rk4"
    )
    ours = integrated(APPENDIX, ConstantTorque(rest), CASE_9, rest, np.array([0.0, 0.2]))
    assert np.abs(theirs.q[-1] - ours.q[-1]).max() < 1e-8
    assert np.abs(ours.q[-1] - CASE_9).max() > 0.1


def test_work_of_held_torques_is_torque_times_way():
    engine, rest, tau = checked_stepper("dart", APPENDIX).engine, np.zeros(6), np.arange(6.0)
    motion = stepped(engine, ConstantTorque(tau), CASE_9, rest, dt=1e-3, steps=50)
    np.testing.assert_allclose(motion.work, (motion.q - CASE_9) @ tau, atol=1e-12)


def test_an_engine_that_loses_the_arm_is_said():
    engine, rest = checked_stepper("mujoco", APPENDIX).engine, np.zeros(6)

    class Lost(type(engine)):
        def step(self, q, qd, tau, dt, integrator=None):
            return q + np.inf, qd

    engine.__class__ = Lost
    with pytest.raises(EngineError, match=r"MuJoCo diverged after 0 s: .* smaller step"):
        stepped(engine, ConstantTorque(rest), CASE_9, rest, dt=1e-3, steps=5)
