"""Rounding between two readings of the same digits: all tolerances of the audit, in one place.

Engine and recursion read the same decimal text, so that the doubles they start from are equal.  An
engine then transforms each number through up to n joints, the depth of the tree, to the base
frame, and the audit transforms it back: some 32 roundings per joint each way, of the largest
quantity involved.
"""

from __future__ import annotations

import numpy as np

from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.transforms import Array

__all__ = [
    "parameter_rounding",
    "pose_rounding",
    "same_number",
    "tensor_rounding",
    "torque_rounding",
]

_PER_JOINT = 64 * float(np.finfo(np.float64).eps)


def reach(arm: ArmOrTree) -> float:
    """Sum of the link lengths along the longest branch, which no joint is farther from the base
    than [m]; at least 1 m."""
    lengths = {-1: 0.0}
    for i, each in enumerate(tree_links(arm)):
        steps = (each.origin.p, each.link.link_tip_frame.p)
        lengths[i] = lengths[each.parent] + float(sum(np.linalg.norm(step) for step in steps))
    return max(1.0, *lengths.values())


def _depth(arm: ArmOrTree) -> int:
    """The most joints between the base and a link: n of an arm."""
    depth = {-1: 0}
    for i, each in enumerate(tree_links(arm)):
        depth[i] = depth[each.parent] + 1
    return max(depth.values())


def parameter_rounding(arm: ArmOrTree, *parameters: Array) -> Array:
    """Of the π of a body that the arm carries, shape (10,): m, m L, and m L² or I.

    parameters : one reading of it or several; the largest counts
    """
    lever = reach(arm)
    mass = max(abs(pi[0]) for pi in parameters)
    moment = max(np.abs(pi[4:]).max() for pi in parameters) + mass * lever**2
    return np.asarray(_PER_JOINT * _depth(arm) * np.repeat([mass, mass * lever, moment], [1, 3, 6]))


def tensor_rounding(tensor: Array) -> float:
    """Of a tensor rotated there and back [kg m²]."""
    return _PER_JOINT * float(np.abs(tensor).max())


def pose_rounding(arm: ArmOrTree) -> float:
    """Of an axis or of the tool's pose at q = 0 [m]."""
    return _PER_JOINT * _depth(arm) * reach(arm)


def torque_rounding(arm: ArmOrTree, tau: Array) -> float:
    """Of two torques of this size, each a sum over the links that its joint carries [N m].

    The audit carries every body to the base frame and back, which rounds its first moment by m L:
    gravity loads that too, on a robot far from its base.
    """
    links = tree_links(arm)
    mass = sum(abs(each.link.inertia.mass) for each in links)
    weight = mass * float(np.linalg.norm(arm.gravity)) * reach(arm)
    return _PER_JOINT * len(links) * max(float(np.abs(tau).max()), weight)


def same_number(a: float | None, b: float | None) -> bool:
    """Of a limit or a damping, at most converted to other units and back.  None: there is none."""
    if a is None or b is None:
        return a is b
    return abs(a - b) <= _PER_JOINT * max(abs(a), abs(b))
