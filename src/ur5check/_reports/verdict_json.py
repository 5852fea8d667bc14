"""Verdicts and findings as JSON: a part of the report of `ur5check validate`."""

from __future__ import annotations

import msgspec

from .._validation.configuration import Sorted
from .._validation.judgement import Judgement
from .._validation.verdict import PairVerdict, Verdict, VerdictSet
from .finding_json import FindingValue, finding_value
from .json_report import json_line
from .json_values import Number

__all__ = [
    "Agreement",
    "FileVerdict",
    "agreement_value",
    "file_verdict",
    "json_lines",
]


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
