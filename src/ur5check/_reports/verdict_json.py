"""`validate` as plain values for JSON: the verdict on every file, then the computation."""

from __future__ import annotations

from collections.abc import Sequence

from .._finding import Finding
from .._validation.configuration import Configuration, Sorted
from .._validation.validation import Validation
from .._validation.verdict import PairVerdict, Verdict
from .diff_json import validate_json
from .json_head import json_head
from .json_values import Report, strict

__all__ = ["finding_value", "verdict_json"]


def verdict_json(
    results: Sequence[Verdict],
    pair: PairVerdict | None,
    laws: Validation | None,
    configuration: Configuration,
    *,
    command: str = "",
) -> Report:
    """The report of `ur5check validate`.  laws : of the arms that were computed"""
    first = results[0].judgement
    head = json_head("verdict", (), command, first.seed, first.samples)
    inputs = [
        one for v in results if v.judgement.robot is not None for one in v.judgement.robot.inputs
    ]
    head["inputs"] = [{"name": n, "sha256": digest} for n, digest in dict.fromkeys(inputs)]
    return strict(
        {
            **head,
            "passed": all(v.passed for v in results) and (pair is None or pair.passed),
            "fail_level": results[0].fail_level,
            "configuration": configuration.path or None,
            "files": [_file(v) for v in results],
            "pair": None if pair is None else _pair(pair),
            "computation": None if laws is None else validate_json(laws, command=command),
        }
    )


def _file(v: Verdict) -> Report:
    j = v.judgement
    arm = j.arm
    return {
        "model": j.model,
        "file": j.file,
        "passed": v.passed,
        "robot": None
        if j.robot is None
        else {
            "name": j.robot.name,
            "links": len(j.robot.links),
            "moving_joints": sum(joint.moves for joint in j.robot.joints),
            "mass": j.robot.mass,
        },
        "arm": None
        if arm is None
        else {"base": arm.source.base, "tip": arm.source.tip, "joints": list(arm.joint_names)},
        "arm_note": j.arm_note or None,
        "laws_hold": None if j.laws is None else j.laws_hold,
        "laws_note": j.laws_note or None,
        **_sorted(v.findings),
    }


def _pair(pair: PairVerdict) -> Report:
    return {"label": pair.label, "passed": pair.passed, **_sorted(pair.findings)}


def _sorted(s: Sorted) -> Report:
    return {
        "findings": [finding_value(finding) for finding in s.open],
        "accepted": [{**finding_value(f), "reason": a.reason} for f, a in s.accepted],
        "stale": [{"rule": a.rule, "subject": a.subject, "reason": a.reason} for a in s.stale],
    }


def finding_value(f: Finding) -> Report:
    """A finding's fields."""
    return {
        "rule": f.rule,
        "severity": f.severity,
        "subject": f.subject,
        "message": f.message,
        "places": [
            {"file": p.file, "line": p.line or None, "column": p.column or None} for p in f.places
        ],
        "value": f.value,
        "bound": f.bound,
        "unit": f.unit,
        "consequence": f.consequence,
        "fix": f.fix,
        "effect": f.effect,
    }
