"""The claims on control: the verdict depends on the law and the gain matrices only."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._paper.claim import overall
from ur5check._paper.control_claims import (
    GAINS,
    eq_28_is_the_law,
    feedback_is_stable,
    following_trial,
    gain_trial,
    gains_reach_every_joint,
    pole_trial,
    printed_matrix,
)
from ur5check._paper.evidence import Evidence
from ur5check._simulation.control.error_dynamics import companion_matrix
from ur5check._simulation.control.feedback_law import FeedbackLaw
from ur5check._simulation.control.gains import Gains

PLANT = PinocchioEngine(ur5check.load("appendix"))


def test_the_printed_signs_are_refuted_and_the_reversed_ones_confirmed(evidence: Evidence) -> None:
    printed, repaired = outcomes = tuple(feedback_is_stable(evidence))
    assert (printed.verdict, repaired.verdict) == ("refuted", "confirmed after repair")
    assert overall(outcomes) == "confirmed after repair"
    assert printed.value == pytest.approx(38.0, abs=1.0)
    assert repaired.value == pytest.approx(-8.0)
    # The simulated arm says the same as the poles.
    assert "half a turn after" in printed.why
    assert "µrad after 1 s" in repaired.why


def test_eq_28_follows_only_with_the_acceleration_that_it_drops(evidence: Evidence) -> None:
    printed, repaired = outcomes = tuple(eq_28_is_the_law(evidence))
    assert overall(outcomes) == "confirmed after repair"
    assert printed.value > 5e-3 > 1e-6 > repaired.value


def test_had_the_paper_printed_plus_signs_its_claim_would_hold() -> None:
    trial = pole_trial("plus", "printed", FeedbackLaw.RIGHT, PLANT)
    assert trial.holds
    assert following_trial("all", "printed", FeedbackLaw.RIGHT, PLANT).holds
    assert not following_trial("minus", "printed", FeedbackLaw.PRINTED_28, PLANT).holds
    assert np.isfinite(trial.value)


def test_the_printed_gain_matrix_has_the_printed_corners() -> None:
    matrix = printed_matrix(np.array([3.0, 2.0, 1.0]))
    assert matrix.tolist() == [[3, 2, 1], [2, 2, 1], [1, 1, 1]]
    assert np.array_equal(matrix, matrix.T)


def test_equal_gains_as_printed_reach_one_direction_of_six(evidence: Evidence) -> None:
    printed, repaired = gains_reach_every_joint(evidence)
    assert (printed.value, printed.verdict) == (1.0, "refuted")
    assert (repaired.value, repaired.verdict) == (6.0, "confirmed after repair")
    assert gain_trial("distinct", "printed", printed_matrix(np.arange(6.0, 0.0, -1.0))).holds
    assert not gain_trial("one gain is zero", "printed", np.diag([1.0, 2.0, 0.0])).holds


def test_with_the_printed_matrices_a_difference_of_joints_never_decays() -> None:
    """Opposite errors of two joints give no acceleration at all."""
    gains = Gains(*(printed_matrix(np.diag(gain)) for gain in (GAINS.kp, GAINS.ki, GAINS.kd)))
    opposite = np.array([1.0, -1.0, 0.0, 0.0, 0.0, 0.0])
    stays = np.concatenate([opposite, np.zeros(12)])  # an integral of the error, and no error
    assert not (gains.kp @ opposite).any()
    assert not (companion_matrix(gains) @ stays).any()
