"""The nine cases as they are asked: postures, sweeps, and the torque that they should give."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from examples import UR5S, planar_arm, random_arm
from ur5check._paper.cases import CASES, case
from ur5check._paper.evidence import Evidence
from ur5check._paper.harmonic import fit_harmonic
from ur5check._paper.paper_models import PRINTED
from ur5check._paper.statics import holding_torque, nothing_to_hold
from ur5check._robot.serial_arm import SerialArm

#: As the paper has them, typed once more: posture [°], watched joint.  None goes round.
POSTURES = {
    1: ((0, 90, None, 0, 0, 0), 3),
    2: ((0, None, 0, 0, 0, 0), 2),
    3: ((0, None, 90, 0, 0, 0), 2),
    4: ((None, 0, 0, 0, 0, 0), 1),
    5: ((0, 90, 90, None, 0, 0), 4),
    6: ((0, 90, 0, 0, None, 0), 5),
    7: ((0, 90, 90, 90, None, 0), 5),
    8: ((0, 90, 90, 90, 90, None), 6),
}


@pytest.mark.parametrize("number", POSTURES)
def test_a_sweep_goes_round_in_steps_of_a_degree(number: int) -> None:
    posture, watched = POSTURES[number]
    q = np.degrees(case(number).joint_angles())
    assert q.shape == (361, 6)
    for i, angle in enumerate(posture):
        expected = np.arange(361.0) if angle is None else np.full(361, angle)
        assert q[:, i] == pytest.approx(expected)
    assert case(number).watched == watched
    assert case(number).swept == posture.index(None) + 1


def test_case_9_is_one_posture() -> None:
    assert case(9).joint_angles().tolist() == [[0.0, 0.9, -1.0, 1.0, 3.5, -1.9]]
    assert case(9).watched is None
    assert [c.number for c in CASES] == list(range(1, 10))


def test_every_case_is_run_for_every_model(evidence: Evidence) -> None:
    names = [model.name for model in evidence.models]
    assert names == ["paper-listing", "paper", "appendix", "erd-ur5", "appendix by Pinocchio"]
    assert [(r.case.number, r.model.name) for r in evidence.runs] == [
        (number, name) for number in range(1, 10) for name in names
    ]


def test_a_lever_is_a_lever() -> None:
    """1 kg at the end of 2 m, level and then upright."""
    arm = planar_arm((2.0,), (1.0,))
    tau = holding_torque(arm, np.array([[0.0], [-np.pi / 2]]))
    assert np.abs(tau[:, 0]) == pytest.approx([9.81 * 2.0, 0.0], abs=1e-14)


@pytest.mark.parametrize(
    "arm",
    [*(ur5check.load(name) for name in UR5S), random_arm(5, 7, prismatic=False)],
    ids=lambda arm: arm.name,
)
def test_levers_and_the_recursion_agree_on_any_arm(arm: SerialArm) -> None:
    q = np.random.default_rng(3).uniform(-3, 3, (50, arm.n))
    tau = ur5check.gravity_torque(arm, q)
    assert holding_torque(arm, q) == pytest.approx(
        tau, abs=1e-12 * float(np.abs(tau).max()) * arm.n
    )


@pytest.mark.parametrize("seed", range(4))
def test_gravitys_torque_on_the_joint_that_turns_is_a_sine_on_any_arm(seed: int) -> None:
    """Why a sine says nothing of the numbers: the moved part's centre of mass goes in a circle."""
    arm = random_arm(4, seed, prismatic=False)
    angle = np.radians(np.arange(361.0))
    q = np.tile(np.random.default_rng(seed).uniform(-3, 3, arm.n), (361, 1))
    q[:, seed] = angle
    tau = ur5check.gravity_torque(arm, q)
    fit = fit_harmonic(angle, tau[:, seed], 1e-12)
    assert fit.departure < 1e-12
    assert fit.amplitude > 0.01


@pytest.mark.parametrize(("amplitude", "phase", "offset"), [(2.0, 0.7, 0.0), (0.3, -3.0, 1.5)])
def test_a_sine_gives_back_its_amplitude_phase_and_offset(
    amplitude: float, phase: float, offset: float
) -> None:
    angle = np.radians(np.arange(361.0))
    fit = fit_harmonic(angle, offset + amplitude * np.sin(angle + phase), 1e-12)
    assert (fit.amplitude, fit.phase, fit.offset) == pytest.approx((amplitude, phase, offset))
    assert fit.residual < 1e-14
    assert fit.departure == pytest.approx(offset / amplitude, abs=1e-13)


def test_why_there_is_nothing_to_hold(evidence: Evidence) -> None:
    def why(number: int, model: str) -> str:
        run = evidence.run(number, model)
        assert run.case.watched is not None
        return nothing_to_hold(run.model.arm, run.q, run.case.watched)

    upright = "gravity lies along the axis"
    balanced = "the centre of mass of all that joint 5 carries lies on its axis"
    assert why(4, "paper") == why(8, "paper") == why(8, "erd-ur5") == upright
    assert why(7, "erd-ur5") == balanced
    assert [why(number, "paper") for number in (1, 2, 3, 5, 6, 7)] == [""] * 6


def test_what_it_should_be_knows_nothing_of_the_listings_vectors(evidence: Evidence) -> None:
    listing = evidence.model(PRINTED)
    q = case(2).joint_angles()
    as_printed = holding_torque(listing.arm, q)
    should_be = holding_torque(listing.true_arm, q)
    assert as_printed == pytest.approx(ur5check.gravity_torque(listing.arm, q), abs=1e-12)
    assert np.abs(as_printed[:, 1]).max() > 1.7 * np.abs(should_be[:, 1]).max()
