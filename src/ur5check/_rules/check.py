"""Every rule applied to one robot."""

from __future__ import annotations

from collections.abc import Iterable

from .._finding import Finding, worst_first
from .registry import all_rules
from .rule_subject import RuleSubject

__all__ = ["check_rules"]


def check_rules(subject: RuleSubject, found_before: Iterable[Finding] = ()) -> list[Finding]:
    """What the rules find in a robot, with what reading it found, the worst first."""
    findings = list(found_before)
    for check in dict.fromkeys(rule.check for rule in all_rules().values()):
        if check is not None:
            findings += check(subject)
    return worst_first(findings)
