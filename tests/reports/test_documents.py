"""What reports say: verdict first, failures on top, only what differs."""

from __future__ import annotations

from dataclasses import replace

import ur5check
from ur5check._comparison.difference import Difference, compare
from ur5check._reports.diff_document import diff_document
from ur5check._reports.show_document import show_document
from ur5check._reports.terminal import render_text
from ur5check._reports.validate_document import validate_document
from ur5check._robot import Limits, Transform
from ur5check._robot.states import random_states
from ur5check._validation.validation import Validation


def test_verdict_comes_first(validation: Validation) -> None:
    lines = render_text(validate_document(validation)).splitlines()
    assert lines[0] == "Validation of paper against appendix"
    assert lines[2].startswith("PASS: the algorithm is right;")


def test_three_questions_under_three_headings(validation: Validation) -> None:
    titles = [section.title for section in validate_document(validation).sections]
    assert titles == ["The algorithm", "The bodies", "The numbers"]


def test_numbers_say_how_the_arms_were_laid_together(validation: Validation) -> None:
    numbers = validate_document(validation).sections[-1]
    assert "the base of appendix is turned by 180° about z" in numbers.lines[0]
    assert "no joint reversed; no zero shifted; all 6 axes are the same lines" in numbers.lines[0]
    assert any(line.startswith("The attribution is complete: ") for line in numbers.lines)


def test_a_failing_law_floats_to_the_top(failing: Validation) -> None:
    document = validate_document(failing)
    assert document.verdict is not None
    assert (document.verdict.word, document.verdict.good) == ("FAIL", False)
    assert "the algorithm is WRONG" in document.verdict.text
    fails, algorithm = document.sections[:2]
    failed = [o for o in failing.outcomes if not o.passed]
    shown, states = fails.tables
    assert all(o.id in row.cells[1] for o, row in zip(failed, shown.rows, strict=True))
    worst = failed[0].worst_state
    assert worst is not None
    assert states.rows[0].cells[3].split() == [f"{x:.4f}" for x in worst["q"]]
    marks = [row.cells[0] for row in algorithm.tables[0].rows]
    assert marks == sorted(marks)
    assert set(marks) == {"FAILS", "ok"}


def test_a_body_that_could_not_exist_is_named() -> None:
    arm = ur5check.load("paper")
    inertias = [link.inertia for link in arm.links]
    inertias[2] = replace(inertias[2], tensor=inertias[2].tensor * [[9], [1], [1]])
    validation = ur5check.validate(arm.with_inertias(inertias), samples=5)
    document = validate_document(validation)
    assert not validation.passed
    assert document.verdict is not None
    assert "a body COULD NOT EXIST" in document.verdict.text
    text = render_text(document, width=300)
    assert "link 3: a principal moment exceeds the sum of the others" in text


def test_many_models_share_one_column() -> None:
    validation = ur5check.validate("paper", "paper-listing", "appendix", "erd-ur5", samples=20)
    table = validate_document(validation).sections[0].tables[0]
    assert [column.title for column in table.columns] == [
        "",
        "law",
        "worst",
        "on",
        "must be",
        "unit",
    ]
    assert {row.cells[3] for row in table.rows} <= {m.arm.name for m in validation.models}


def test_only_what_differs_is_listed(difference: Difference) -> None:
    numbers = diff_document(difference).sections[0]
    tables = [table for table in numbers.tables if table.title.startswith("Numbers that differ")]
    listed = sum(len(table.rows) for table in tables)
    assert any(line.startswith(f"{60 - listed} of 60 masses, ") for line in numbers.lines)
    assert listed == (0 if difference.pair.a.name == "paper-listing" else 15)


def test_different_axes_are_measured(difference: Difference) -> None:
    tables = diff_document(difference).sections[0].tables
    title = "Angle and distance between corresponding axes at q = 0"
    between = [table.title == title for table in tables]
    assert any(between) is not difference.pair.alignment.exact
    if any(between):
        axes, reaches, *_ = tables
        assert len(axes.rows) == 6
        assert [row.cells[0] for row in reaches.rows] == ["link 2", "link 3", "link 5"]


def test_the_same_arm_moved_agrees() -> None:
    arm = ur5check.load("appendix")
    moved = replace(
        arm,
        name="moved",
        base=Transform.from_rpy((0.1, 0.2, 0.3), (0, 0, 0.5)) @ arm.base,
    )
    document = diff_document(compare(arm, moved, random_states(6, 50, 0), 0))
    assert document.verdict is not None
    assert (document.verdict.word, document.verdict.good) == ("AGREE", True)
    assert "turned by" in document.sections[0].lines[0]


def test_show_speaks_in_the_files_own_frames() -> None:
    text = render_text(show_document(ur5check.load("appendix")))
    assert "(0, 0, 0.28)" in text  # upper_arm_link's <inertial><origin xyz>
    assert "(0, -119.7, 425)" in text  # elbow_joint's <origin xyz>


def test_reversed_and_shifted_joints_are_named() -> None:
    arm = ur5check.load("appendix")
    # Without limits: those of a shifted joint would differ.
    arm = replace(arm, joints=tuple(replace(joint, limits=Limits()) for joint in arm.joints))
    joints, links = list(arm.joints), list(arm.links)
    joints[2] = replace(joints[2], axis=-joints[2].axis)
    links[1] = replace(links[1], link_tip_frame=joints[1].motion(0.25) @ links[1].link_tip_frame)
    other = replace(arm, name="other", joints=tuple(joints), links=tuple(links))
    document = diff_document(compare(arm, other, random_states(6, 50, 0), 0))
    assert document.verdict is not None
    assert document.verdict.word == "AGREE"
    said = document.sections[0].lines[0]
    assert "reversed: elbow_joint; zeros shifted: shoulder_lift_joint by -14.3239°;" in said
