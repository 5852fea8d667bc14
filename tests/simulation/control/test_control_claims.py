"""The claims on control can come out either way: it depends on the law, and on nothing else."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._paper.claim import overall
from ur5check._paper.control_claims import (
    eq_28_is_the_law,
    feedback_is_stable,
    following_trial,
    pole_trial,
)
from ur5check._paper.evidence import Evidence, gather
from ur5check._simulation.control.feedback_law import FeedbackLaw

PLANT = PinocchioEngine(ur5check.load("appendix"))


@pytest.fixture(scope="module")
def evidence() -> Evidence:
    return gather(lambda line: None)


def test_the_printed_signs_are_refuted_and_the_turned_ones_confirmed(evidence):
    printed, repaired = outcomes = tuple(feedback_is_stable(evidence))
    assert (printed.verdict, repaired.verdict) == ("refuted", "confirmed after repair")
    assert overall(outcomes) == "confirmed after repair"
    assert printed.value == pytest.approx(38.0, abs=1.0)
    assert repaired.value == pytest.approx(-8.0)
    # The simulated arm says the same as the poles.
    assert "half a turn after" in printed.why
    assert "µrad after 1 s" in repaired.why


def test_eq_28_follows_only_with_the_acceleration_that_it_drops(evidence):
    printed, repaired = outcomes = tuple(eq_28_is_the_law(evidence))
    assert overall(outcomes) == "confirmed after repair"
    assert printed.value > 5e-3 > 1e-6 > repaired.value


def test_had_the_paper_printed_plus_signs_its_claim_would_stand():
    trial = pole_trial("plus", "printed", FeedbackLaw.RIGHT, PLANT)
    assert trial.holds
    assert following_trial("all", "printed", FeedbackLaw.RIGHT, PLANT).holds
    assert not following_trial("minus", "printed", FeedbackLaw.PRINTED_28, PLANT).holds
    assert np.isfinite(trial.value)
