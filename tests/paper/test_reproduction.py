"""The paper reproduced: verdicts, mistakes, sentences, and the agreement of both engines."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from paper.curves import replaced, with_curve
from ur5check._paper.case_runs import Run
from ur5check._paper.claim import Claim, ClaimOutcome, Trial, judged
from ur5check._paper.claims import CLAIMS, OF_CASES, OF_NUMBERS
from ur5check._paper.evidence import Evidence
from ur5check._paper.paper_models import PINOCCHIO, PRINTED, REPAIRED
from ur5check._paper.reproduction import Reproduction, judge
from ur5check._reports.paper_summary import headline, headline_of_all, summarize, summary

VERDICTS = {
    "workspace-sphere": "refuted",
    "workspace-cylinder": "refuted",
    "eq-1": "confirmed after repair",
    "table-1": "confirmed after repair",
    "vectors": "confirmed after repair",
    "newton-euler": "refuted",
    "listing-runs": "confirmed after repair",
    "inertia-across": "refuted",
    "inertia-along": "confirmed",
    "inertia-frame": "refuted",
    "case-1-sine": "confirmed",
    "case-5-sine": "confirmed",
    "case-1-expected": "confirmed after repair",
    "case-2-expected": "confirmed after repair",
    "case-3-expected": "confirmed after repair",
    "case-4-expected": "confirmed",
    "case-5-expected": "confirmed after repair",
    "case-6-expected": "confirmed",
    "case-7-expected": "confirmed",
    "case-8-expected": "confirmed",
    "case-3-less": "confirmed",
    "case-4-zero": "confirmed",
    "case-7-low": "confirmed",
    "case-8-low": "confirmed",
    "case-7-light": "confirmed",
    "case-8-light": "refuted",
    "case-9-holds": "confirmed after repair",
    "soft-limits": "refuted",
}


def test_the_verdict_on_each_claim(reproduction: Reproduction) -> None:
    came = {claim.id: verdict for claim, verdict in reproduction.verdicts.items()}
    assert came == VERDICTS


def test_a_claim_has_one_id_and_every_outcome_a_claim(reproduction: Reproduction) -> None:
    ids = [claim.id for claim in reproduction.verdicts]
    assert len(ids) == len(set(ids))
    assert {outcome.id for outcome in reproduction.claims} == set(ids)
    assert all(claim.test and claim.source and claim.unit for claim in reproduction.verdicts)
    assert len(CLAIMS) == len(set(CLAIMS))


def test_a_family_of_claims_is_one_line_more(evidence: Evidence) -> None:
    claim = Claim("gain", "a gain", "a test", "eq. 28", "1")

    def gain(_: Evidence) -> tuple[ClaimOutcome, ...]:
        return judged(claim, [Trial("as printed", "printed", 2.0, 1.0)])

    assert judge(evidence, (*OF_NUMBERS, gain)).verdicts[claim] == "refuted"


def test_our_recursion_and_pinocchio_compute_the_same_curves(reproduction: Reproduction) -> None:
    assert reproduction.trustworthy
    assert reproduction.engines_apart < 1e-12


@pytest.mark.parametrize("number", range(1, 10))
def test_it_fails_where_pinocchio_disagrees(reproduction: Reproduction, number: int) -> None:
    def spoil(run: Run) -> Run:
        wrong = run.case.number == number and run.model.name == PINOCCHIO
        return replaced(run, run.torque + 1e-9) if wrong else run

    spoiled = replace(reproduction, cases=tuple(map(spoil, reproduction.cases)))
    assert not spoiled.trustworthy


def test_case_2_is_over_half_too_large_and_case_9_of_the_wrong_sign(
    reproduction: Reproduction,
) -> None:
    effects = {effect.case: effect for effect in reproduction.effects}
    assert effects[2].ratio == pytest.approx(-1.7447, abs=5e-5)
    assert effects[9].ratio == pytest.approx(-1.715, abs=5e-4)
    assert set(effects) == {1, 2, 3, 5, 6, 7, 9}  # without torque, nothing can be wrong with it


def test_the_listings_mistakes_explain_all_of_it(reproduction: Reproduction) -> None:
    mistakes = reproduction.listing_mistakes.diagnosis.mistakes
    found = {mistake.id: mistake.links for mistake in mistakes}
    assert found == {"length-sign": (2, 3, 5), "rotation-rounded": (1, 4, 5)}
    for effect in reproduction.effects:
        assert effect.left <= 1e-12
        assert effect.repaired == pytest.approx(effect.table, abs=1e-12)


def test_the_phase_shows_where_the_arm_is_level(reproduction: Reproduction) -> None:
    """Stretched out level at θ2 = 0: the peak is there, but for the wrist that stands aside."""
    for model in (REPAIRED, "appendix", "erd-ur5"):
        fit = reproduction.run(2, model).harmonic
        assert fit is not None
        assert np.degrees(fit.phase) == pytest.approx(-90.0, abs=2.0)
    printed = reproduction.run(2, PRINTED).harmonic
    assert printed is not None
    assert np.degrees(printed.phase) == pytest.approx(90.0, abs=2.0)


def test_the_summary_says_what_was_measured(reproduction: Reproduction) -> None:
    assert summary(reproduction).startswith("of 28 claims of the paper, 12 are confirmed, 9 only")
    told = " ".join(summarize(reproduction))
    assert "94.42 N m in case 2" in told
    assert "54.11 N m: 74.5 % too large, of opposite sign" in told
    assert "+65.9 N m where the controller's DH needs −38.4 N m: the wrong sign" in told
    assert "link 5 only (94.43 against 94.42 N m in case 2)" in told
    assert "0 of 6 printed inertia tensors follow eq. 3" in told
    assert "6 follow m((3r)² + l²)·0.08333" in told


def test_headlines_follow_the_curves(reproduction: Reproduction, evidence: Evidence) -> None:
    assert (
        headline(reproduction, 2)
        == "Not as expected; as printed 74.5 % too large, of opposite sign"
    )
    assert headline(reproduction, 4) == "Zero and constant, as claimed; gravity lies along the axis"
    assert headline(reproduction, 9) == (
        "As printed, joint 2 is given the wrong sign: +66 for −38 N m"
    )
    assert headline_of_all(reproduction) == (
        "As printed, 6 of 6 claims on a curve's shape hold, and 5 of 9 torques are wrong"
    )

    def repair(run: Run) -> Run:
        """The listing, had it been right."""
        if run.model.name != PRINTED:
            return run
        right = evidence.run(run.case.number, REPAIRED).torque
        return replaced(run, right)

    def bend(run: Run) -> Run:
        if run.model.name != PRINTED or run.case.watched is None:
            return run
        return with_curve(run, 100.0 + run.watched**2)

    repaired = judge(replace(evidence, runs=tuple(map(repair, evidence.runs))), OF_CASES)
    assert headline(repaired, 2) == "As expected; the appendix needs 7 % more"
    assert headline(repaired, 9) == "The torques as printed hold the arm"
    assert headline_of_all(repaired).endswith("and 0 of 9 torques are wrong")
    bent = judge(replace(evidence, runs=tuple(map(bend, evidence.runs))), OF_CASES)
    assert headline(bent, 1).startswith("No sine; as printed")
    assert headline(bent, 4).startswith("Not zero; as printed")
    assert any(line.startswith("Of 6 claims on the shape of a curve,") for line in summarize(bent))
