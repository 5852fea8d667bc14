"""The claims on test 9 can come out either way."""

from __future__ import annotations

import pytest
from moving_arms import APPENDIX, CASE_9

import ur5check
from ur5check._paper.simulation_claims import clear_trial, static_hold_trial


@pytest.mark.parametrize(("name", "stands"), [("appendix", True), ("paper", False)])
def test_the_arm_stands_under_its_own_torques_only(name, stands):
    trial = static_hold_trial(name, "printed", APPENDIX, ur5check.load(name))
    assert trial.holds is stands
    assert (trial.value <= 0.1) is stands
    assert ("needs" in trial.why) is not stands


def test_the_printed_tables_arm_would_stand_under_its_own():
    paper = ur5check.load("paper")
    assert static_hold_trial("paper", "printed", paper, paper).holds


def test_the_posture_of_test_9_reaches_below_the_ground():
    trial = clear_trial("appendix", "printed", APPENDIX, CASE_9)
    assert not trial.holds
    assert trial.value == pytest.approx(-0.163, abs=1e-3)


def test_an_arm_that_reaches_up_is_clear_of_it():
    assert clear_trial("appendix", "printed", APPENDIX, [0, -1.5, 0.5, 0, 0, 0]).holds
