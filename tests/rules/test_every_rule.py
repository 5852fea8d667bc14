"""Every rule refuses its own bad example and accepts its good one, through the real reader."""

from __future__ import annotations

from pathlib import Path

import pytest

from ur5check._rules.examples import joint, link, robot
from ur5check._rules.registry import all_rules
from ur5check._validation.judgement import judge

SHOWN = [rule for rule in all_rules().values() if rule.example.startswith(".")]


def ids_found(
    text: str, folder: Path, suffix: str = ".urdf", engines: tuple[str, ...] = ()
) -> set[str]:
    file = folder / f"arm{suffix}"
    file.write_text(text)
    return {finding.rule for finding in judge(file, samples=5, engines=engines).findings}


def asked(rule) -> tuple[str, ...]:
    return ("all",) if rule.family == "ENG" else ()


@pytest.mark.parametrize("rule", SHOWN, ids=lambda rule: rule.id)
def test_a_rule_refuses_its_bad_example(rule, tmp_path):
    assert rule.id in ids_found(rule.bad, tmp_path, rule.example, asked(rule))


@pytest.mark.parametrize("rule", SHOWN, ids=lambda rule: rule.id)
def test_a_rule_accepts_its_good_example(rule, tmp_path):
    assert rule.id not in ids_found(rule.good, tmp_path, rule.example, asked(rule))


def test_the_plain_example_has_no_finding_at_all(tmp_path):
    assert ids_found(robot(), tmp_path) == set()


def test_rounding_in_place_of_a_tensor_is_no_tensor(tmp_path):
    """What an exporter leaves is judged as zero, whatever its signs; larger entries are not."""
    for entries in ({"ixx": "2e-18", "iyy": "-1e-20", "izz": "1e-19"}, {"ixx": "1e-13"}):
        dust = {"ixx": "0", "iyy": "0", "izz": "0", **entries}
        assert ids_found(robot(joint(), link(**dust)), tmp_path) == {"INE106"}
    small = {"ixx": "2e-9", "iyy": "-1e-9", "izz": "2e-9"}
    assert "INE102" in ids_found(robot(joint(), link(**small)), tmp_path)
