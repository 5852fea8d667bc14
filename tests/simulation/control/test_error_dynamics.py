"""The poles of the three laws: stable with the right signs, unstable with the printed ones."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

from ur5check._errors import UsageError
from ur5check._simulation.control.error_dynamics import companion_matrix, poles
from ur5check._simulation.control.feedback_law import FeedbackLaw
from ur5check._simulation.control.gains import Gains


def diagonal(kp: list[float], ki: list[float], kd: list[float]) -> Gains:
    """Gains of uncoupled joints."""
    return Gains(np.diag(kp), np.diag(ki), np.diag(kd))


def is_stable(gains: Gains, law: FeedbackLaw = FeedbackLaw.RIGHT) -> bool:
    return bool(poles(gains, law)[0].real < 0.0)


#: Poles at −4, −5 and −6 of each of two joints.
GAINS = diagonal([74.0, 74.0], [120.0, 120.0], [15.0, 15.0])


def test_poles_are_the_roots_of_the_characteristic_polynomial():
    np.testing.assert_allclose(poles(GAINS), np.repeat([-4.0, -5.0, -6.0], 2), atol=1e-9)


def test_right_signs_are_stable():
    assert is_stable(GAINS)
    assert is_stable(GAINS, FeedbackLaw.PRINTED_28)  # its signs are right


def test_signs_of_eq_22_are_unstable():
    assert not is_stable(GAINS, FeedbackLaw.PRINTED_22)
    assert poles(GAINS, FeedbackLaw.PRINTED_22)[0].real > 15.0


def test_signs_of_eq_22_are_unstable_for_any_gains_that_are_stable_with_right_ones():
    """s³ − k_d s² − k_p s − k_i has one change of sign: one positive root (Descartes)."""
    rng = np.random.default_rng(0)
    for kp, ki, kd in rng.uniform(0.1, 100.0, (50, 3)):
        gains = diagonal([kp], [ki * min(1.0, kp * kd / ki)], [kd])
        assert poles(gains, FeedbackLaw.PRINTED_22)[0].real > 0.0


def test_too_much_integral_is_unstable_with_right_signs():
    """Routh and Hurwitz: k_i < k_d k_p."""
    assert is_stable(diagonal([10.0], [99.0], [10.0]))
    assert not is_stable(diagonal([10.0], [101.0], [10.0]))


def test_full_matrices_couple_the_joints():
    """Diagonals alone would be stable; the coupling is not."""
    kp = np.array([[10.0, 50.0], [50.0, 10.0]])
    assert not is_stable(Gains(kp, np.zeros((2, 2)), 5.0 * np.eye(2)))
    assert is_stable(Gains(np.diag(np.diag(kp)), np.zeros((2, 2)), 5.0 * np.eye(2)))


def test_without_integral_there_are_two_poles_a_joint():
    gains = diagonal([6.0], [0.0], [5.0])
    assert companion_matrix(gains).shape == (2, 2)
    np.testing.assert_allclose(poles(gains), [-2.0, -3.0], atol=1e-12)


def test_the_companion_matrix_is_the_error_equation():
    """x = (∫e, e, ė) moved by exp(A t) obeys ë = −K_d ė − K_p e − K_i ∫e."""
    x = expm(companion_matrix(GAINS) * 0.1) @ np.arange(1.0, 7.0)
    rate = companion_matrix(GAINS) @ x
    integral, e, ed = x.reshape(3, 2)
    np.testing.assert_allclose(rate.reshape(3, 2), [e, ed, -15 * ed - 74 * e - 120 * integral])


def test_placed_poles_are_where_they_were_placed():
    np.testing.assert_allclose(poles(Gains.placed(1, (-8.0, -10.0, -12.0))), [-8, -10, -12])
    with pytest.raises(UsageError, match="poles must be negative, not -1, 2, -3"):
        Gains.placed(1, (-1.0, 2.0, -3.0))


@pytest.mark.parametrize(
    ("gains", "message"),
    [
        ((np.eye(2), np.eye(3), np.eye(2)), r"ki has shape \(3, 3\)"),
        ((np.ones(2), np.eye(2), np.eye(2)), r"kp has shape \(2,\)"),
        ((np.eye(2), np.eye(2), np.eye(2) * np.nan), "kd must hold finite numbers"),
    ],
)
def test_gains_that_are_no_matrices_are_refused(gains, message):
    with pytest.raises(UsageError, match=message):
        Gains(*gains)
