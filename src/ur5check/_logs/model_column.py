"""Is a torque column measured, or computed by the controller from its own model?

A measured torque has friction in it.  A computed one follows a rigid model, with some rotor inertia
perhaps, and shows none.  To call it measured would prove the controller's model right by itself.
"""

from __future__ import annotations

import numpy as np

from .joint_residuals import JointResidual

__all__ = ["is_a_model"]

#: A real drive loses more than this part of its torque to friction; what a filter leaves of a
#: computed torque's rounding is a hundredth of it.
_FRICTION = 0.01

#: A computed torque follows the model, once scaled, to this part of its size; the best of real
#: recordings (joint torque sensors) reach 0.03.
_FOLLOWS = 0.01


def is_a_model(joints: tuple[JointResidual, ...]) -> bool:
    """Whether the torques of all joints that stand out are free of friction and follow a model."""
    clear = [joint for joint in joints if joint.stands_out and joint.model > 0.0]
    return bool(clear) and all(
        abs(_coulomb(joint)) < _FRICTION * joint.measured
        and min(joint.floor, joint.with_rotor) < _FOLLOWS * joint.measured
        for joint in clear
    )


def _coulomb(joint: JointResidual) -> float:
    """Coulomb friction of the fit [N m]; of an asymmetric one the larger."""
    return float(np.abs(joint.drive.value[1:-3]).max(initial=0.0))
