"""A known issue explains every kind of difference that it lists, and only those."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._engines.audit.import_difference import KINDS
from ur5check._engines.known_issues import (
    known_issue_for,
    known_issues_of,
    repairable,
    repaired,
    repaired_text,
)
from ur5check._engines.registry import READERS
from ur5check._errors import UsageError

ALL = [(key, issue) for key in READERS for issue in known_issues_of(key)]


@pytest.mark.parametrize(
    ("key", "kind", "issue"),
    [
        ("drake", "tensor-changed", "drake-impossible-tensor"),
        ("drake", "com-moved", "drake-impossible-tensor"),
        ("drake", "mass-changed", "drake-impossible-tensor"),
        ("mujoco", "body-merged", "mujoco-fuses-fixed-links"),
        ("mujoco", "body-lost", "mujoco-fuses-fixed-links"),
        ("pinocchio", "base-ignored", "pinocchio-merges-fixed-links"),
        ("idyntree", "body-merged", "idyntree-links-become-frames"),
        ("gazebo", "effort-limit", "gazebo-no-limit"),
        ("dart", "default-inertia", "dart-default-inertia"),
    ],
)
def test_a_known_issue_is_found_by_each_of_its_kinds(key, kind, issue):
    assert known_issue_for(key, kind).id == issue


def test_a_kind_that_no_issue_lists_is_not_explained():
    assert known_issue_for("mujoco", "default-inertia") is None
    assert known_issue_for("ur5check", "default-inertia") is None
    assert known_issue_for("no-such-engine", "default-inertia") is None


def test_issues_list_kinds_that_the_audit_knows():
    assert {kind for _, issue in ALL for kind in issue.kinds} <= set(KINDS)


def test_a_repair_is_written_for_the_reader_that_needs_it():
    assert repairable() == ("mujoco", "drake", "dart", "gazebo")
    arm = ur5check.load("appendix")
    text, avoided = repaired_text(arm.source.urdf, "dart")
    assert {issue.id for issue in avoided} == {"dart-default-inertia", "dart-floating-root"}
    # A second repair has nothing left to do.
    assert repaired_text(text, "dart") == (text, ())
    assert repaired(arm, "dart").source.urdf == text
    assert repaired(arm, "pinocchio") is arm
    with pytest.raises(UsageError, match="nothing needs to be rewritten for 'pinocchio'"):
        repaired_text(arm.source.urdf, "pinocchio")
