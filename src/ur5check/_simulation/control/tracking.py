"""A controller and a plant in a loop: tracking errors, torques and energy.

The plant is an engine that holds the simulated arm; the controller has its own model.  Both use the
same joint coordinates (`_comparison.arm_pair` aligns two arms).  The loop is continuous, without
sampling or delay, so that errors come from the model and the law alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..._arguments import instance, integer, number, number_array
from ..._engines.engine import Engine
from ..._errors import UsageError
from ..._robot.transforms import Array, frozen
from ..integration import WORKING, Precision, integrate
from .computed_torque import ComputedTorque
from .trajectory import Trajectory

__all__ = ["LOST", "Tracking", "track"]

#: Tracking error at which a simulation ends [rad].
LOST = float(np.pi)


@dataclass(frozen=True, eq=False)
class Tracking:
    """Result of following a trajectory at K instants with n joints.

    Attributes
    ----------
    t : ndarray, shape (K,)
        [s]
    wanted, q : ndarray, shape (K, n)
        Desired and actual positions [rad].
    qd : ndarray, shape (K, n)
        [rad/s]
    tau : ndarray, shape (K, n)
        [N m]
    work : ndarray, shape (K, n)
        ∫ |τ_i q̇_i| dt of each joint [J]: without energy recovery.
    at_limit : ndarray of bool, shape (K, n)
        Whether a joint's torque was at its limit.
    lost : bool
        Whether it ended early because an error reached π rad.
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
        """Tracking error θ_d − θ, shape (K, n) [rad]."""
        return np.asarray(self.wanted - self.q)

    def rms(self) -> Array:
        """Root mean square error of each joint over time.

        Returns
        -------
        ndarray, shape (n,)
            [rad]
        """
        return np.sqrt(self._mean(self.error**2))

    def largest(self) -> Array:
        """Largest error of each joint.

        Returns
        -------
        ndarray, shape (n,)
            [rad]
        """
        return np.asarray(np.abs(self.error).max(axis=0))

    def torque_peak(self) -> Array:
        """Largest absolute torque of each joint.

        Returns
        -------
        ndarray, shape (n,)
            [N m]
        """
        return np.asarray(np.abs(self.tau).max(axis=0))

    def energy(self) -> float:
        """Work of all motors, without energy recovery.

        Returns
        -------
        float
            [J]
        """
        return float(self.work[-1].sum())

    def time_at_limit(self) -> Array:
        """Share of the time that each joint's torque was at its limit.

        Returns
        -------
        ndarray, shape (n,)
        """
        return self._mean(self.at_limit.astype(np.float64))

    def _mean(self, values: Array) -> Array:
        """Mean over time; instants need not be evenly spaced."""
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

    Parameters
    ----------
    controller : ComputedTorque
    plant : Engine
        Holds the simulated arm, in the joint coordinates of the controller's model.
    trajectory : Quintic
        Or another object with `n`, `duration` and `at`.
    q : array-like, shape (n,), optional
        Initial position of the plant [rad]; on the trajectory when None.  Its initial velocity is
        the reference's.
    seconds : float, optional
        Simulated time [s]; the trajectory's duration when None.
    instants : int
        Number of evenly spaced instants in the result, at least 2.
    precision : Precision
        Tolerances of the integrator.

    Returns
    -------
    Tracking

    Raises
    ------
    InputError
        For invalid arguments, or different numbers of joints of arms, gains and trajectory.

    Examples
    --------
    >>> import ur5check
    >>> engine = ur5check.make_engine("ur5check", "appendix")
    >>> gains = ur5check.Gains.placed(6, (-8.0, -10.0, -12.0))
    >>> motion = ur5check.Quintic([0.0] * 6, [0.1] * 6, 0.5)
    >>> result = ur5check.track(ur5check.ComputedTorque(engine, gains), engine, motion, instants=6)
    >>> bool(result.largest().max() < 1e-6)
    True
    """
    instance("controller", controller, ComputedTorque, "see ur5check.ComputedTorque")
    if not isinstance(plant, Engine) or not isinstance(trajectory, Trajectory):
        raise UsageError(
            "plant must be an engine (ur5check.make_engine) and trajectory a trajectory "
            f"(ur5check.Quintic), not {plant!r:.60} and {trajectory!r:.60}"
        )
    instants = integer("instants", instants, least=2)
    seconds = None if seconds is None else number("seconds", seconds, positive=True)
    n = trajectory.n
    _require_same_size(controller, plant, n)
    begin = trajectory.at(0.0)
    start = frozen(begin.q if q is None else number_array("q", q), (n,), "q")
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


def _require_same_size(controller: ComputedTorque, plant: Engine, n: int) -> None:
    sizes = {
        "the gains": controller.gains.n,
        "the controller's model": len(controller.model.imported_model().joints),
        "the plant": len(plant.imported_model().joints),
    }
    for what, size in sizes.items():
        if size != n:
            raise UsageError(f"the trajectory has {n} joints, {what} {size}; they must be the same")
