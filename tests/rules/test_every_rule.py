"""Every rule refuses its own bad example and accepts its good one, through the real reader."""

from __future__ import annotations

from pathlib import Path

import pytest

from ur5check._rules.registry import all_rules
from ur5check._validation.judgement import judge

SHOWN = [rule for rule in all_rules().values() if rule.example.startswith(".")]


def ids_found(text: str, folder: Path, suffix: str = ".urdf") -> set[str]:
    file = folder / f"arm{suffix}"
    file.write_text(text)
    return {finding.rule for finding in judge(file, samples=5).findings}


@pytest.mark.parametrize("rule", SHOWN, ids=lambda rule: rule.id)
def test_a_rule_refuses_its_bad_example(rule, tmp_path):
    assert rule.id in ids_found(rule.bad, tmp_path, rule.example)


@pytest.mark.parametrize("rule", SHOWN, ids=lambda rule: rule.id)
def test_a_rule_accepts_its_good_example(rule, tmp_path):
    assert rule.id not in ids_found(rule.good, tmp_path, rule.example)


def test_the_plain_example_has_no_finding_at_all(tmp_path):
    from ur5check._rules.examples import robot

    assert ids_found(robot(), tmp_path) == set()
