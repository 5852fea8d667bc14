"""Expected torque at rest: the moment of the weights about the joint, without recursion.

A motor at rest holds the weights of all that it carries.  Link k weighs m_k g and acts at its
centre of mass c_k, so about the axis z_i through p_i

    τ_i = −z_i · Σ_{k ≥ i} (c_k − p_i) × m_k g.

This is the law of the lever, independent of the paper's eqs 9 to 15, and so a test of them.
"""

from __future__ import annotations

import numpy as np

from .._dynamics.kinematics import link_frames
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["axes_in_space", "holding_torque", "nothing_to_hold"]

#: Error of a quarter turn written as 1.570796327: up to half a unit of its last digit.
_ANGLE_DIGITS = 5e-10


def holding_torque(arm: SerialArm, q: Array) -> Array:
    """Torque that holds an arm of revolute joints at rest, shape (N, n) [N m].

    q : shape (N, n) [rad]

    References: Siciliano et al., Robotics (2009), ch. 3 (statics).
    """
    centres = _centres(arm, q)
    points, axes = axes_in_space(arm, q)
    weights = np.outer([link.inertia.mass for link in arm.links], arm.gravity)
    tau = np.empty((len(q), arm.n))
    for i in range(arm.n):
        moment = np.cross(centres[:, i:] - points[:, i, None], weights[i:]).sum(axis=1)
        tau[:, i] = -(axes[:, i] * moment).sum(axis=-1)
    return tau


def axes_in_space(arm: SerialArm, q: Array) -> tuple[Array, Array]:
    """A point on every joint's axis, and its direction, in the base frame; each (N, n, 3) [m], [1].

    q : shape (N, n) [rad]
    """
    base = np.broadcast_to(arm.base.matrix(), (len(q), 1, 4, 4))
    starts = np.concatenate([base, link_frames(arm, q)[:, :-1]], axis=1)
    axes = [starts[:, i, :3, :3] @ joint.axis for i, joint in enumerate(arm.joints)]
    return starts[..., :3, 3], np.stack(axes, axis=1)


def nothing_to_hold(arm: SerialArm, q: Array, joint: int) -> str:
    """Why a joint, from 1, bears no weight at these states; empty if no reason is found.

    q : shape (N, n) [rad]
    """
    points, axes = axes_in_space(arm, q)
    axis = axes[:, joint - 1]
    if np.abs(np.cross(axis, arm.gravity)).max() <= _ANGLE_DIGITS * np.linalg.norm(arm.gravity):
        return "gravity lies along the axis"
    masses = np.array([link.inertia.mass for link in arm.links[joint - 1 :]])
    centres = _centres(arm, q)[:, joint - 1 :]
    centre = (centres * masses[:, None]).sum(axis=1) / masses.sum()
    lever = np.linalg.norm(np.cross(centre - points[:, joint - 1], axis), axis=-1).max()
    if lever <= _ANGLE_DIGITS:
        return f"the centre of mass of all that joint {joint} carries lies on its axis"
    return ""


def _centres(arm: SerialArm, q: Array) -> Array:
    """Every link's centre of mass in the base frame, shape (N, n, 3) [m]."""
    T = link_frames(arm, q)
    centres = [T[:, k, :3, :3] @ x.inertia.com + T[:, k, :3, 3] for k, x in enumerate(arm.links)]
    return np.stack(centres, axis=1)
