"""An effort limit of zero, of infinity, or absent is unknown, everywhere."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

import ur5check
from ur5check import SerialArm
from ur5check._comparison.arm_pair import pair_up
from ur5check._reports.diff_document import diff_document
from ur5check._reports.diff_json import diff_json
from ur5check._reports.json_report import json_text
from ur5check._reports.show_document import show_document
from ur5check._reports.terminal import render_text
from ur5check._robot.serial_arm import Limits

UNKNOWN = [0.0, None, math.inf, 1.7976931348623157e308, -1.0, math.nan]


def with_effort(name: str, effort: float | None) -> SerialArm:
    """A shipped model with this effort limit at its first joint."""
    arm = ur5check.load(name)
    first, *others = arm.joints
    first = replace(first, limits=replace(first.limits, effort=effort))
    return replace(arm, joints=(first, *others))


@pytest.mark.parametrize("effort", UNKNOWN)
def test_unknown(effort: float | None) -> None:
    assert Limits(effort=effort).known_effort is None


def test_known() -> None:
    assert Limits(effort=150.0).known_effort == 150.0


@pytest.mark.parametrize("effort", UNKNOWN)
def test_the_other_model_is_asked(effort: float | None) -> None:
    pair = pair_up(with_effort("paper", effort), with_effort("appendix", 120.0))
    assert pair.effort_limits[0] == 120.0
    pair = pair_up(with_effort("paper", 120.0), with_effort("appendix", effort))
    assert pair.effort_limits[0] == 120.0


@pytest.mark.parametrize("effort", UNKNOWN)
def test_no_report_divides_by_it(effort: float | None) -> None:
    a, b = with_effort("paper", effort), with_effort("appendix", effort)
    d = ur5check.diff(a, b, samples=20)
    assert np.isnan(d.torques.share_of_effort()[0])
    for document in (diff_document(d), show_document(a)):
        text = render_text(document)
        assert "inf" not in text
        assert "nan" not in text
    report = json.loads(json_text(diff_json(d)))
    first = report["comparison"]["torques"][0]
    assert (first["effort_limit"], first["max_share_of_effort"]) == (None, None)
    assert math.isnan(ur5check.sweep(a, b, states=50).share_of_effort()[0])


def test_the_worst_case_does_not_divide_by_it() -> None:
    d = ur5check.diff(with_effort("paper", 0.0), with_effort("appendix", 0.0), samples=20)
    cases = ur5check.explain(d).worst
    assert [case.effort_share for case in cases if case.joint == 1] == [None, None]
    assert all(math.isfinite(case.value) for case in cases)
