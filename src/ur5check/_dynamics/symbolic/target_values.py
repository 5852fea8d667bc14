"""Inertial parameters with the same torques as an arm's own, and with target values.

Torques depend only on the base parameters (`identifiability`); the rest may be chosen.  A target
value sets a parameter to zero, or equal to another one.  Target values are accepted in order, as
long as they are independent on the null space of the regressor Y: as many as its dimension.  The
remaining parameters follow from  Y E z = Y π,  π' = E z,  where E encodes the target values: zeros
are exact, and torques are unchanged to rounding.

`base_parameters.decompose` answers another question.  It takes the rank where the singular values
fall most, so that an axis tilted by a rounded digit counts as straight: its null space then changes
the torques of a planar arm, tilted by 1e-9 rad, by 7e-10 of the largest.  Here torques must stay
the same to rounding (2e-16), so the null space is that of Y unscaled and down to rounding, and a
target value may also equate two parameters.

References: Gautier & Khalil (1990) on the free parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..._robot.inertia import PARAMETERS
from ..._robot.serial_arm import SerialArm
from ..._robot.states import random_states
from ..._robot.transforms import Array
from ..regressor import torque_regressor

__all__ = ["TargetValue", "Unseen"]

_EPS = float(np.finfo(np.float64).eps)

#: Share of the largest singular value below which a direction is rounding: ε per column.
_ROUNDING = _EPS

#: A target value is independent of those before it if together they amplify rounding by less.
_AMPLIFIED = 1e3

#: Share of the torques below which a parameter's contribution is the rounding of a zero.
_ZERO_TOLERANCE = 64 * _EPS


@dataclass(frozen=True)
class TargetValue:
    """A link's parameter is zero, or equal to another of its parameters."""

    link: int
    parameter: str
    equal_to: str | None = None

    @property
    def places(self) -> tuple[int, ...]:
        """Indices of the parameters among all 10 n."""
        names = (self.parameter,) if self.equal_to is None else (self.parameter, self.equal_to)
        return tuple(10 * self.link + PARAMETERS.index(name) for name in names)


@dataclass(frozen=True, eq=False)
class Unseen:
    """The unidentifiable directions of an arm's inertial parameters π.

    arm : with the parameters π
    less : an arm of the same geometry, whose parameters are subtracted: π then gives the difference
        of the two arms' torques
    seed : of the random states of Y; the result does not depend on it
    """

    arm: SerialArm
    less: SerialArm | None = None
    seed: int = 0

    @cached_property
    def pi(self) -> Array:
        """π, shape (10 n,)."""
        pi = self.arm.parameters()
        return pi if self.less is None else np.asarray(pi - self.less.parameters())

    @cached_property
    def triangle(self) -> Array:
        """R of Y = Q R over many states, shape (10 n, 10 n): ‖R π‖ is the size of the torques."""
        n = self.arm.n
        states = random_states(n, 40 + 40 * n, self.seed)
        Y = torque_regressor(self.arm, states.q, states.qd, states.qdd)
        return np.asarray(np.linalg.qr(Y.reshape(-1, 10 * n), mode="r"))

    @cached_property
    def null_space(self) -> Array:
        """Directions without effect on torques, orthonormal, shape (10 n, k)."""
        _, s, Vt = np.linalg.svd(self.triangle)
        return np.asarray(Vt[s <= len(s) * _ROUNDING * s[0]].T)

    def cancellation_bound(self, pi: Array) -> float:
        """Σ of the torques of each parameter alone, to which rounding errors are proportional."""
        return float(np.linalg.norm(self.triangle, axis=0) @ np.abs(pi))

    def change(self, pi: Array) -> float:
        """Change of the torques from π to another, as a share of its cancellation bound."""
        change = float(np.linalg.norm(self.triangle @ (pi - self.pi)))
        return change / (self.cancellation_bound(self.pi) or 1.0)

    def feasible(self, target_values: Sequence[TargetValue]) -> list[TargetValue]:
        """The first target values that hold together, at most one per direction.

        Rows of the null space are orthogonalised one by one: rows = L · spanned.  L⁻¹ bounds the
        amplification of rounding, also where many rows are nearly dependent.
        """
        feasible: list[TargetValue] = []
        spanned = np.zeros((0, self.null_space.shape[1]))
        inverse = np.zeros((0, 0))  # of L
        for target_value in target_values:
            if len(spanned) == spanned.shape[1]:
                break
            first, *second = (self.null_space[place] for place in target_value.places)
            rest = first - second[0] if second else first
            along = np.zeros(len(spanned))
            for _ in range(2):  # twice is enough (Kahan, Parlett) to stay orthogonal to rounding
                step = spanned @ rest
                along, rest = along + step, rest - step @ spanned
            size = float(np.linalg.norm(rest))
            farthest = np.append(-along @ inverse, 1.0)
            if np.linalg.norm(farthest) < _AMPLIFIED * size:
                spanned = np.vstack([spanned, rest / size])
                inverse = np.vstack(
                    [np.pad(inverse, ((0, 0), (0, 1))), farthest / size],
                )
                feasible.append(target_value)
        return feasible

    def parameters(self, target_values: Sequence[TargetValue]) -> Array:
        """π', shape (10 n,): with the same torques, and the feasible target values."""
        E = _constraint_matrix(self.feasible(target_values), len(self.pi))
        torque, columns = self.triangle @ self.pi, self.triangle @ E
        z = np.linalg.lstsq(columns, torque, rcond=None)[0]
        z[
            np.abs(z) * np.linalg.norm(columns, axis=0) < _ZERO_TOLERANCE * np.linalg.norm(torque)
        ] = 0.0
        return np.asarray(E @ z)


def _constraint_matrix(target_values: Sequence[TargetValue], count: int) -> Array:
    """E, shape (count, remaining): a column for each parameter, or each group of equal ones."""
    group = list(range(count))
    for target_value in target_values:
        if target_value.equal_to is not None:
            one, other = (group[place] for place in target_value.places)
            group = [one if member == other else member for member in group]
    zero = {
        group[target_value.places[0]]
        for target_value in target_values
        if target_value.equal_to is None
    }
    kept = sorted(set(group) - zero)
    return np.array([[float(member == column) for column in kept] for member in group])
