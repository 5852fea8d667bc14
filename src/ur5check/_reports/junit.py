"""Findings as JUnit XML: a test suite a file, a test case a rule that was asked of it.

A finding below the fail level stands in the output of a test case that passes, an accepted one is
skipped with its reason, and so is one of the baseline.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from .._finding import Finding
from .._validation.configuration import Configuration, Sorted
from .._validation.fingerprints import path_from
from .._validation.rule_outcomes import RuleOutcome, rule_outcomes
from .._validation.verdict import PairVerdict, Verdict, VerdictSet
from .verdict_summary import failed_laws
from .wording import where

__all__ = ["render_junit"]

#: What XML 1.0 has no place for, not even escaped.
_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def render_junit(verdicts: VerdictSet, configuration: Configuration) -> str:
    """The verdicts as JUnit XML."""
    from lxml import etree

    root = etree.Element("testsuites", name="ur5check")
    laws = dict(failed_laws(verdicts))
    for verdict in verdicts.models:
        _model_suite(root, verdict, configuration, laws.get(verdict.judgement.file))
    for pair in verdicts.pairs:
        _pair_suite(root, pair)
    for parent in (*root, root):
        _count(parent)
    text: bytes = etree.tostring(root, pretty_print=True, xml_declaration=True, encoding="utf-8")
    return text.decode()


def _model_suite(root: Any, v: Verdict, configuration: Configuration, law: str | None) -> None:
    file = path_from(None, v.judgement.file)
    suite = _child(root, "testsuite", name=file)
    for outcome in rule_outcomes(v, configuration):
        rule = outcome.rule
        case = _case(suite, f"{rule.id} {rule.name}", f"{file}.{rule.family}", file)
        _answer(case, outcome, v.judgement.file)
    _stale(suite, v.findings, file)
    case = _case(suite, "laws of dynamics", f"{file}.computation", file)
    if law is not None:
        _child(case, "failure", law, message=law, type="law")
    elif v.judgement.laws is None:
        _child(case, "skipped", message=v.judgement.laws_note or "not computed")


def _answer(case: Any, outcome: RuleOutcome, file: str) -> None:
    excused = [(f, a.reason) for f, a in outcome.accepted]
    excused += [(f, "in the baseline") for f in outcome.known]
    if outcome.failing:
        _failure(case, outcome.failing, file)
    elif excused:
        reasons = "; ".join(dict.fromkeys(f"{f.subject}: {reason}" for f, reason in excused))
        _child(case, "skipped", message=reasons)
    passing = [f for f in outcome.open if f not in outcome.failing]
    if passing:
        _child(case, "system-out", "\n".join(_said(f, file) for f in passing))


def _pair_suite(root: Any, pair: PairVerdict) -> None:
    file = path_from(None, pair.file)
    suite = _child(root, "testsuite", name=pair.label)
    case = _case(suite, "agreement", f"{file}.agreement", file)
    if pair.findings.open:
        _failure(case, pair.findings.open, pair.file)
    elif not pair.passed:
        text = "the difference of the torques is not explained"
        _child(case, "failure", text, message=text, type="CMP")
    elif pair.findings.accepted:
        reasons = "; ".join(acceptance.reason for _, acceptance in pair.findings.accepted)
        _child(case, "skipped", message=reasons)
    _stale(suite, pair.findings, file)


def _stale(suite: Any, found: Sorted, file: str) -> None:
    """An acceptance that covers nothing is said, and does not fail, as in the text report."""
    for acceptance in found.stale:
        name = f"{acceptance.rule} {acceptance.subject}".strip()
        case = _case(suite, f"accepted: {name}", f"{file}.accepted", file)
        _child(case, "system-out", f"{name} is accepted but does not occur")


def _failure(case: Any, findings: Iterable[Finding], file: str) -> None:
    """One failure of a test case, since not every reader takes several."""
    findings = tuple(findings)
    message = "; ".join(f"{f.subject}: {f.message}" for f in findings)
    text = "\n".join(_said(f, file) for f in findings)
    _child(case, "failure", text, message=message, type=findings[0].rule)


def _said(f: Finding, file: str) -> str:
    lines = [f"{where(f.place, file)}: {f.severity} {f.rule}: {f.subject}: {f.message}"]
    lines += [f"  {title}: {text}" for title, text in (("effect", f.consequence), ("fix", f.fix))]
    return "\n".join(lines).removeprefix(": ")


def _case(suite: Any, name: str, classname: str, file: str) -> Any:
    return _child(suite, "testcase", name=name, classname=classname, file=file)


def _child(parent: Any, tag: str, text: str = "", **attributes: str) -> Any:
    from lxml import etree

    clean = {name: _NO_XML.sub("�", value) for name, value in attributes.items()}
    element = etree.SubElement(parent, tag, clean)
    if text:
        element.text = _NO_XML.sub("�", text)
    return element


def _count(element: Any) -> None:
    for name, tag in (("tests", "testcase"), ("failures", "failure"), ("skipped", "skipped")):
        element.set(name, str(sum(1 for _ in element.iter(tag))))
    element.set("errors", "0")
