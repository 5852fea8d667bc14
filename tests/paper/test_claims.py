"""Every claim can come out false: fed with a curve or a number that breaks it, it refuses."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from paper.curves import replaced, with_curve
from ur5check._paper import curve_claims, load_claims, number_claims
from ur5check._paper.case_runs import Run
from ur5check._paper.cases import SWEEP
from ur5check._paper.claim import Claim, Trial, judged, overall
from ur5check._paper.evidence import Evidence
from ur5check._paper.paper_models import PRINTED, REPAIRED, Form
from ur5check._robot.inertia import Inertia
from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.transforms import Transform

MODELS = (PRINTED, REPAIRED, "appendix", "erd-ur5", "appendix by Pinocchio")

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


def test_what_is_too_large_or_turned_is_told(evidence: Evidence) -> None:
    run = evidence.run(2, REPAIRED)
    twice = curve_claims.expectation_trial(with_curve(run, -2.0 * run.watched))
    assert twice.why == "peak 108.3 for 54.13 N m: 100 % too large, the wrong way round"
    half = curve_claims.expectation_trial(with_curve(run, 0.5 * run.watched))
    assert half.why.endswith("50 % too small")
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


def test_a_vector_that_does_not_follow_from_the_table_is_named(evidence: Evidence) -> None:
    table = evidence.model(REPAIRED).arm
    assert number_claims.vector_trial(table, table).holds
    wrong = number_claims.vector_trial(with_reach(table, 4, 1e-6), table)
    assert not wrong.holds
    assert wrong.why == "links 4 reach the wrong way"


def test_a_tensor_of_another_formula_is_refused(evidence: Evidence) -> None:
    honest = tuple(replace(f, across=round(f.honest, 9)) for f in evidence.formulas)
    assert number_claims.across_trial(honest).holds
    spoiled = (*honest[:3], replace(honest[3], across=honest[3].across + 2e-9), *honest[4:])
    assert not number_claims.across_trial(spoiled).holds
    assert number_claims.along_trial(evidence.formulas).holds
    off = tuple(replace(f, along_error=2 * f.half_unit) for f in evidence.formulas)
    assert not number_claims.along_trial(off).holds


def test_a_cylinder_across_its_link_is_refused(evidence: Evidence) -> None:
    appendix = evidence.model("appendix").arm
    assert number_claims.direction_trial(appendix, "appendix", "other").holds
    turned = with_turned_tensor(appendix, 3)
    assert not number_claims.direction_trial(turned, "appendix", "other").holds


@pytest.mark.parametrize(
    ("bound", "inside", "edge", "outside"),
    [
        ("at most", 0.9, True, 1.1),
        ("at least", 1.1, True, 0.9),
        ("below", 0.9, False, 1.1),
        ("above", 1.1, False, 0.9),
    ],
)
def test_a_limit_has_two_sides(bound: str, inside: float, edge: bool, outside: float) -> None:
    def holds(value: float) -> bool:
        return Trial("arm", "other", value, 1.0, bound=bound).holds  # type: ignore[arg-type]

    assert holds(inside)
    assert holds(1.0) is edge
    assert not holds(outside)
    assert not holds(float("nan"))


def trial(form: Form, *, holds: bool) -> Trial:
    return Trial(form, form, 0.0 if holds else 2.0, 1.0)


@pytest.mark.parametrize(
    ("printed", "repaired", "verdict", "of_the_repaired"),
    [
        (True, True, "confirmed", "confirmed"),
        (False, True, "confirmed after repair", "confirmed after repair"),
        (False, False, "refuted", "refuted"),
        (True, False, "confirmed", "refuted"),
    ],
)
def test_a_verdict_asks_what_is_printed_then_what_is_repaired(
    printed: bool, repaired: bool, verdict: str, of_the_repaired: str
) -> None:
    claim = Claim("id", "text", "test", "source", "1")
    trials = (trial("printed", holds=printed), trial("repaired", holds=repaired))
    outcomes = judged(claim, trials)
    assert overall(outcomes) == verdict
    assert outcomes[1].verdict == of_the_repaired
    assert [o.holds for o in outcomes] == [printed, repaired]
    assert judged(claim, [*trials, trial("other", holds=True)])[2].verdict == "confirmed"


def test_without_a_repair_what_fails_is_refuted() -> None:
    claim = Claim("id", "text", "test", "source", "1")
    others = (trial("printed", holds=False), trial("other", holds=True))
    assert overall(judged(claim, others)) == "refuted"


def test_a_claim_that_is_put_to_nothing_printed_is_no_claim() -> None:
    claim = Claim("id", "text", "test", "source", "1")
    with pytest.raises(ValueError, match="'id' is put to nothing that the paper printed"):
        judged(claim, [trial("repaired", holds=True)])


def run_of(run: Run, arm: SerialArm) -> Run:
    """The same case of another arm, by our recursion."""
    from ur5check._dynamics.equations import gravity_torque

    model = replace(run.model, arm=arm)
    return Run(run.case, model, run.q, gravity_torque(arm, run.q), run.expected)


def moved_centre(arm: SerialArm, link: int, com: tuple[float, float, float]) -> SerialArm:
    bodies = [body.inertia for body in arm.links]
    old = bodies[link - 1]
    bodies[link - 1] = Inertia(old.mass, np.array(com), old.tensor)
    return arm.with_inertias(bodies)


def with_reach(arm: SerialArm, link: int, longer: float) -> SerialArm:
    links = list(arm.links)
    P = links[link - 1].link_tip_frame
    links[link - 1] = replace(
        links[link - 1], link_tip_frame=Transform(P.R, P.p + [0.0, 0.0, longer])
    )
    return replace(arm, links=tuple(links))


def with_turned_tensor(arm: SerialArm, link: int) -> SerialArm:
    """The tensor as it would stand if frame x were frame z."""
    bodies = [body.inertia for body in arm.links]
    R = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
    old = bodies[link - 1]
    bodies[link - 1] = Inertia(old.mass, old.com, R @ old.tensor @ R.T)
    return arm.with_inertias(bodies)
