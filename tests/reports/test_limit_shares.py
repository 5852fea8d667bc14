"""Every percentage of an effort limit that a report shows is torque difference over limit."""

from __future__ import annotations

import re

import pytest

import ur5check
from ur5check._comparison.difference import Difference
from ur5check._comparison.explanation import Explanation
from ur5check._reports.diff_sections.worst_configuration import worst_section
from ur5check._reports.difference_summary import summarize as difference_summary
from ur5check._reports.document import Document, Section, Table
from ur5check._reports.explanation_summary import summarize as explanation_summary
from ur5check._reports.pair_parts import torque_table
from ur5check._reports.simulate_document import simulate_document
from ur5check._reports.sweep_document import sweep_document
from ur5check._reports.sweep_summary import summarize as sweep_summary
from ur5check._simulation.static_hold import stand

#: Effort limits of a UR5 [N m], from its URDF.
LIMITS = [150.0, 150.0, 150.0, 28.0, 28.0, 28.0]


@pytest.fixture(scope="module")
def explained() -> Explanation:
    return ur5check.explain(ur5check.diff("erd-ur5", "appendix", samples=200))


@pytest.fixture(scope="module")
def compared(explained: Explanation) -> Difference:
    return explained.difference


def column(table: Table, title: str) -> list[str]:
    place = [column.title for column in table.columns].index(title)
    return [row.cells[place] for row in table.rows]


def table_with(part: Document | Section, title: str) -> Table:
    sections = part.sections if isinstance(part, Document) else (part,)
    return next(
        table
        for section in sections
        for table in section.tables
        if title in [column.title for column in table.columns]
    )


def percentages(shares: list[float]) -> list[str]:
    return [f"{100.0 * share:.2f}" for share in shares]


def share_in(sentence: str) -> float:
    """What a sentence calls "12% of its limit"."""
    found = re.search(r"(\d+)% of its limit", sentence)
    assert found is not None, sentence
    return float(found[1]) / 100.0


def test_the_torque_table(compared: Difference) -> None:
    shares = [float(x) / limit for x, limit in zip(compared.torques.maximum, LIMITS, strict=True)]
    assert column(torque_table(compared), "max of limit [%]") == percentages(shares)
    assert any(share > 0.01 for share in shares)


def test_the_verdict_of_diff(compared: Difference) -> None:
    worst = int(compared.torques.maximum.argmax())
    expected = float(compared.torques.maximum[worst]) / LIMITS[worst]
    assert share_in(difference_summary(compared)[0]) == pytest.approx(expected, abs=0.005)


def test_the_worst_configuration(explained: Explanation) -> None:
    moving = [case for case in explained.worst if not case.static and case.joint is not None]
    by_joint = {case.joint: case.value for case in moving}
    shares = [by_joint[i] / limit for i, limit in enumerate(LIMITS, 1)]
    table = table_with(worst_section(explained), "of limit [%]")
    assert column(table, "of limit [%]")[:6] == percentages(shares)
    (sentence,) = (s for s in explanation_summary(explained) if s.startswith("Worst state within"))
    worst = max(range(len(shares)), key=lambda i: by_joint[i + 1])
    assert share_in(sentence) == pytest.approx(shares[worst], abs=0.005)


def test_a_sweep() -> None:
    sweep = ur5check.sweep("paper", "appendix", states=500)
    shares = [float(x) / limit for x, limit in zip(sweep.maximum, LIMITS, strict=True)]
    table = table_with(sweep_document(sweep), "max of limit [%]")
    assert column(table, "max of limit [%]") == percentages(shares)
    worst = int(sweep.maximum.argmax())
    assert share_in(sweep_summary(sweep)[0]) == pytest.approx(shares[worst], abs=0.005)


def test_a_simulation() -> None:
    hold = stand(
        ur5check.load("appendix"), ur5check.load("paper"), [0, -1, 1, 0, 1, 0], seconds=0.01
    )
    shares = [
        abs(float(given - needed)) / limit
        for given, needed, limit in zip(hold.given, hold.needed, LIMITS, strict=True)
    ]
    table = table_with(simulate_document(hold), "of the limit [%]")
    assert column(table, "of the limit [%]") == percentages(shares)
    assert max(shares) > 0.005
