"""Directions, turns and lines: the small geometry of joint axes."""

from __future__ import annotations

import numpy as np

from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array, Transform

__all__ = [
    "SAME_ANGLE",
    "SAME_LENGTH",
    "across",
    "angle_about",
    "joint_starts",
    "signed_angle",
    "smallest_rotation",
    "tool_angle",
    "tool_pose",
]

#: Two axes are one line if they are closer than this.  No data sheet, table or URDF that people
#: write by hand carries more digits than the micrometre and the microradian.
SAME_LENGTH = 1e-6  # [m]
SAME_ANGLE = 1e-6  # [rad]


def joint_starts(arm: SerialArm) -> list[Transform]:
    """The frame that each joint starts from, at q = 0, in the base frame."""
    starts, T = [], arm.base
    for link in arm.links:
        starts.append(T)
        T = T @ link.link_tip_frame
    return starts


def tool_pose(arm: SerialArm) -> Transform:
    """Pose of the tool at q = 0, in the base frame."""
    T = arm.base
    for link in arm.links:
        T = T @ link.link_tip_frame
    return T


def across(v: Array, axis: Array) -> Array:
    """The part of v that is perpendicular to the unit vector `axis`."""
    return v - axis * (axis @ v)


def angle_about(axis: Array, start: Array, end: Array) -> float:
    """The turn about `axis` that takes the direction `start` to `end`, both perpendicular to it."""
    return float(np.arctan2(axis @ np.cross(start, end), start @ end))


def signed_angle(R: Array, axis: Array) -> float:
    """The angle of a rotation about `axis`."""
    vector = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return float(np.arctan2(axis @ vector, np.trace(R) - 1.0))


def smallest_rotation(start: Array, end: Array) -> Transform:
    """The smallest rotation that takes one unit vector to another."""
    normal = np.cross(start, end)
    sine, cosine = float(np.linalg.norm(normal)), float(start @ end)
    if sine > 1e-12:
        return Transform.rotation(normal / sine, float(np.arctan2(sine, cosine)))
    if cosine > 0.0:
        return Transform.identity()
    helper = np.eye(3)[int(np.abs(start).argmin())]
    normal = np.cross(start, helper)
    return Transform.rotation(normal / np.linalg.norm(normal), float(np.pi))


def tool_angle(axis: Array, tool_b: Transform, tool_a: Transform) -> float:
    """The turn about `axis` (base frame) that brings tool b's orientation closest to tool a's.

    Maximises tr(R_aᵀ Rot(axis, φ) R_b) = const + A cos φ + B sin φ.
    """
    W = tool_b.R @ tool_a.R.T
    cosine = np.trace(W) - axis @ W @ axis
    sine = -(axis @ np.array([W[2, 1] - W[1, 2], W[0, 2] - W[2, 0], W[1, 0] - W[0, 1]]))
    if np.hypot(cosine, sine) < 1e-9:
        return 0.0
    return float(np.arctan2(sine, cosine))
