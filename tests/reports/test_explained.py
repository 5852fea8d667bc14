"""What `diff` says of causes: every section, its evidence, and nothing where there is nothing."""

from __future__ import annotations

from dataclasses import replace

import pytest

import ur5check
from ur5check._comparison.attribution_detail import by_parameter
from ur5check._comparison.diagnosis.diagnosis import diagnose
from ur5check._comparison.difference import Difference
from ur5check._comparison.explanation import Explanation
from ur5check._reports.diff_document import diff_document
from ur5check._reports.diff_sections.mistakes_found import findings_section
from ur5check._reports.document import Document, Section, Table
from ur5check._reports.explanation_summary import removed

SECTIONS = [
    "Mistakes found",
    "The numbers",
    "Attribution",
    "Identifiability",
    "Rounding",
    "Worst case",
    "Plausibility",
]


@pytest.fixture(scope="session")
def document(explanation: Explanation) -> Document:
    return diff_document(explanation.difference, explanation)


@pytest.fixture(scope="session")
def equal() -> Explanation:
    return ur5check.explain(ur5check.diff("appendix", "appendix", samples=50))


def section(document: Document, title: str) -> Section:
    return next(section for section in document.sections if section.title == title)


def table(section: Section, title: str) -> Table:
    return next(table for table in section.tables if table.title == title)


def column(table: Table, title: str) -> list[str]:
    place = [column.title for column in table.columns].index(title)
    return [row.cells[place] for row in table.rows]


def test_sections_stand_in_order(document: Document) -> None:
    assert [section.title for section in document.sections] == SECTIONS


def test_a_quick_report_gives_no_reasons(difference: Difference) -> None:
    titles = [section.title for section in diff_document(difference).sections]
    assert titles == ["The numbers", "Attribution"]


def test_every_finding_has_its_evidence(document: Document, explanation: Explanation) -> None:
    evidence, words, details, *_ = section(document, "Mistakes found").tables
    diagnosis = explanation.diagnosis
    by_id = {finding.id: finding for finding in diagnosis.mistakes}
    assert sorted(column(evidence, "mistake")) == sorted(by_id)
    for id_, removes in zip(column(evidence, "mistake"), column(evidence, "removes"), strict=True):
        finding = by_id[id_]
        moved = finding.before != finding.after
        assert removes == (f"{100 * removed(finding, diagnosis):.1f} %" if moved else "–")
    assert len(words.rows) == len(evidence.rows)
    assert len(details.rows) == sum(len(finding.explained) for finding in diagnosis.mistakes)


def test_what_changes_no_torque_comes_last(equal: Explanation) -> None:
    """The appendix's base is turned against the paper's: no number is wrong."""
    d = ur5check.diff("paper", "appendix", samples=50)
    explanation = replace(equal, difference=d, diagnosis=diagnose(d.pair, d.states))
    evidence, words, *_ = findings_section(explanation).tables
    assert column(evidence, "mistake")[-1] == "base-turned"
    assert column(evidence, "removes")[-1] == "–"
    mistakes = tuple(replace(f, equals=("mass-digits",)) for f in explanation.diagnosis.mistakes)
    tied = replace(explanation, diagnosis=replace(explanation.diagnosis, mistakes=mistakes))
    _, words, *_ = findings_section(tied).tables
    assert any("Explained as well by: " in cell for cell in column(words, "explanation"))


def test_what_nothing_explains_is_said(document: Document, explanation: Explanation) -> None:
    left = explanation.diagnosis.unexplained
    tables = [t for t in section(document, "Mistakes found").tables if t.title == "Unexplained"]
    assert [len(t.rows) for t in tables] == ([len(left)] if left else [])


def test_contributions_are_ranked_by_weight(document: Document) -> None:
    contributions = table(section(document, "Attribution"), "By parameter group")
    weights = [float(cell) for cell in column(contributions, "weight [%]")]
    assert weights == sorted(weights, reverse=True)
    assert "-0.0" not in column(contributions, "share [%]")


def test_contributions_that_cancel_are_named() -> None:
    """Link 1 lighter and link 2 heavier about one axis: parts of 10, a difference of next to none.

    Link 2's mass goes up, its centre of mass comes nearer, and their moment stays.
    """
    arm = ur5check.load("appendix")
    inertias = [link.inertia for link in arm.links]
    at_joint = inertias[1].expressed_in(arm.links[1].link_tip_frame)
    heavy = replace(at_joint, mass=2.0 * at_joint.mass, com=0.5 * at_joint.com)
    inertias[1] = heavy.expressed_in(arm.links[1].link_tip_frame.inverse())
    d = ur5check.diff(arm, arm.with_inertias(inertias), samples=200)
    assert d.attribution.cancels
    lines = section(diff_document(d), "Attribution").lines
    assert any("Contributions cancel" in line for line in lines)


def test_parameters_on_demand(difference: Difference) -> None:
    parameters = by_parameter(difference.pair, difference.states)
    document = diff_document(difference, parameters=parameters)
    found = table(section(document, "Attribution"), "Parameter by parameter")
    if difference.pair.a.name == "paper-listing":
        assert column(found, "parameter") == ["geometry"]
    else:
        assert any(cell.startswith("Izz of wrist_1_link") for cell in column(found, "parameter"))


def test_every_parameter_stands_in_its_links_row(document: Document) -> None:
    seen = section(document, "Identifiability")
    assert seen.lines[0].startswith("Joint torques determine 36 combinations of ")
    (labels,) = seen.tables
    for row in labels.rows:
        assert len(" ".join(row.cells[1:]).replace("–", "").split()) == 10


def test_combinations_are_written_out_on_demand(explanation: Explanation) -> None:
    d = explanation.difference
    document = diff_document(d, explanation, written_out=True)
    combinations = table(section(document, "Identifiability"), "Identifiable combinations")
    assert len(combinations.rows) == 36


def test_digits_say_what_they_leave(document: Document, explanation: Explanation) -> None:
    digits = section(document, "Rounding")
    assert "remain at joint " in digits.lines[0]
    (items,) = digits.tables
    assert len(items.rows) == len(explanation.budget.items)
    assert set(column(items, "")) == {"recomputed", "bound"}


def test_the_worst_case_has_a_posture(document: Document, explanation: Explanation) -> None:
    moving, motion, resting = section(document, "Worst case").tables
    assert len(moving.rows) == len(resting.rows) == explanation.difference.pair.a.n + 1
    assert all(len(row.cells[1].split()) == len(row.cells[2].split()) == 6 for row in motion.rows)
    # A vertical first axis feels no gravity: nothing to climb, no posture to show.
    assert column(resting, "posture [°]")[0] == "–"
    for cell in column(moving, "reached"):
        reached, starts = map(int, cell.split("/"))
        assert 1 <= reached <= starts


def test_the_gravest_oddity_comes_first(document: Document, explanation: Explanation) -> None:
    (found,) = section(document, "Plausibility").tables
    severities = column(found, "")
    assert severities == sorted(severities, key=["impossible", "suspicious", "note"].index)
    assert any(row.bad for row in found.rows) is ("impossible" in severities)
    if explanation.difference.pair.a.name == "erd-ur5":
        assert severities[0] == "impossible"


def test_where_nothing_differs_nothing_is_explained(equal: Explanation) -> None:
    document = diff_document(equal.difference, equal)
    assert document.verdict is not None
    assert document.verdict.word == "AGREE"
    assert section(document, "Mistakes found").tables == ()
    assert section(document, "Attribution").tables == ()
    assert section(document, "Worst case").tables == ()
    assert "Same numbers, same dynamics." in section(document, "Identifiability").lines
