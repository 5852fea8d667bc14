"""A rule as a check that passes, fails, or fails as expected."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NoReturn

import pytest

from .._finding import SEVERITIES, Finding
from .._validation.configuration import Sorted
from .._validation.law import Outcome
from .._validation.verdict import PairVerdict, Verdict

__all__ = ["ModelFaultError", "check_agreement", "check_laws", "check_rule", "findings_in_words"]


class ModelFaultError(AssertionError):
    """A model fails a rule; its text is the report."""


def check_rule(verdict: Verdict, rule: str) -> str:
    """Raise ModelFaultError for findings that fail the model, and for an acceptance that is stale.

    A finding that the project accepts is an expected failure (pytest.xfail) with its reason.
    Returns what was found below the fail level.
    """
    found = verdict.findings
    worst = SEVERITIES.index(verdict.fail_level)
    of_rule = [f for f in found.open if f.rule == rule]
    _refuse([f for f in of_rule if SEVERITIES.index(f.severity) <= worst])
    _judge_acceptances(found, rule)
    return findings_in_words(of_rule)


def check_laws(verdict: Verdict) -> None:
    """Raise ModelFaultError for a law of dynamics that fails; skip where none was checked."""
    j = verdict.judgement
    if j.laws is None:
        pytest.skip(j.laws_note or "not computed")
    failed = [o for o in j.laws.outcomes if o.id in j.failed_laws]
    if failed:
        raise ModelFaultError("\n".join(_law(outcome) for outcome in failed))


def check_agreement(pair: PairVerdict) -> None:
    """Raise ModelFaultError where two models need other torques, with their worst state."""
    state = ""
    if pair.comparison is not None:
        torques, states = pair.comparison.difference.torques, pair.comparison.difference.states
        joint = int(torques.maximum.argmax())
        worst = states[int(torques.worst[joint])]
        state = "\n".join(f"  worst {name}: {_numbers(x)}" for name, x in worst.items())
    _refuse(pair.findings.open, state)
    if not pair.passed:
        raise ModelFaultError(f"the difference of {pair.label} is not explained\n{state}")
    _judge_acceptances(pair.findings, "CMP")


def findings_in_words(findings: list[Finding] | tuple[Finding, ...]) -> str:
    """Place, message, value and bound, effect and repair of each."""
    return "\n".join(_finding(f) for f in findings)


def _refuse(findings: list[Finding] | tuple[Finding, ...], more: str = "") -> None:
    if findings:
        raise ModelFaultError("\n".join([findings_in_words(findings), *([more] if more else [])]))


def _judge_acceptances(found: Sorted, rule: str) -> None:
    stale = [a for a in found.stale if a.rule.startswith(rule)]
    if stale:
        text = "\n".join(
            f"{a.rule} {a.subject} is accepted ({a.reason}) but does not occur" for a in stale
        )
        raise ModelFaultError(f"{text}\n  fix: take the acceptance out of the configuration")
    reasons = [a.reason for f, a in found.accepted if f.rule.startswith(rule)]
    if reasons:
        _expected("; ".join(dict.fromkeys(reasons)))


def _expected(reason: str) -> NoReturn:
    pytest.xfail(reason)
    raise AssertionError("unreachable")  # xfail raises; its type does not say so


def _finding(f: Finding) -> str:
    lines = [f"{f.place}: {f.severity} {f.rule}: {f.subject}: {f.message}".removeprefix(": ")]
    if f.value is not None:
        bound = "" if f.bound is None else f", bound {f.bound}"
        lines.append(f"  value: {f.value}{bound} {f.unit}".rstrip())
    parts = {"effect": f.consequence, "fix": f.fix}
    lines += [f"  {title}: {text}" for title, text in parts.items() if text]
    lines += [f"  by way of: {place} {place.element}".rstrip() for place in f.places[1:]]
    return "\n".join(lines)


def _law(o: Outcome) -> str:
    bound = "above" if o.positive else "at most"
    lines = [f"{o.id}: {o.statement} ({o.formula})"]
    lines.append(f"  value: {o.value:.3g} {o.unit}, {bound} {o.tolerance:.3g}")
    state = o.worst_state or {}
    lines += [f"  worst {name}: {_numbers(values)}" for name, values in state.items()]
    return "\n".join(lines)


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{x:.6g}" for x in values)
