"""JUnit XML, read back by another program: a case a rule, failures and reasons in them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from junitparser import Failure, JUnitXml, Skipped

from judged_files import SPOILED, SPOILED_NAME, judged
from ur5check._reports.junit import render_junit
from ur5check._validation.rule_outcomes import rules_asked


def read(folder: Path, spoiled: str = SPOILED) -> JUnitXml:
    return JUnitXml.fromstring(render_junit(*judged(folder, spoiled)).encode())


def cases(suite) -> dict[str, Any]:
    return {case.name.split()[0]: case for case in suite}


def test_a_suite_a_file_and_a_case_a_rule(here):
    _, configuration = judged(here)
    suites = {suite.name: suite for suite in read(here)}
    spoiled = cases(suites[SPOILED_NAME])
    asked = {rule.id for rule in rules_asked(SPOILED_NAME, configuration)}
    assert {name for name in spoiled if name[:3].isupper()} == asked
    assert not any(name.startswith(("ENG", "CMP", "XAC")) for name in spoiled)

    (failure,) = spoiled["INE101"].result
    assert isinstance(failure, Failure)
    assert failure.type == "INE101"
    line = next(k for k, text in enumerate(SPOILED.splitlines(), 1) if "<mass" in text)
    assert failure.text.startswith(f"line {line}:")
    (skipped,) = spoiled["JNT103"].result
    assert isinstance(skipped, Skipped)
    assert "a <passive> joint" in skipped.message
    assert spoiled["INE102"].is_passed
    good = cases(suites["good.urdf"])
    assert all(case.is_passed for case in good.values())


def test_the_counts_are_those_of_the_cases(here):
    report = read(here)
    assert (report.failures, report.errors) == (2, 0)  # INE101, and the pair
    assert report.tests == sum(len(list(suite)) for suite in report)
    for suite in report:
        assert suite.failures == sum(not c.is_passed and not c.is_skipped for c in suite)


def test_what_xml_has_no_place_for_is_replaced(here):
    verdicts, configuration = judged(here)
    (first, *others) = verdicts.models
    finding = replace(first.findings.open[0], message="a\x00b\x1bc")
    spoiled = replace(first, findings=replace(first.findings, open=(finding,)))
    text = render_junit(replace(verdicts, models=(spoiled, *others)), configuration)
    assert "a�b�c" in text
    JUnitXml.fromstring(text.encode())


@pytest.mark.parametrize("level", ["error", "warning"])
def test_a_finding_below_the_fail_level_passes_and_is_said(here, level):
    text = SPOILED.replace('value="-1"', 'value="1"').replace('name="j"', 'name="k"')
    verdicts, configuration = judged(here, text)
    models = tuple(replace(v, fail_level=level) for v in verdicts.models)
    xml = render_junit(replace(verdicts, models=models), configuration)
    suite = next(s for s in JUnitXml.fromstring(xml.encode()) if s.name == SPOILED_NAME)
    case = cases(suite)["JNT103"]
    assert case.is_passed == (level == "error")
    assert case.is_failure == (level == "warning")
    if level == "error":
        assert "joint 'k'" in case.system_out
