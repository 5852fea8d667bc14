"""Closed loops: a right model and right signs track to rounding; anything wrong shows its price."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from ur5check._comparison.arm_pair import pair_up
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._errors import UsageError
from ur5check._simulation.control.computed_torque import ComputedTorque, effort_limits
from ur5check._simulation.control.error_dynamics import companion_matrix, poles
from ur5check._simulation.control.feedback_law import FeedbackLaw
from ur5check._simulation.control.gains import Gains
from ur5check._simulation.control.tracking import LOST, track
from ur5check._simulation.control.trajectory import Quintic
from ur5check._simulation.integration import Precision

APPENDIX = ur5check.load("appendix")
PLANT = PinocchioEngine(APPENDIX)
START = np.array([0.0, -1.2, 1.0, 0.0, 0.3, 0.0])
GOAL = np.array([1.0, -0.5, 0.2, 1.0, -0.3, 1.0])
WAY = Quintic(START, GOAL, 1.0)
GAINS = Gains.placed(6, (-8.0, -10.0, -12.0))


def model(name):
    return PinocchioEngine(pair_up(APPENDIX, ur5check.load(name), as_written=True).b)


RIGHT = ComputedTorque(PLANT, GAINS)


def test_a_right_model_tracks_to_rounding():
    run = track(RIGHT, PLANT, WAY)
    assert not run.lost
    # The integrator's own error, which feedback does not amplify.
    assert run.largest().max() < 1e-9
    np.testing.assert_allclose(run.q[-1], GOAL, atol=1e-9)


def test_our_own_dynamics_close_the_loop_too():
    own = RecursionEngine(APPENDIX)
    run = track(ComputedTorque(own, GAINS), own, WAY, seconds=0.05, precision=Precision(1e-7, 1e-9))
    assert run.largest().max() < 1e-7


def test_our_torques_drive_pinocchios_arm():
    """Controller and plant by different engines: they mean the same arm."""
    controller = ComputedTorque(RecursionEngine(APPENDIX), GAINS)
    run = track(controller, PLANT, WAY, seconds=0.1, precision=Precision(1e-7, 1e-9))
    assert run.largest().max() < 1e-7


@pytest.mark.parametrize("name", ["paper", "paper-listing"])
def test_a_wrong_model_costs_accuracy(name):
    run = track(ComputedTorque(model(name), GAINS), PLANT, WAY)
    assert not run.lost
    assert 1e-3 < run.rms().max() < 0.2


def test_the_listing_costs_more_than_the_table():
    table, listing = (
        track(ComputedTorque(model(name), GAINS), PLANT, WAY).rms().max()
        for name in ("paper", "paper-listing")
    )
    assert listing > table


def test_an_error_dies_out_as_the_poles_say():
    """With a right model the error is exp(A t) of where it began, whatever the arm does."""
    away = np.array([0.01, -0.02, 0.03, -0.01, 0.02, 0.01])
    run = track(RIGHT, PLANT, WAY, q=START - away, seconds=0.5, instants=6)
    from scipy.linalg import expm

    for t, error in zip(run.t, run.error, strict=True):
        x = expm(companion_matrix(GAINS) * t) @ np.concatenate([0 * away, away, 0 * away])
        np.testing.assert_allclose(error, x[6:12], atol=1e-8)


def test_the_signs_of_eq_22_drive_the_arm_away():
    controller = ComputedTorque(PLANT, GAINS, FeedbackLaw.PRINTED_22)
    run = track(controller, PLANT, WAY, q=START + 1e-6)
    assert run.lost
    assert run.t[-1] < 0.6
    assert run.largest().max() == pytest.approx(LOST)


def test_it_leaves_as_fast_as_its_pole_says():
    controller = ComputedTorque(PLANT, GAINS, FeedbackLaw.PRINTED_22)
    run = track(controller, PLANT, WAY, q=START + 1e-9, seconds=0.35, instants=36)
    size = np.abs(run.error[:, 0])
    rate = np.log(size[-1] / size[-6]) / (run.t[-1] - run.t[-6])
    assert rate == pytest.approx(poles(GAINS, FeedbackLaw.PRINTED_22)[0].real, rel=0.02)


def test_eq_28_follows_but_lags_by_the_missing_acceleration():
    right, printed = (
        track(ComputedTorque(PLANT, GAINS, law), PLANT, WAY)
        for law in (FeedbackLaw.RIGHT, FeedbackLaw.PRINTED_28)
    )
    assert not printed.lost
    assert printed.largest().max() > 1e6 * right.largest().max()
    assert printed.largest().max() > 5e-3


def test_limits_clip_and_are_counted():
    weak = np.array([150.0, 45.0, 150.0, 28.0, 28.0, 28.0])
    free = track(RIGHT, PLANT, WAY)
    assert free.torque_peak()[1] > 45.0
    run = track(ComputedTorque(PLANT, GAINS, limits=weak), PLANT, WAY)
    assert (run.torque_peak() <= weak).all()
    assert run.torque_peak()[1] == 45.0
    assert 0.0 < run.time_at_limit()[1] < 1.0
    assert not np.any(run.time_at_limit()[[0, 2, 3, 4, 5]])
    assert run.largest().max() > 1e3 * free.largest().max()


def test_limits_come_from_the_model():
    np.testing.assert_array_equal(effort_limits(APPENDIX), [150.0, 150.0, 150.0, 28.0, 28.0, 28.0])
    with pytest.raises(UsageError, match="has no effort limit"):
        effort_limits(ur5check.load("paper"))


def test_energy_is_at_least_the_work_done():
    run = track(RIGHT, PLANT, WAY)
    lifted = ur5check.potential_energy(APPENDIX, GOAL) - ur5check.potential_energy(APPENDIX, START)
    net = np.trapezoid((run.tau * run.qd).sum(axis=1), run.t)
    assert net == pytest.approx(lifted, rel=1e-3)  # from rest to rest
    assert run.energy() > abs(net)
    assert (np.diff(run.work, axis=0) >= 0.0).all()


def test_means_are_over_time():
    run = track(RIGHT, PLANT, WAY, q=START - 0.01, instants=301)
    by_hand = np.sqrt(np.mean(run.error**2, axis=0))
    np.testing.assert_allclose(run.rms(), by_hand, rtol=0.02)


def test_sizes_that_do_not_fit_are_refused():
    with pytest.raises(UsageError, match="6 joints, the gains 5"):
        track(ComputedTorque(PLANT, Gains.placed(5, (-1.0, -1.0, -1.0))), PLANT, WAY)
    with pytest.raises(UsageError, match="2 joints, the gains 6"):
        track(RIGHT, PLANT, Quintic(np.zeros(2), np.ones(2), 1.0))
