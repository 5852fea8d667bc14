"""The arm of a robot that was read, or the first error of the file that concerns this arm.

A fault elsewhere does not keep an arm from being loaded: a camera's tensor, the limits of a wheel.
What concerns an arm: the tree as a whole, its moving joints, the bodies that they carry, and where
other joints place these bodies.
"""

from __future__ import annotations

import re
from ast import literal_eval
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from .._errors import ModelError
from .._finding import Finding
from .._robot.robot import Robot, RobotJoint, RobotLink
from .._robot.serial_arm import SerialArm
from .._rules import inertia_rules, joint_rules
from .._rules.rule_subject import RuleSubject
from .robot_arm import RobotDescription, arm_along
from .urdf.urdf_chain import Chain

__all__ = ["judged_bodies", "load_arm"]

#: Rules that a readable arm may break: no such robot can be built, but its torques can be computed.
_IMPOSSIBLE = {"INE101", "INE102", "INE103", "JNT104", "JNT105", "JNT112"}
#: Rules whose breach leaves a joint without a meaning that all readers share.
_MEANINGLESS = {"JNT101", "JNT111", "JNT114"}
#: Findings about the tree of links: which robot the file describes is open.
_TREE = {"TRE101", "TRE103", "TRE104", "TRE105"}
#: Parts of a description that no torque depends on, of a link and of a joint that stands still.
_SHAPES, _UNUSED = ("visual", "collision"), ("limit", "dynamics")

_SUBJECT = re.compile(r"""(link|joint) ('(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*")(?: ([^ /]*).*)?\Z""")


def load_arm(
    robot: Robot | None,
    findings: tuple[Finding, ...],
    *,
    base: str | None = None,
    tip: str | None = None,
    strict: bool = True,
) -> SerialArm:
    """The arm between two links of a robot.

    robot, findings : what reading the file gave
    base, tip : as for `arm_of_robot`
    strict : whether a body or joint that cannot exist is an error; otherwise these findings are the
        arm's `source.faults`, as long as every number of it can be read

    Raises ModelError for the first error that concerns the arm, or for what `arm_of_robot` refuses.
    """
    errors = [finding for finding in findings if finding.severity == "error"]
    if robot is None and not errors:
        raise ModelError("describes no robot", fix="give a robot's description")
    if robot is None:
        raise ModelError.of(errors[0])
    for finding in errors:
        if _leaves_tree_open(finding, robot):
            raise ModelError.of(finding)
    description = RobotDescription(robot)
    chain = description.chain(base, tip)
    concerning = tuple(_concerning(errors, description, chain))
    concerning += tuple(_concerning(_found_by_rules(robot), description, chain))
    for finding in concerning:
        if strict or finding.rule not in _IMPOSSIBLE:
            raise ModelError.of(finding)
    arm = arm_along(description, chain, strict=strict)
    return replace(arm, source=replace(arm.source, faults=concerning))


def judged_bodies(links: Sequence[RobotLink], joints: Sequence[RobotJoint] = ()) -> list[Finding]:
    """What is wrong with the bodies and axes alone, of a file whose tree could not be read."""
    return _found_by_rules(Robot("", tuple(links), tuple(joints), "", "", np.zeros(3)))


def _found_by_rules(robot: Robot) -> list[Finding]:
    """Errors that these rules find, in the order of the file."""
    subject = RuleSubject(robot)
    checked = _IMPOSSIBLE | _MEANINGLESS
    rules = (*inertia_rules.RULES, *joint_rules.RULES)
    checks = dict.fromkeys(rule.check for rule in rules if rule.check is not None)
    found = [finding for check in checks for finding in check(subject)]
    errors = (f for f in found if f.severity == "error" and f.rule in checked)
    return sorted(errors, key=lambda finding: finding.place)


def _leaves_tree_open(finding: Finding, robot: Robot) -> bool:
    """Whether it is about the tree, or about an element that was left out of the robot."""
    tag, name, _ = _named(finding)
    known = {"link": robot.link, "joint": robot.joint}.get(tag, {})
    return finding.rule in _TREE or name not in known


def _concerning(
    findings: Iterable[Finding], description: RobotDescription, chain: Chain
) -> Iterator[Finding]:
    """Findings about the arm's own joints, the links they carry, and what places them."""
    moving = {edge.joint for edge in chain.moving}
    carried = {edge.child for edge in chain.moving}
    placing = {edge.joint for edge in (*chain.climbed, *chain.descended)}
    placing |= {joint.name for joint in description.robot.up(chain.base)}
    for edge in chain.moving:
        for fixed in description.tree.rigid_group(edge.child, chain):
            carried.add(fixed.child)
            placing.add(fixed.joint)
    for finding in findings:
        tag, name, part = _named(finding)
        if tag == "link":
            concerns = name in carried and part not in _SHAPES
        elif name in moving:
            concerns = True
        else:
            needed = part not in _UNUSED and finding.rule not in _IMPOSSIBLE
            concerns = needed and name in placing
        if concerns:
            yield finding


def _named(finding: Finding) -> tuple[str, str, str]:
    """Tag, name and part of its subject: "link 'forearm' inertial/mass"; "" for what it lacks."""
    found = _SUBJECT.match(finding.subject)
    return (found[1], literal_eval(found[2]), found[3] or "") if found else ("", "", "")
