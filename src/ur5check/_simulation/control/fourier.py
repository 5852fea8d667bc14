"""Finite Fourier series: periodic motions that excite every parameter, from rest to rest.

    q̇_i(t) = Σ_l a_il cos(l ω t) + b_il sin(l ω t),        l = 1 … L     (Swevers et al. 1997)

Position and acceleration follow exactly, so that measured torque is compared with a regressor that
carries no differentiation noise.  Two conditions a joint make it begin and end at rest:

    q̇(0) = Σ a_l = 0        q̈(0) = ω Σ l b_l = 0
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..._errors import UsageError
from ..._robot.serial_arm import SerialArm
from ..._robot.states import MAX_ACCELERATION, MAX_ANGLE, MAX_RATE
from ..._robot.transforms import Array
from .trajectory import Reference

__all__ = ["FourierSeries", "excitation"]

_INSTANTS = 512  # a period, to find the largest values of a series of a few harmonics
_WITHIN = 0.99  # of the limits: what lies between two instants is a thousandth larger at most


@dataclass(frozen=True, eq=False)
class FourierSeries:
    """A periodic motion, followed for one period.

    start : q(0), shape (n,) [rad];  a, b : of the velocity, shape (n, L) [rad/s]
    duration : the period 2π/ω [s]
    """

    start: Array
    a: Array
    b: Array
    duration: float

    def __post_init__(self) -> None:
        if not (np.isfinite(self.duration) and self.duration > 0.0):
            raise UsageError(f"the period must be a positive time, not {self.duration:g} s")
        n = len(self.start)
        if self.a.shape != self.b.shape or self.a.ndim != 2 or len(self.a) != n:
            raise UsageError(
                f"coefficients of shapes {self.a.shape} and {self.b.shape} for {n} joints; give "
                "one row a joint and one column a harmonic, the same of both"
            )

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.start)

    def at(self, t: ArrayLike) -> Reference:
        """See `Trajectory`; periodic, so that it may be followed for as long as one likes."""
        rates = 2.0 * np.pi / self.duration * np.arange(1, self.a.shape[1] + 1)  # l ω
        phase = np.asarray(t, dtype=np.float64)[..., None] * rates
        cos, sin = np.cos(phase), np.sin(phase)
        return Reference(
            self.start + (sin / rates) @ self.a.T + ((1.0 - cos) / rates) @ self.b.T,
            cos @ self.a.T + sin @ self.b.T,
            (cos * rates) @ self.b.T - (sin * rates) @ self.a.T,
        )


def excitation(
    arm: SerialArm, *, seed: int = 0, harmonics: int = 5, period: float = 10.0
) -> FourierSeries:
    """A random series from rest, as large as the arm's limits allow.

    Positions stay within the joints' limits (±π where there are none), velocities likewise (3.2
    rad/s), accelerations within 10 rad/s²; the motion is centred between the position limits.

    Raises UsageError for fewer than 2 harmonics (one cannot start from rest) or a negative seed.
    """
    if harmonics < 2:
        raise UsageError(f"a series from rest needs at least 2 harmonics, not {harmonics}")
    if seed < 0:
        raise UsageError(f"the seed must not be negative, not {seed}")
    rng = np.random.default_rng(seed)
    l = np.arange(1, harmonics + 1)  # noqa: E741 - as in the formula
    a, b = rng.normal(size=(2, arm.n, harmonics)) / l
    a -= a.mean(axis=1, keepdims=True)
    b -= np.outer(b @ l, l) / (l @ l)
    draft = FourierSeries(np.zeros(arm.n), a, b, period)
    way = draft.at(np.linspace(0.0, period, _INSTANTS))
    lower, upper = _position_limits(arm)
    low, high = way.q.min(axis=0), way.q.max(axis=0)
    scale = _WITHIN * np.min(
        [
            (upper - lower) / (high - low),
            _rates(arm) / np.abs(way.qd).max(axis=0),
            MAX_ACCELERATION / np.abs(way.qdd).max(axis=0),
        ],
        axis=0,
    )
    start = 0.5 * (lower + upper) - 0.5 * scale * (low + high)
    return FourierSeries(start, scale[:, None] * a, scale[:, None] * b, period)


def _position_limits(arm: SerialArm) -> tuple[Array, Array]:
    lower = [-MAX_ANGLE if j.limits.lower is None else j.limits.lower for j in arm.joints]
    upper = [MAX_ANGLE if j.limits.upper is None else j.limits.upper for j in arm.joints]
    return np.array(lower), np.array(upper)


def _rates(arm: SerialArm) -> Array:
    return np.array([joint.limits.velocity or MAX_RATE for joint in arm.joints])
