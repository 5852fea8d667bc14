"""Newton–Euler against Lagrange, and whether the listing can be parsed."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._paper import derivation_claims
from ur5check._paper.evidence import Evidence
from ur5check._paper.paper_models import PRINTED
from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.states import random_states


@pytest.mark.parametrize(
    "arm",
    [*(ur5check.load(name) for name in ("paper", "paper-listing")), random_arm(4, 3)],
    ids=lambda arm: arm.name,
)
def test_lagrange_gives_the_same_torques(arm: SerialArm) -> None:
    states = random_states(arm.n, 30, 1)
    tau = ur5check.rnea(arm, states.q, states.qd, states.qdd)
    lagrange = derivation_claims.lagrange_torque(arm, states)
    assert lagrange == pytest.approx(tau, abs=1e-13 * float(np.abs(tau).max()) * arm.n)


def test_a_difference_would_confirm_the_claim_and_rounding_does_not(evidence: Evidence) -> None:
    arm = evidence.model(PRINTED).arm
    states = random_states(arm.n, 20, 0)
    tau = ur5check.rnea(arm, states.q, states.qd, states.qdd)
    at_rest = ur5check.rnea(arm, states.q, 0.0 * states.qd, states.qdd)
    assert not derivation_claims.accuracy_trial("arm", tau, tau).holds
    assert not derivation_claims.accuracy_trial("arm", tau, tau * (1.0 + 1e-15)).holds
    assert derivation_claims.accuracy_trial("arm", tau, at_rest).holds
    assert derivation_claims.accuracy_trial("arm", tau, tau + 1e-9).holds
    (outcome,) = derivation_claims.newton_euler_is_more_accurate(evidence)
    assert outcome.verdict == "refuted"


def test_a_statement_without_its_brackets_is_refused(evidence: Evidence) -> None:
    assert derivation_claims.parse_trial("listing", "printed", ["cross(w, (b * dq[4]))"]).holds
    trial = derivation_claims.parse_trial("listing", "printed", ["f(x)", "f(x", "f((x)"])
    assert trial.value == 2.0
    assert not trial.holds
    printed, closed = derivation_claims.listing_runs(evidence)
    assert (printed.value, printed.verdict) == (2.0, "refuted")
    assert closed.verdict == "confirmed after repair"
