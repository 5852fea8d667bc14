"""Claims on curves: fed with a curve that breaks it, each refuses."""

from __future__ import annotations

import numpy as np
import pytest

from paper.curves import MODELS, replaced, with_curve
from ur5check._paper import curve_claims
from ur5check._paper.cases import SWEEP
from ur5check._paper.evidence import Evidence
from ur5check._paper.paper_models import REPAIRED

TWO_HARMONICS = np.sin(SWEEP) + 1e-6 * np.sin(2 * SWEEP)
OFFSET = np.sin(SWEEP) + 1e-6
TRIANGLE = 2.0 * np.abs((SWEEP / np.pi) % 2.0 - 1.0) - 1.0


@pytest.mark.parametrize("number", [1, 5])
@pytest.mark.parametrize("model", MODELS)
def test_one_harmonic_is_a_sine_and_nothing_else_is(
    evidence: Evidence, number: int, model: str
) -> None:
    run = evidence.run(number, model)
    assert curve_claims.sine_trial(run).holds
    for curve in (TWO_HARMONICS, OFFSET, TRIANGLE, np.sin(2 * SWEEP), np.ones(361)):
        assert not curve_claims.sine_trial(with_curve(run, curve)).holds
    flat = curve_claims.sine_trial(with_curve(run, np.zeros(361)))
    assert not flat.holds
    assert flat.why == "there is no curve"


@pytest.mark.parametrize("number", range(1, 9))
def test_what_is_expected_is_the_weights(evidence: Evidence, number: int) -> None:
    run = evidence.run(number, REPAIRED)
    assert curve_claims.expectation_trial(run).holds
    for wrong in (
        -run.watched + 1e-6,
        1.02 * run.watched + 1e-6,
        np.roll(run.watched, 2) + 1e-6,
    ):
        assert not curve_claims.expectation_trial(with_curve(run, wrong + 0.02 * run.peak)).holds


def test_the_reason_says_what_is_wrong(evidence: Evidence) -> None:
    run = evidence.run(2, REPAIRED)
    twice = curve_claims.expectation_trial(with_curve(run, -2.0 * run.watched))
    assert twice.why == "peak 108.3 for 54.13 N m: 100.0 % too large, of opposite sign"
    half = curve_claims.expectation_trial(with_curve(run, 0.5 * run.watched))
    assert half.why.endswith("50.0 % too small")
    light = curve_claims.expectation_trial(with_curve(evidence.run(8, REPAIRED), np.sin(SWEEP)))
    assert light.why == "peak 1 N m, with nothing to hold"


@pytest.mark.parametrize("model", MODELS)
def test_zero_is_zero_all_along(evidence: Evidence, model: str) -> None:
    run = evidence.run(4, model)
    assert curve_claims.zero_trial(run).holds
    once = np.zeros(361)
    once[100] = 1e-9
    assert not curve_claims.zero_trial(with_curve(run, once)).holds
    constant = np.full(361, 1e-9)
    assert not curve_claims.zero_trial(with_curve(run, constant)).holds


def test_case_9_is_six_torques(evidence: Evidence) -> None:
    run = evidence.run(9, REPAIRED)
    assert curve_claims.posture_trial(run).holds
    for joint in range(6):
        wrong = np.array(run.torque)
        wrong[0, joint] += 0.011 * run.expected_peak
        assert not curve_claims.posture_trial(replaced(run, wrong)).holds
    turned = curve_claims.posture_trial(replaced(run, -run.torque))
    assert turned.why == "τ2 = +38.44 N m for -38.44 N m: the wrong sign"
