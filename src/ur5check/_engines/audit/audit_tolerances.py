"""Rounding between two readings of the same digits: all tolerances of the audit, in one place.

Engine and recursion read the same decimal text, so that the doubles they start from are equal.  An
engine then transforms each number through up to n joints to the base frame, and the audit
transforms it back: some 32 roundings per joint each way, of the largest quantity involved.
"""

from __future__ import annotations

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array

__all__ = [
    "parameter_rounding",
    "pose_rounding",
    "same_number",
    "tensor_rounding",
    "torque_rounding",
]

_PER_JOINT = 64 * float(np.finfo(np.float64).eps)


def reach(arm: SerialArm) -> float:
    """Sum of the link lengths, which no joint is farther from the base than [m]; at least 1 m."""
    lengths = [
        np.linalg.norm(T.p) for T in (arm.base, *(link.link_tip_frame for link in arm.links))
    ]
    return max(1.0, float(np.sum(lengths)))


def parameter_rounding(arm: SerialArm, *parameters: Array) -> Array:
    """Of the π of a body that the arm carries, shape (10,): m, m L, and m L² or I.

    parameters : one reading of it or several; the largest counts
    """
    lever = reach(arm)
    mass = max(pi[0] for pi in parameters)
    moment = max(np.abs(pi[4:]).max() for pi in parameters) + mass * lever**2
    return np.asarray(_PER_JOINT * arm.n * np.repeat([mass, mass * lever, moment], [1, 3, 6]))


def tensor_rounding(tensor: Array) -> float:
    """Of a tensor rotated there and back [kg m²]."""
    return _PER_JOINT * float(np.abs(tensor).max())


def pose_rounding(arm: SerialArm) -> float:
    """Of an axis or of the tool's pose at q = 0 [m]."""
    return _PER_JOINT * arm.n * reach(arm)


def torque_rounding(arm: SerialArm, tau: Array) -> float:
    """Of two torques of this size [N m]."""
    return _PER_JOINT * arm.n * float(np.abs(tau).max())


def same_number(a: float | None, b: float | None) -> bool:
    """Of a limit or a damping, at most converted to other units and back.  None: there is none."""
    if a is None or b is None:
        return a is b
    return abs(a - b) <= _PER_JOINT * max(abs(a), abs(b))
