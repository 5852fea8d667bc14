"""The arm of a robot, for readers that stop at the first error: what `load` returns."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from .._errors import ModelError
from .._finding import Finding
from .._robot.robot import Robot, RobotJoint, RobotLink
from .._robot.serial_arm import SerialArm
from .._rules.registry import rule_of
from .._rules.rule_subject import RuleSubject
from .robot_arm import arm_of_robot

__all__ = ["judged_bodies", "strict_arm"]

#: Rules about numbers that no arm can have: bodies, axes, limits, losses.
_IMPOSSIBLE = ("INE101", "INE102", "INE103", "JNT101", "JNT104", "JNT105", "JNT112")


def strict_arm(
    robot: Robot | None,
    findings: Iterable[Finding],
    *,
    base: str | None = None,
    tip: str | None = None,
) -> SerialArm:
    """The arm between two links.  Raises ModelError for the first error that reading found, and for
    numbers of the arm that no arm can have."""
    for finding in findings:
        if finding.severity == "error":
            raise ModelError.of(finding)
    if robot is None:
        raise ModelError("describes no robot", fix="give a robot's description")
    try:
        arm = arm_of_robot(robot, base=base, tip=tip)
    except ModelError as error:
        for finding in _impossible(robot):  # a rule says more of the same place
            if finding.severity == "error" and finding.place.line == error.line:
                raise ModelError.of(finding) from None
        raise
    carried = [name for link in arm.links[:1] for name in robot.down(link.name)]
    parts = {f"link {name!r}" for name in carried} | {f"joint {j.name!r}" for j in arm.joints}
    for finding in _impossible(robot):
        if finding.severity == "error" and finding.subject in parts:
            raise ModelError.of(finding)
    return arm


def judged_bodies(links: Sequence[RobotLink], joints: Sequence[RobotJoint] = ()) -> list[Finding]:
    """What is wrong with the bodies and axes alone, of a file whose tree could not be read."""
    robot = Robot("", tuple(links), tuple(joints), "", "", np.zeros(3))
    return _impossible(robot)


def _impossible(robot: Robot) -> list[Finding]:
    subject = RuleSubject(robot)
    checks = dict.fromkeys(rule_of(rule).check for rule in _IMPOSSIBLE)
    found = [finding for check in checks if check is not None for finding in check(subject)]
    return [finding for finding in found if finding.rule in _IMPOSSIBLE]
