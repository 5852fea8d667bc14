"""A controller and a plant, closed into a loop: how well does the arm follow, and at what price?

The plant is whatever engine holds the arm that moves; the controller believes in its own.  Both
speak the same joint coordinates (`_comparison.arm_pair` brings one arm's into another's).  The loop
is continuous: torques follow the state without delay.  What is measured is then the model's and the
law's doing, not the sampling's.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..._engines.engine import Engine
from ..._errors import UsageError
from ..._robot.transforms import Array
from ..integration import WORKING, Precision, integrate
from .computed_torque import ComputedTorque
from .trajectory import Trajectory

__all__ = ["LOST", "Tracking", "track"]

#: A joint that is half a turn from where it should be is not following any more [rad].
LOST = float(np.pi)


@dataclass(frozen=True, eq=False)
class Tracking:
    """What came of following a trajectory; K instants, n joints.

    t : shape (K,) [s];  wanted, q : [rad], qd : [rad/s], tau : [N m], each of shape (K, n)
    work : ∫ |τ_i q̇_i| dt of each joint, shape (K, n) [J]: what motors spend that win nothing back
    at_limit : whether a joint's torque was at its limit, shape (K, n)
    lost : whether it ended because a joint was LOST from its reference
    """

    t: Array
    wanted: Array
    q: Array
    qd: Array
    tau: Array
    work: Array
    at_limit: Array
    lost: bool

    @property
    def error(self) -> Array:
        """θ_d − θ, shape (K, n) [rad]."""
        return np.asarray(self.wanted - self.q)

    def rms(self) -> Array:
        """Root mean square error of each joint over time, shape (n,) [rad]."""
        return np.sqrt(self._mean(self.error**2))

    def largest(self) -> Array:
        """Largest error of each joint, shape (n,) [rad]."""
        return np.asarray(np.abs(self.error).max(axis=0))

    def torque_rms(self) -> Array:
        """Of each joint, shape (n,) [N m]."""
        return np.sqrt(self._mean(self.tau**2))

    def torque_peak(self) -> Array:
        """Of each joint, shape (n,) [N m]."""
        return np.asarray(np.abs(self.tau).max(axis=0))

    def energy(self) -> float:
        """What all motors spent [J]."""
        return float(self.work[-1].sum())

    def time_at_limit(self) -> Array:
        """Part of the time that each joint's torque was at its limit, shape (n,)."""
        return self._mean(self.at_limit.astype(np.float64))

    def _mean(self, values: Array) -> Array:
        """Over time; instants need not be evenly spaced."""
        if len(self.t) < 2:
            return np.asarray(values[0])
        return np.asarray(np.trapezoid(values, self.t, axis=0) / (self.t[-1] - self.t[0]))


def track(
    controller: ComputedTorque,
    plant: Engine,
    trajectory: Trajectory,
    *,
    q: ArrayLike | None = None,
    seconds: float | None = None,
    instants: int = 501,
    precision: Precision = WORKING,
) -> Tracking:
    """Let `controller` drive `plant` along `trajectory`.

    q : where the plant starts, at the reference's velocity, shape (n,) [rad]; on the trajectory
        when None
    seconds : for how long; the trajectory's duration when None
    instants : how many are kept, evenly spaced

    Raises UsageError for arms, gains and trajectories of different numbers of joints.
    """
    n = trajectory.n
    _refuse_sizes(controller, plant, n)
    begin = trajectory.at(0.0)
    start = np.asarray(begin.q if q is None else q, dtype=np.float64)
    end = trajectory.duration if seconds is None else seconds

    def rate(t: float, y: Array) -> Array:
        q, qd, integral = y[:n], y[n : 2 * n], y[2 * n : 3 * n]
        wanted = trajectory.at(t)
        tau = controller.torque(wanted, q, qd, integral)
        qdd = plant.forward_dynamics(q, qd, tau)
        return np.concatenate([qd, qdd, wanted.q - q, np.abs(tau * qd)])

    def margin(t: float, y: Array) -> float:
        return LOST - float(np.abs(trajectory.at(t).q - y[:n]).max())

    y_0 = np.concatenate([start, begin.qd, np.zeros(2 * n)])
    times = np.linspace(0.0, end, instants)
    t, y = integrate(rate, y_0, times, precision=precision, stop=margin)
    q_t, qd_t, integral, work = np.split(y, 4, axis=1)
    wanted = [trajectory.at(instant) for instant in t]
    tau = np.array(
        [controller.torque(*now) for now in zip(wanted, q_t, qd_t, integral, strict=True)]
    )
    limits = np.inf if controller.limits is None else controller.limits
    return Tracking(
        t,
        np.array([reference.q for reference in wanted]),
        q_t,
        qd_t,
        tau,
        work,
        np.abs(tau) >= limits,
        lost=bool(t[-1] < end),
    )


def _refuse_sizes(controller: ComputedTorque, plant: Engine, n: int) -> None:
    sizes = {
        "the gains": controller.gains.n,
        "the controller's model": len(controller.model.imported_model().joints),
        "the plant": len(plant.imported_model().joints),
    }
    for what, size in sizes.items():
        if size != n:
            raise UsageError(f"the trajectory has {n} joints, {what} {size}; they must be the same")
