"""Rules and the registry refuse what would be no rule."""

from __future__ import annotations

import pytest

from ur5check._finding import Finding, Place, worst_first
from ur5check._rules.registry import all_rules
from ur5check._rules.rule import Rule

RECORD = {
    "id": "INE999",
    "name": "a-rule",
    "severity": "error",
    "checks": "something",
    "why": "it matters",
    "consequence": "the arm falls",
    "bad": "<robot/>",
    "good": "<robot name='r'/>",
    "fix": "give a name",
}


@pytest.mark.parametrize(
    "change",
    [
        {"bad": " "},
        {"good": ""},
        {"why": ""},
        {"consequence": ""},
        {"fix": ""},
        {"id": "INE99"},
        {"id": "ABC101"},
    ],
)
def test_a_rule_that_shows_nothing_is_refused(change):
    assert Rule(**RECORD).family == "INE"
    with pytest.raises(ValueError, match=r"INE|ABC"):
        Rule(**(RECORD | change))


def test_ids_of_the_registry_are_its_rules_ids_in_order():
    rules = all_rules()
    assert list(rules) == sorted(rules)
    assert all(rule.id == key for key, rule in rules.items())


def test_the_worst_finding_comes_first():
    def finding(severity, line, rule="INE999"):
        return Finding(rule, severity, "link 'a'", "", (Place("f", line),))

    note, warning, error = finding("note", 1), finding("warning", 1), finding("error", 9)
    second, whole = finding("error", 2), finding("error", 1, "ROB101")
    found = worst_first([note, warning, whole, error, second])
    assert found == [second, error, whole, warning, note]


def test_a_finding_is_one_line_with_its_place():
    place = Place("arm.urdf", 12, 5, "link 'a' inertial/mass")
    found = Finding("INE999", "error", "link 'a'", "mass is -1 kg", (place,), fix="give kilograms")
    assert str(found) == "arm.urdf:12:5: error INE999: link 'a': mass is -1 kg; give kilograms"
