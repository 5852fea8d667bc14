"""What a torque should be: the moment of the weights about the joint, without any recursion.

A motor at rest holds the weights of all that it carries.  Link k weighs m_k g and acts at its
centre of mass c_k, so about the axis z_i through p_i

    τ_i = −z_i · Σ_{k ≥ i} (c_k − p_i) × m_k g.

This is the lever rule.  It shares no line with eqs 9 to 15, and so can say that they are wrong.
"""

from __future__ import annotations

import numpy as np

from ..arm.serial_arm import SerialArm
from ..arm.transforms import Array
from ..dynamics.kinematics import link_frames

__all__ = ["holding_torque"]


def holding_torque(arm: SerialArm, q: Array) -> Array:
    """Torque that holds an arm of turning joints still, shape (N, n) [N m].

    q : shape (N, n) [rad]

    References: Siciliano et al., Robotics (2009), ch. 3 (statics).
    """
    T = link_frames(arm, q)
    starts = np.concatenate([np.broadcast_to(arm.base.matrix(), (len(q), 1, 4, 4)), T], axis=1)
    centres = np.stack(
        [T[:, k, :3, :3] @ link.inertia.com + T[:, k, :3, 3] for k, link in enumerate(arm.links)],
        axis=1,
    )
    weights = np.outer([link.inertia.mass for link in arm.links], arm.gravity)
    tau = np.empty((len(q), arm.n))
    for i, joint in enumerate(arm.joints):
        axis = starts[:, i, :3, :3] @ joint.axis
        levers = centres[:, i:] - starts[:, i, None, :3, 3]
        moment = np.cross(levers, weights[i:]).sum(axis=1)
        tau[:, i] = -(axis * moment).sum(axis=-1)
    return tau
