"""Claims on loads: less, low, and low because a link is light."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from paper.curves import MODELS, with_curve
from ur5check._dynamics.equations import gravity_torque
from ur5check._paper import load_claims
from ur5check._paper.case_runs import Run
from ur5check._paper.cases import SWEEP
from ur5check._paper.evidence import Evidence
from ur5check._paper.paper_models import REPAIRED
from ur5check._robot.inertia import Inertia
from ur5check._robot.serial_arm import SerialArm


@pytest.mark.parametrize("model", MODELS)
def test_less_is_less(evidence: Evidence, model: str) -> None:
    bent, stretched = evidence.run(3, model), evidence.run(2, model)
    assert load_claims.less_trial(bent, stretched).holds
    assert not load_claims.less_trial(stretched, bent).holds
    assert not load_claims.less_trial(bent, bent).holds
    nothing = with_curve(stretched, np.zeros(361))
    assert not load_claims.less_trial(bent, nothing).holds


@pytest.mark.parametrize("number", [7, 8])
@pytest.mark.parametrize("model", MODELS)
def test_low_is_lower_than_all_before(evidence: Evidence, number: int, model: str) -> None:
    before = [evidence.run(n, model) for n in (1, 2, 3, 5)]
    run = evidence.run(number, model)
    assert load_claims.low_trial(run, before).holds
    least = min(other.peak for other in before)
    assert not load_claims.low_trial(with_curve(run, least * np.cos(SWEEP)), before).holds


def test_a_link_that_bears_the_torque_is_the_reason_and_one_that_does_not_is_not(
    evidence: Evidence,
) -> None:
    run = evidence.run(7, REPAIRED)
    assert load_claims.light_trial(run, 5).holds
    assert not load_claims.light_trial(run, 6).holds
    assert not load_claims.light_trial(run, 2).holds
    shares = [load_claims.light_trial(run, link).value for link in (5, 6)]
    assert sum(shares) == pytest.approx(1.0)


def test_case_8_is_zero_whatever_link_6_is(evidence: Evidence) -> None:
    """Joint 6 stands upright there: no mass and no centre of it could ask for torque."""
    run = evidence.run(8, REPAIRED)
    trial = load_claims.light_trial(run, 6)
    assert not trial.holds
    assert trial.why == "zero, whatever link 6 weighs: gravity lies along the axis"
    aside = moved_centre(run.model.arm, 6, (0.05, 0.0, 0.0))
    assert run_of(run, aside).peak == 0.0
    leaning = run_of(run, aside.with_gravity((3.0, 0.0, -9.0)))
    assert load_claims.light_trial(leaning, 6).holds


def run_of(run: Run, arm: SerialArm) -> Run:
    """The same case of another arm, by our recursion."""
    model = replace(run.model, arm=arm)
    return Run(run.case, model, run.q, gravity_torque(arm, run.q), run.expected)


def moved_centre(arm: SerialArm, link: int, com: tuple[float, float, float]) -> SerialArm:
    bodies = [body.inertia for body in arm.links]
    old = bodies[link - 1]
    bodies[link - 1] = Inertia(old.mass, np.array(com), old.tensor)
    return arm.with_inertias(bodies)
