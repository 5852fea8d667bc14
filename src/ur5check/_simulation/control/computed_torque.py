"""Computed torque: inverse dynamics of a commanded acceleration (paper, eqs 16–28).

    τ = M(θ) K + C(θ, θ̇) θ̇ + g(θ)                                                      (17)

which is the inverse dynamics of the acceleration K, computed by any engine.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._arguments import instance
from ..._engines.engine import Engine
from ..._errors import UsageError
from ..._robot.as_arm import ArmSource, as_arm
from ..._robot.transforms import Array, frozen
from .feedback_law import FeedbackLaw
from .gains import Gains
from .trajectory import Reference

__all__ = ["ComputedTorque", "effort_limits"]


@dataclass(frozen=True, eq=False)
class ComputedTorque:
    """The controller.

    model : an engine that holds the controller's model
    gains : K_p, K_i, K_d
    law : form of the feedback
    limits : largest absolute torque of each joint, shape (n,) [N m]; None: no limits

    Each joint's torque is clipped to its limit.  The integral is not (no anti-windup): limits that
    act for long cause overshoot.
    """

    model: Engine
    gains: Gains
    law: FeedbackLaw = FeedbackLaw.RIGHT
    limits: Array | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.model, Engine):
            raise UsageError(
                f"model must be an engine, not {self.model!r:.60}; see ur5check.make_engine"
            )
        instance("gains", self.gains, Gains, "see ur5check.Gains")
        instance("law", self.law, FeedbackLaw, "see ur5check.FeedbackLaw")
        if self.limits is not None:
            object.__setattr__(self, "limits", frozen(self.limits, (self.gains.n,), "limits"))

    def acceleration(self, wanted: Reference, q: Array, qd: Array, integral: Array) -> Array:
        """K, shape (n,) [rad/s²]; `integral` is ∫e dt [rad s]."""
        e, ed = wanted.q - q, wanted.qd - qd
        feedback = self.gains.kp @ e + self.gains.ki @ integral + self.gains.kd @ ed
        ahead = wanted.qdd if self.law.feeds_forward else np.zeros_like(e)
        return np.asarray(ahead + self.law.sign * feedback)

    def torque(self, wanted: Reference, q: Array, qd: Array, integral: Array) -> Array:
        """τ, shape (n,) [N m], within the limits."""
        K = self.acceleration(wanted, q, qd, integral)
        tau = self.model.inverse_dynamics(q, qd, K)
        return tau if self.limits is None else np.clip(tau, -self.limits, self.limits)


def effort_limits(arm: ArmSource) -> Array:
    """The effort limits of the joints, shape (n,) [N m].

    Raises UsageError if a joint has none.
    """
    arm = as_arm(arm)
    limits = [joint.limits.known_effort for joint in arm.joints]
    for joint, limit in zip(arm.joints, limits, strict=True):
        if limit is None:
            raise UsageError(
                f"joint {joint.name!r} of {arm.name!r} has no effort limit; take the limits of "
                "another arm, or track without limits"
            )
    return np.array(limits, dtype=np.float64)
