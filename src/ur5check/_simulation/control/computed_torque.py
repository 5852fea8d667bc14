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
    """Computed torque control: inverse dynamics of a commanded acceleration (paper, eq. 17).

    Each joint's torque is clipped to its limit.  The integral is not (no anti-windup): limits that
    act for long cause overshoot.

    Parameters
    ----------
    model : Engine
        Holds the controller's model, see `make_engine`.
    gains : Gains
        K_p, K_i, K_d.
    law : FeedbackLaw
        Form of the feedback.
    limits : array-like, shape (n,), optional
        Largest absolute torque of each joint [N m]; no limits when None.

    Raises
    ------
    InputError
        For other types, or limits of another shape.

    Examples
    --------
    >>> import ur5check
    >>> engine = ur5check.make_engine("pinocchio", "appendix")
    >>> gains = ur5check.Gains.placed(6, (-8.0, -10.0, -12.0))
    >>> ur5check.ComputedTorque(engine, gains).law.feeds_forward
    True
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
        """The commanded acceleration K (paper, eqs 22–28).

        Parameters
        ----------
        wanted : Reference
            θ_d, θ̇_d and θ̈_d, each of shape (n,).
        q, qd : ndarray, shape (n,)
            Measured [rad], [rad/s].
        integral : ndarray, shape (n,)
            ∫e dt [rad s].

        Returns
        -------
        ndarray, shape (n,)
            [rad/s²]
        """
        e, ed = wanted.q - q, wanted.qd - qd
        feedback = self.gains.kp @ e + self.gains.ki @ integral + self.gains.kd @ ed
        ahead = wanted.qdd if self.law.feeds_forward else np.zeros_like(e)
        return np.asarray(ahead + self.law.sign * feedback)

    def torque(self, wanted: Reference, q: Array, qd: Array, integral: Array) -> Array:
        """The torque that the controller commands, within the limits.

        Parameters
        ----------
        wanted : Reference
            θ_d, θ̇_d and θ̈_d, each of shape (n,).
        q, qd : ndarray, shape (n,)
            Measured [rad], [rad/s].
        integral : ndarray, shape (n,)
            ∫e dt [rad s].

        Returns
        -------
        ndarray, shape (n,)
            [N m]
        """
        K = self.acceleration(wanted, q, qd, integral)
        tau = self.model.inverse_dynamics(q, qd, K)
        return tau if self.limits is None else np.clip(tau, -self.limits, self.limits)


def effort_limits(arm: ArmSource) -> Array:
    """The effort limits of all joints of an arm.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.

    Returns
    -------
    ndarray, shape (n,)
        [N m]; [N] for a prismatic joint.

    Raises
    ------
    InputError
        For an arm that cannot be read, or a joint without an effort limit.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.effort_limits("appendix").tolist()
    [150.0, 150.0, 150.0, 28.0, 28.0, 28.0]
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
