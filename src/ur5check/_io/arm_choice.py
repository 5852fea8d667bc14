"""Which chain of a robot is its arm, where no base and no tip are given.

From the root to the last link before gripper fingers.  Of several chains the one that is clearly
longest: on a mobile base with wheels and a head the arm is.  Where none is, all are listed.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from .._robot.robot import Robot, RobotJoint

__all__ = ["ArmChoice", "choose_arm"]

_FINGER_JOINT = re.compile(r"finger|gripper|knuckle|jaw|claw|thumb|pinky|(^|_)hand_", re.IGNORECASE)
_FINGER_LINK = re.compile(r"finger|knuckle|jaw|claw|thumb|pinky", re.IGNORECASE)
#: A hand hangs on an arm of at least so many joints, and its fingers have at most so many: fewer
#: where only their arrangement says that they are fingers, not their names.
_ARM_JOINTS, _FINGER_JOINTS, _NAMED_JOINTS = 3, 5, 8
#: A chain is clearly the arm if it has this many times the joints of the next.
_CLEARLY = 2.0


@dataclass(frozen=True)
class ArmChoice:
    """tip : the last moving link of the chain that was chosen, None where no one is clearly meant
    chains : (last moving link, moving joints) of every chain, the longest first
    fingers : moving joints that were taken for those of a hand, or follow another joint
    """

    tip: str | None
    chains: tuple[tuple[str, int], ...]
    fingers: tuple[str, ...]


def choose_arm(robot: Robot, base: str | None = None) -> ArmChoice:
    """The arm that begins at `base`, or at the root that most moving joints hang on."""
    root = base or max(robot.roots, key=lambda name: len(list(robot.down(name))), default="")
    if not root:
        return ArmChoice(None, (), ())
    below, depth = _moving_tree(robot, root)
    fingers = _fingers(robot, below, depth)
    kept = {name: joints for name, joints in below.items() if name not in fingers}
    ends = [
        name for name in kept if depth[name] > 0 and not any(child in kept for child in below[name])
    ]
    chains = tuple(sorted(((e, depth[e]) for e in ends), key=lambda chain: -chain[1]))
    named = tuple(robot.above[name].name for name in below if name in fingers)
    if not chains:
        return ArmChoice(None, (), named)
    clear = len(chains) == 1 or chains[0][1] >= _CLEARLY * chains[1][1]
    return ArmChoice(chains[0][0] if clear else None, chains, named)


def _moving_tree(robot: Robot, root: str) -> tuple[dict[str, list[str]], dict[str, int]]:
    """For the root and every link right after a moving joint: such links next below it, and how
    many moving joints lie between it and the root."""
    top, depth = {root: root}, {root: 0}
    below: dict[str, list[str]] = {root: []}
    for name in robot.down(root):
        for joint in robot.below[name]:
            if joint.moves:
                top[joint.child] = joint.child
                below[top[name]].append(joint.child)
                below[joint.child] = []
                depth[joint.child] = depth[top[name]] + 1
            else:
                top[joint.child] = top[name]
    return below, depth


def _fingers(robot: Robot, below: Mapping[str, list[str]], depth: Mapping[str, int]) -> set[str]:
    """Links of hands: named so, opposed on one palm, or driven by another joint's motion."""
    found: set[str] = set()

    def subtree(name: str) -> list[str]:
        return [name, *(other for child in below[name] for other in subtree(child))]

    def height(name: str) -> int:
        return 1 + max((height(child) for child in below[name]), default=0)

    for name, children in below.items():
        # Opposed fingers: two or more short branches at the end of an arm.
        if depth[name] >= _ARM_JOINTS and len(children) > 1:
            short = [child for child in children if height(child) <= _FINGER_JOINTS]
            if len(short) == len(children) and (
                len(children) > 2 or all(height(c) <= 2 for c in children)
            ):
                found.update(other for child in children for other in subtree(child))
        for child in children:
            joint = robot.above[child]
            named = depth[child] > _ARM_JOINTS and _is_finger(joint)
            if named and height(child) <= _NAMED_JOINTS:
                found.update(subtree(child))
    return found


def _is_finger(joint: RobotJoint) -> bool:
    named = _FINGER_JOINT.search(joint.name) or _FINGER_LINK.search(joint.child)
    return joint.mimic is not None or bool(named)
