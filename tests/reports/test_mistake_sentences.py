"""Recognised mistakes as findings: rule, place, what happened, and the torque that it explains."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.diagnosis.diagnosis import diagnose
from ur5check._reports.mistake_sentences import advice, findings, sentence
from ur5check._robot.states import random_states
from ur5check._rules.registry import rule_of

STATES = random_states(6, 100, seed=0)


def test_the_listings_mistakes_are_findings_of_their_rules():
    diagnosis = diagnose(pair_up(*map(ur5check.load, ("paper-listing", "paper"))), STATES)
    found = findings(diagnosis)
    assert [finding.rule for finding in found] == ["CMP164", "CMP206", "CMP151"]
    assert found[2].subject == "links 2, 3 and 5 of paper-listing"
    assert sum(finding.effect or 0.0 for finding in found) == pytest.approx(diagnosis.before)
    for finding in found:
        assert finding.fix == rule_of(finding.rule).fix


def test_two_mistakes_in_one_number_are_two_findings_and_one_sentence():
    diagnosis = diagnose(pair_up(*map(ur5check.load, ("paper", "appendix"))), STATES)
    (both,) = (m for m in diagnosis.mistakes if len(m.mistakes) == 2)
    rules = [finding.rule for finding in findings(diagnosis)]
    assert {mistake.rule_id for mistake in both.mistakes} <= set(rules)
    assert all(mistake.says in sentence(both, diagnosis.pair) for mistake in both.mistakes)
    assert all(mistake.repair in advice(both) for mistake in both.mistakes)
