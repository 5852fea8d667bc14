"""The range of joint positions within which a simulation is meaningful.

Simulated arms have no stops, so that an arm under a wrong constant torque would spin ever faster,
where a real one meets its stop.  The simulation ends where the first joint reaches the limit in
the model, or, where the model has none, a full turn from the start.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._errors import UsageError
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["JointRange", "joint_range_of"]

_FULL_TURN = 2.0 * np.pi


@dataclass(frozen=True, eq=False)
class JointRange:
    """lower, upper : joint positions, shape (n,) [rad], within which the motion is simulated."""

    lower: Array
    upper: Array

    def margin(self, q: Array) -> float:
        """Smallest distance of a joint from its limit [rad]; negative beyond it."""
        return float(np.minimum(q - self.lower, self.upper - q).min())


def joint_range_of(arm: SerialArm, q: Array) -> JointRange:
    """The joints' limits; a full turn either way of `q`, shape (n,) [rad], where there are none.

    Raises UsageError if the arm already is beyond a limit.
    """
    lower, upper = q - _FULL_TURN, q + _FULL_TURN
    for i, joint in enumerate(arm.joints):
        if joint.limits.lower is not None:
            lower[i] = joint.limits.lower
        if joint.limits.upper is not None:
            upper[i] = joint.limits.upper
        if not lower[i] < q[i] < upper[i]:
            raise UsageError(
                f"joint {joint.name!r} of {arm.name!r} starts at {q[i]:.4g} rad, which is not "
                f"between its limits {lower[i]:.4g} and {upper[i]:.4g}; choose another pose"
            )
    return JointRange(lower, upper)
