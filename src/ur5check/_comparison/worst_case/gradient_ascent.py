"""Gradient ascent to the state of the largest torque difference, with exact gradients.

The objective is a function of Δτ = τ_a − τ_b: one joint's s Δτ_j with s = ±1, or ½ Σ (w_j Δτ_j)².
The gradient of either goes through ∂Δτ/∂(q, q̇, q̈), which Pinocchio gives exactly; a truncated
Newton method maximises it inside the box (sources: docs/worst-case.md).

The accelerations need no search.  Δτ = ΔM q̈ + Δh is linear in q̈, so both functions are
convex in q̈, and a convex function on a box is largest at a corner.  For one joint the corner is
known at once: q̈_k = A_k sign(s ΔM_jk).  For the sum, q̈ ← A sign(∇) with the gradient at the
previous corner never decreases it, since a convex function lies above
its tangents; it ends in a few steps.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ..._engines.adapters.pinocchio import PinocchioEngine
from ..._robot.serial_arm import SerialArm, Source
from ..._robot.transforms import Array
from ..arm_pair import Pair

__all__ = ["Ascent", "Gap", "joint_gain", "squared_sum"]

#: From Δτ: the objective, and its gradient with respect to Δτ, shape (n,).
Gain = Callable[[Array], tuple[float, Array]]

_MOST_CORNERS = 20  # two or three, as measured


def joint_gain(joint: int, sign: float, n: int) -> Gain:
    """s · Δτ_j."""
    slope = sign * np.eye(n)[joint]
    return lambda delta: (float(slope @ delta), slope)


def squared_sum(weights: Array) -> Gain:
    """½ Σ (w_j Δτ_j)²."""

    def gain(delta: Array) -> tuple[float, Array]:
        slope = weights**2 * delta
        return float(slope @ delta) / 2.0, slope

    return gain


class Gap:
    """Δτ and its gradient as functions of x = (q, q̇, q̈), shape (3 n,); counts its calls."""

    def __init__(self, pair: Pair) -> None:
        self.engines = [PinocchioEngine(_as_a_value(arm)) for arm in (pair.a, pair.b)]
        self.evaluations = 0

    def __call__(self, x: Array) -> tuple[Array, Array]:
        """Δτ, shape (n,), and ∂Δτ/∂x, shape (n, 3 n)."""
        self.evaluations += 1
        q, qd, qdd = x.reshape(3, -1)
        (tau_a, slope_a), (tau_b, slope_b) = (
            engine.torque_and_slope(q, qd, qdd) for engine in self.engines
        )
        return tau_a - tau_b, slope_a - slope_b


def _as_a_value(arm: SerialArm) -> SerialArm:
    # The arm with its present inertias, not the file that it was read from.
    return replace(arm, source=Source())


@dataclass(frozen=True, eq=False)
class Ascent:
    """Gradient ascent in the box lower ≤ x ≤ upper, each of shape (3 n,)."""

    gap: Gap
    lower: Array
    upper: Array

    def climb(self, start: Array, gain: Gain, *, digits: int = 5) -> tuple[float, Array]:
        """The local maximum reached from `start`: the objective there and x.

        digits : significant digits of the objective, about. Never ends below its start.
        """
        free = self.lower < self.upper
        value, x = self.best_corner(start, gain)
        if value <= 0.0 or not free.any():
            return value, x

        from scipy.optimize import Bounds, minimize  # heavy: only a search pays for it

        def falling(z: Array) -> tuple[float, Array]:
            moved = x.copy()
            moved[free] = z
            height, slope = self._gain(moved, gain)
            return -height / value, -slope[free] / value

        found = minimize(
            falling,
            x[free],
            jac=True,
            # Not L-BFGS-B: its small matrices go through a threaded BLAS, whose threads wait
            # for each other on a busy machine (measured: 17 s where this takes 0.7 s).
            method="TNC",
            bounds=Bounds(self.lower[free], self.upper[free]),
            options={"ftol": 10.0**-digits, "gtol": 10.0**-digits, "maxfun": 300},
        )
        top = x.copy()
        top[free] = np.clip(found.x, self.lower[free], self.upper[free])
        return max((value, x), self.best_corner(top, gain), key=lambda reached: reached[0])

    def best_corner(self, x: Array, gain: Gain) -> tuple[float, Array]:
        """x with the best accelerations at the same positions and velocities."""
        part = slice(2 * len(x) // 3, len(x))
        value, slope = self._gain(x, gain)
        for _ in range(_MOST_CORNERS):
            moved = x.copy()
            moved[part] = np.where(slope[part] >= 0.0, self.upper[part], self.lower[part])
            if np.array_equal(moved, x):
                break
            higher, steeper = self._gain(moved, gain)
            if higher <= value:
                break
            value, slope, x = higher, steeper, moved
        return value, x

    def better_corner(self, x: Array, gain: Gain) -> Array:
        """x, or x with velocities at a corner of the box, by the larger objective."""
        rates = slice(len(x) // 3, 2 * len(x) // 3)
        corner = x.copy()
        corner[rates] = np.where(x[rates] < 0.0, self.lower[rates], self.upper[rates])
        reached = [self.best_corner(start, gain) for start in (x, corner)]
        return max(reached, key=lambda top: top[0])[1]

    def _gain(self, x: Array, gain: Gain) -> tuple[float, Array]:
        delta, gradient = self.gap(x)
        value, slope = gain(delta)
        return value, slope @ gradient
