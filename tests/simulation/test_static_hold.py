"""Test 9: an arm stands under its own torques, and under no others."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from moving_arms import APPENDIX, CASE_9, pendulum
from scipy.linalg import eigh

import ur5check
from ur5check import Inertia, SerialArm, Transform
from ur5check._errors import StateError, UsageError
from ur5check._reports.simulate_summary import reason, summarize, verdict
from ur5check._simulation.equilibrium import gravity_stiffness, growth_rate
from ur5check._simulation.free_motion import integrated
from ur5check._simulation.integration import REFERENCE
from ur5check._simulation.static_hold import ENGINES, STILL, stand
from ur5check._simulation.torque_sources import ConstantTorque

engines = pytest.mark.parametrize("engine", ENGINES)


@engines
def test_the_appendix_stands_under_its_own_torques(engine):
    s = stand(APPENDIX, APPENDIX, CASE_9, engine=engine)
    assert s.stands
    assert s.motion.t[-1] == pytest.approx(5.0)
    # Rounding of the start, grown as the equilibrium's own rate says, is all that moves.
    assert s.tool_drift.max() < 1e-14 * np.exp(s.growth * 5.0)


@engines
def test_it_stands_when_its_torques_are_recomputed(engine):
    assert stand(APPENDIX, APPENDIX, CASE_9, engine=engine, held=False, seconds=0.5).stands


@engines
@pytest.mark.parametrize("held", [True, False], ids=["held", "recomputed"])
@pytest.mark.parametrize("name", ["paper", "paper-listing"])
def test_it_moves_under_the_papers_torques(engine, name, held):
    s = stand(APPENDIX, ur5check.load(name), CASE_9, engine=engine, held=held, seconds=0.1)
    assert not s.stands
    assert s.left_after < 0.02
    assert s.tool_drift[-1] > 0.02
    # The listing pushes joint 2 the wrong way.
    assert bool(s.given[1] * s.needed[1] < 0.0) is (name == "paper-listing")


def test_the_engines_fall_alike():
    ends = [
        stand(APPENDIX, ur5check.load("paper-listing"), CASE_9, engine=engine, seconds=0.1, dt=1e-4)
        for engine in ENGINES
    ]
    own, *others = [s.motion.q[-1] for s in ends]
    for other in others:
        assert np.abs(other - own).max() < 0.02 * np.abs(own - CASE_9).max()


def test_the_table_of_the_paper_stands_under_its_own_torques_too():
    paper = ur5check.load("paper")
    assert stand(paper, paper, CASE_9, seconds=1.0).stands


def test_models_in_other_coordinates_are_mapped_to_the_plants():
    """The paper's base is turned by half a turn; its torques still mean the same joints."""
    s = stand(APPENDIX, ur5check.load("paper"), CASE_9, seconds=0.01)
    expected = ur5check.gravity_torque(ur5check.load("paper"), CASE_9)
    np.testing.assert_allclose(s.given, expected, atol=1e-9)


def test_a_thousandth_more_mass_is_seen():
    heavier = APPENDIX.with_inertias(
        [type(x.inertia)(x.inertia.mass * 1.001, x.inertia.com, x.inertia.tensor)
         for x in APPENDIX.links]
    )  # fmt: skip
    s = stand(heavier, APPENDIX, CASE_9, seconds=1.0)
    assert not s.stands


def test_simulation_ends_at_a_joint_limit():
    s = stand(APPENDIX, ur5check.load("paper"), CASE_9, engine="mujoco")
    assert s.motion.stopped
    assert s.motion.t[-1] < 0.5
    assert any("reached its limit" in line for line in summarize(s))


def test_the_threshold_is_the_tool_at_full_reach():
    s = stand(APPENDIX, APPENDIX, CASE_9, seconds=0.01)
    length = sum(np.linalg.norm(link.link_tip_frame.p) for link in APPENDIX.links)
    assert s.still_angle * length == pytest.approx(STILL)
    assert "0.1 mm" in reason(s)


def test_the_summary_states_the_result():
    fallen = stand(APPENDIX, ur5check.load("paper-listing"), CASE_9, seconds=0.2)
    assert verdict(fallen).startswith("appendix moves under the torques that hold paper-listing")
    assert any("+65.92 N m and needs −40.39 N m, the wrong sign" in x for x in summarize(fallen))
    still = stand(APPENDIX, APPENDIX, CASE_9, seconds=0.1)
    assert verdict(still).startswith("appendix stands for 0.1 s")
    assert any("to rounding" in line for line in summarize(still))


