"""A verdict rule by rule: what was asked of a file, and what each rule answered."""

from __future__ import annotations

from dataclasses import dataclass

from .._finding import SEVERITIES, Finding
from .._io.formats import format_by_suffix
from .._rules.registry import all_rules
from .._rules.rule import Rule
from .configuration import Acceptance, Configuration
from .verdict import Verdict

__all__ = ["RuleOutcome", "rule_outcomes", "rules_asked"]

#: Families about two models or about recordings: no single file is judged by them.
_OF_OTHER_SUBJECTS = ("CMP", "LOG")


@dataclass(frozen=True)
class RuleOutcome:
    """What one rule found in one file.

    failing : findings that fail the file;  open : all that count
    accepted : with their acceptances;  known : that the baseline holds
    """

    rule: Rule
    failing: tuple[Finding, ...]
    open: tuple[Finding, ...]
    accepted: tuple[tuple[Finding, Acceptance], ...]
    known: tuple[Finding, ...]


def rules_asked(file: str, configuration: Configuration, *, engines: bool = False) -> list[Rule]:
    """The rules that are asked of a file, by ids.

    engines : whether engines are asked what they import
    """
    form = format_by_suffix(file)
    others = list(_OF_OTHER_SUBJECTS)
    if not engines:
        others.append("ENG")
    if form is not None and form.kind != "xacro":
        others.append("XAC")
    return [
        rule
        for rule in all_rules().values()
        if rule.family not in others and configuration.asks(rule.id, file)
    ]


def rule_outcomes(verdict: Verdict, configuration: Configuration) -> list[RuleOutcome]:
    """One outcome for each rule that was asked, and for each that found something."""
    found = verdict.findings
    j = verdict.judgement
    rules = {r.id: r for r in rules_asked(j.file, configuration, engines=bool(j.engines))}
    rules |= {finding.rule: all_rules()[finding.rule] for finding in found.all}
    worst = SEVERITIES.index(verdict.fail_level)
    outcomes = []
    for rule in sorted(rules.values(), key=lambda rule: rule.id):
        of_rule = tuple(f for f in found.open if f.rule == rule.id)
        outcomes.append(
            RuleOutcome(
                rule,
                tuple(f for f in of_rule if SEVERITIES.index(f.severity) <= worst),
                of_rule,
                tuple((f, a) for f, a in found.accepted if f.rule == rule.id),
                tuple(f for f in found.known if f.rule == rule.id),
            )
        )
    return outcomes
