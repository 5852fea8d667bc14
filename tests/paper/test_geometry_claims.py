"""Table 1 in both readings, eq. (1), and the vectors of the listing."""

from __future__ import annotations

from dataclasses import replace

import pytest

from ur5check._paper import geometry_claims
from ur5check._paper.evidence import Evidence
from ur5check._paper.paper_models import PRINTED, REPAIRED
from ur5check._paper.table_readings import literal_reading
from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.transforms import Transform


def test_a_wrong_vector_is_named(evidence: Evidence) -> None:
    table = evidence.model(REPAIRED).arm
    assert geometry_claims.vector_trial(PRINTED, table, table, "table").holds
    wrong = geometry_claims.vector_trial(PRINTED, with_longer(table, 4, 1e-6), table, "table")
    assert not wrong.holds
    assert "link 4 is opposite" in wrong.why


def test_the_listing_contradicts_both_readings_of_table_1(evidence: Evidence) -> None:
    positive, literal, repaired = geometry_claims.vectors_from_dh(evidence)
    assert positive.value == pytest.approx(0.85)
    assert "links 2, 3, 5 " in positive.why
    assert literal.value == pytest.approx(2 * 0.09465)
    assert "link 5 " in literal.why
    assert [o.holds for o in (positive, literal, repaired)] == [False, False, True]


def test_only_one_reading_of_table_1_is_the_appendix(evidence: Evidence) -> None:
    literal, positive = geometry_claims.table_1_is_the_robot(evidence)
    assert literal.verdict == "refuted"
    assert positive.verdict == "confirmed after repair"
    assert positive.value < 1e-14
    assert 1.0 < literal.value <= 2 * (0.425 + 0.39225)  # both long links point the other way


def test_the_literal_reading_has_the_listings_lengths(evidence: Evidence) -> None:
    arm = literal_reading(evidence.model(REPAIRED).arm)
    assert [link.link_tip_frame.p[0] for link in arm.links] == [0, 0.425, 0.39225, 0, 0, 0]


def test_eq_1_needs_its_length_along_x(evidence: Evidence) -> None:
    printed, repaired = geometry_claims.eq_1_is_the_transform(evidence)
    assert not printed.holds
    assert printed.value > 0.425
    assert repaired.verdict == "confirmed after repair"


def test_a_tool_a_hundredth_of_a_millimetre_aside_is_refused(evidence: Evidence) -> None:
    arm = evidence.model(REPAIRED).arm
    assert geometry_claims.tool_trial("arm", "printed", arm, arm).holds
    aside = with_longer(arm, 6, 1e-5)
    trial = geometry_claims.tool_trial("arm", "printed", aside, arm)
    assert not trial.holds
    assert trial.value == pytest.approx(1e-5)


def with_longer(arm: SerialArm, link: int, longer: float) -> SerialArm:
    links = list(arm.links)
    P = links[link - 1].link_tip_frame
    links[link - 1] = replace(
        links[link - 1], link_tip_frame=Transform(P.R, P.p + [0.0, 0.0, longer])
    )
    return replace(arm, links=tuple(links))
