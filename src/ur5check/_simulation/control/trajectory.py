"""Desired position, velocity and acceleration at any instant."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from ..._arguments import number, number_array
from ..._errors import UsageError
from ..._robot.transforms import Array, frozen

__all__ = ["Quintic", "Reference", "Trajectory"]


@dataclass(frozen=True, eq=False)
class Reference:
    """Desired q [rad], q̇ [rad/s] and q̈ [rad/s²], each of shape (..., n)."""

    q: Array
    qd: Array
    qdd: Array


@runtime_checkable
class Trajectory(Protocol):
    """A motion of n joints over `duration` seconds; at rest before and after."""

    @property
    def n(self) -> int:
        """Number of joints."""
        ...

    @property
    def duration(self) -> float:
        """[s]"""
        ...

    def at(self, t: ArrayLike) -> Reference:
        """At instants of shape (...) [s], arrays of shape (..., n)."""
        ...


@dataclass(frozen=True, eq=False)
class Quintic:
    """A motion from rest to rest with continuous acceleration: q = start + s(t/T) (goal − start).

    s(x) = 10 x³ − 15 x⁴ + 6 x⁵ has s′ = s″ = 0 at both ends.

    Parameters
    ----------
    start, goal : array-like, shape (n,)
        [rad]; [m] for a prismatic joint.
    duration : float
        T [s], positive.

    Raises
    ------
    UsageError
        For ends of different lengths, numbers that are not finite, or a T that is not positive.

    References
    ----------
    Siciliano et al. 2009, §4.2.1.

    Examples
    --------
    >>> from ur5check import Quintic
    >>> Quintic([0.0], [1.0], 2.0).at(1.0).q.tolist()
    [0.5]
    """

    start: Array
    goal: Array
    duration: float

    def __post_init__(self) -> None:
        start = number_array("start", self.start, error=UsageError)
        goal = number_array("goal", self.goal, error=UsageError)
        if start.ndim != 1 or start.shape != goal.shape:
            raise UsageError(
                f"start has shape {start.shape} and goal {goal.shape}; give each one number per "
                "joint"
            )
        if not (np.isfinite(start).all() and np.isfinite(goal).all()):
            raise UsageError("start and goal must be finite numbers")
        object.__setattr__(self, "duration", number("duration", self.duration, positive=True))
        object.__setattr__(self, "start", frozen(start, start.shape))
        object.__setattr__(self, "goal", frozen(goal, goal.shape))

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.start)

    def at(self, t: ArrayLike) -> Reference:
        """Desired position, velocity and acceleration; at rest before 0 and after T.

        Parameters
        ----------
        t : array-like, shape (...)
            [s]

        Returns
        -------
        Reference
            q [rad], qd [rad/s] and qdd [rad/s²], each of shape (..., n).
        """
        x = np.clip(np.asarray(t, dtype=np.float64)[..., None] / self.duration, 0.0, 1.0)
        way, T = self.goal - self.start, self.duration
        s = x**3 * (10.0 - 15.0 * x + 6.0 * x**2)
        sd = 30.0 * x**2 * (1.0 - x) ** 2 / T
        sdd = 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x) / T**2
        return Reference(self.start + s * way, sd * way, sdd * way)