def test_energy_errors_tell_integrators_apart():
    errors = {
        engine: stand(APPENDIX, ur5check.load("paper"), CASE_9, engine=engine, seconds=0.2).energy
        for engine in ENGINES
    }
    assert errors["ur5check"].relative < 1e-7 < 1e-5 < errors["dart"].relative


def test_better_integrators_invent_less_energy():
    errors = [
        stand(
            APPENDIX, ur5check.load("paper"), CASE_9, engine="mujoco", integrator=name, seconds=0.2
        ).energy.worst
        for name in ("euler", "rk4")
    ]
    assert errors[1] < 1e-3 * errors[0]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"seconds": 0.0}, "--seconds must be a positive number"),
        ({"seconds": float("nan")}, "seconds must be a finite number"),
        ({"dt": -1e-3}, "--step must be a positive number"),
        ({"dt": 1.0, "seconds": 0.5}, "does not fit"),
        ({"dt": 1e-9}, "take larger"),
        ({"engine": "mujoco", "integrator": "verlet"}, "no integrator 'verlet'; choose from euler"),
        ({"integrator": "rk4"}, "leave it out"),
        ({"engine": "drake"}, "'drake' moves no arm in time"),
    ],
)
def test_options_without_meaning_are_refused(options, said):
    with pytest.raises(UsageError, match=said):
        stand(APPENDIX, APPENDIX, CASE_9, **options)


def test_a_pose_of_the_wrong_length_is_refused():
    with pytest.raises(StateError, match="6 joints"):
        stand(APPENDIX, APPENDIX, CASE_9[:5])
    with pytest.raises(UsageError, match="one posture"):
        stand(APPENDIX, APPENDIX, [CASE_9, CASE_9])


# --- how an equilibrium takes a push -------------------------------------------------------------


def test_an_upright_pendulum_falls_at_the_rate_of_the_textbook():
    arm = pendulum(length=0.5)
    assert growth_rate(arm, [-np.pi / 2]) == pytest.approx(np.sqrt(9.81 / 0.5), rel=1e-12)


def test_a_hanging_pendulum_does_not_fall():
    assert growth_rate(pendulum(), [np.pi / 2]) == 0.0


def test_gravity_stiffness_is_the_slope_of_the_torque():
    h = 1e-6
    slopes = [
        (ur5check.gravity_torque(APPENDIX, CASE_9 + h * e)
         - ur5check.gravity_torque(APPENDIX, CASE_9 - h * e)) / (2 * h)
        for e in np.eye(6)
    ]  # fmt: skip
    np.testing.assert_allclose(gravity_stiffness(APPENDIX, CASE_9), np.array(slopes).T, atol=1e-7)


def test_an_error_grows_as_the_rate_says():
    """Pushed along the fastest direction, it goes with cosh(λ t)."""
    rate = growth_rate(APPENDIX, CASE_9)
    M, G = ur5check.mass_matrix(APPENDIX, CASE_9), gravity_stiffness(APPENDIX, CASE_9)
    _, directions = eigh(-0.5 * (G + G.T), M)
    push, t = 1e-8 * directions[:, -1], np.array([0.0, 1.0, 1.5])
    held = ConstantTorque(ur5check.gravity_torque(APPENDIX, CASE_9))
    motion = integrated(APPENDIX, held, CASE_9 + push, np.zeros(6), t, precision=REFERENCE)
    grown = np.linalg.norm(motion.q - CASE_9, axis=1) / np.linalg.norm(push)
    np.testing.assert_allclose(grown, np.cosh(rate * t), rtol=1e-4)


def test_a_tool_on_the_axis_leaves_the_centre_of_mass_as_threshold():
    rod = pendulum().links[0]
    at_joint = replace(
        rod, link_tip_frame=Transform.identity(), inertia=Inertia(2.0, (0, 0, 0.4), np.eye(3))
    )
    arm = SerialArm("rod", pendulum().joints, (at_joint,))
    s = stand(arm, arm, [0.5], seconds=0.01)
    assert s.still_angle * 0.4 == pytest.approx(STILL)
    assert s.stands
