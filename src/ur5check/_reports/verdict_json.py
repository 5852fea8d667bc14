"""Verdicts and findings as JSON: a part of the report of `ur5check validate`."""

from __future__ import annotations

from typing import Literal

import msgspec

from .._finding import Finding
from .._validation.configuration import Sorted
from .._validation.judgement import Judgement
from .._validation.verdict import PairVerdict, Verdict, VerdictSet
from .json_report import json_line
from .json_values import Number

__all__ = [
    "Agreement",
    "FileVerdict",
    "FindingValue",
    "agreement_value",
    "file_verdict",
    "finding_value",
    "json_lines",
]


class PlaceValue(msgspec.Struct, frozen=True, kw_only=True):
    """Where something is written; line and column from 1, null where unknown."""

    file: str
    line: int | None
    column: int | None
    element: str


class FindingValue(msgspec.Struct, frozen=True, kw_only=True):
    """One thing that is wrong (docs/rules.md)."""

    rule: str
    severity: Literal["error", "warning", "note"]
    subject: str
    message: str
    places: list[PlaceValue]
    value: Number | str | None
    bound: Number | str | None
    unit: str
    consequence: str
    fix: str
    effect: Number | None


class AcceptedFinding(msgspec.Struct, frozen=True, kw_only=True):
    """A finding that the project accepts."""

    finding: FindingValue
    reason: str


class StaleAcceptance(msgspec.Struct, frozen=True, kw_only=True):
    """An acceptance that covers no finding."""

    rule: str
    subject: str
    reason: str


class RobotValue(msgspec.Struct, frozen=True, kw_only=True):
    """What the file describes; mass of all links [kg]."""

    name: str
    links: int
    moving_joints: int
    mass: Number


class ArmValue(msgspec.Struct, frozen=True, kw_only=True):
    """The chain that was taken for the arm."""

    base: str
    tip: str
    joints: list[str]


class FileVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """The verdict on one file.

    engines: whose import of it was audited;  known: findings that the baseline holds
    """

    model: str
    file: str
    passed: bool
    robot: RobotValue | None
    arm: ArmValue | None
    arm_note: str | None
    laws_hold: bool | None
    laws_note: str | None
    engines: list[str]
    findings: list[FindingValue]
    accepted: list[AcceptedFinding]
    known: list[FindingValue]
    stale: list[StaleAcceptance]


class Agreement(msgspec.Struct, frozen=True, kw_only=True):
    """Whether two models need the same torques."""

    label: str
    passed: bool
    findings: list[FindingValue]
    accepted: list[AcceptedFinding]
    stale: list[StaleAcceptance]


def file_verdict(v: Verdict) -> FileVerdict:
    """The verdict on one file."""
    j, s = v.judgement, v.findings
    return FileVerdict(
        model=j.model,
        file=j.file,
        passed=v.passed,
        robot=_robot(j),
        arm=_arm(j),
        arm_note=j.arm_note or None,
        laws_hold=None if j.laws is None else j.laws_hold,
        laws_note=j.laws_note or None,
        engines=list(j.engines),
        findings=[finding_value(finding) for finding in s.open],
        accepted=_accepted(s),
        known=[finding_value(finding) for finding in s.known],
        stale=_stale(s),
    )


def _robot(j: Judgement) -> RobotValue | None:
    if j.robot is None:
        return None
    moving = sum(joint.moves for joint in j.robot.joints)
    return RobotValue(
        name=j.robot.name, links=len(j.robot.links), moving_joints=moving, mass=j.robot.mass
    )


def _arm(j: Judgement) -> ArmValue | None:
    if j.arm is None:
        return None
    source = j.arm.source
    return ArmValue(base=source.base, tip=source.tip, joints=list(j.arm.joint_names))


def json_lines(verdicts: VerdictSet) -> str:
    """The verdict on each file as one line of JSON, then the agreement of each pair."""
    lines = [json_line(file_verdict(v)) for v in verdicts.models]
    return "".join([*lines, *(json_line(agreement_value(pair)) for pair in verdicts.pairs)])


def agreement_value(pair: PairVerdict) -> Agreement:
    """Whether two models agree."""
    s = pair.findings
    return Agreement(
        label=pair.label,
        passed=pair.passed,
        findings=[finding_value(finding) for finding in s.open],
        accepted=_accepted(s),
        stale=_stale(s),
    )


def _accepted(s: Sorted) -> list[AcceptedFinding]:
    return [AcceptedFinding(finding=finding_value(f), reason=a.reason) for f, a in s.accepted]


def _stale(s: Sorted) -> list[StaleAcceptance]:
    return [StaleAcceptance(rule=a.rule, subject=a.subject, reason=a.reason) for a in s.stale]


def finding_value(f: Finding) -> FindingValue:
    """A finding's fields."""
    return FindingValue(
        rule=f.rule,
        severity=f.severity,
        subject=f.subject,
        message=f.message,
        places=[
            PlaceValue(file=p.file, line=p.line or None, column=p.column or None, element=p.element)
            for p in f.places
        ],
        value=f.value,
        bound=f.bound,
        unit=f.unit,
        consequence=f.consequence,
        fix=f.fix,
        effect=f.effect,
    )
