"""Inertial parameters that no torque can tell from the arm's own, with what we wish in them.

Torque sees only the base parameters (`identifiability`); the rest may be chosen.  A wish says that
a parameter be zero, or equal to another one.  Wishes are taken in order, as long as they are
independent on the null space of the regressor Y: then as many hold as there are directions that no
torque sees.  The parameters that remain follow from  Y E z = Y π,  π' = E z,  where E spells the
wishes out: zeros are zeros exactly, and torques are kept to rounding.

`base_parameters.decompose` does not serve here: it scales columns by kind and takes the rank at the
steepest fall of the singular values, for a report.  This module needs the null space of Y unscaled
and down to rounding, so that torques stay the same; its basis, and with it the last digits of the
regrouped parameters, would differ.

References: Khalil & Gautier (1990) for what may be chosen.
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

#: Part of the largest singular value below which a direction is rounding: ε, summed over columns.
_ROUNDING = _EPS

#: A wish is independent of those before it if it may be granted without any of them amplifying
#: rounding by more than this.
_AMPLIFIED = 1e3

#: Torque that a parameter must make, of the whole, to be more than the rounding of a zero.
_ZERO_TOLERANCE = 64 * _EPS


@dataclass(frozen=True)
class TargetValue:
    """That a link's parameter be zero, or equal to another of its parameters."""

    link: int
    parameter: str
    equal_to: str | None = None

    @property
    def places(self) -> tuple[int, ...]:
        """Where the parameters stand among all 10 n."""
        names = (self.parameter,) if self.equal_to is None else (self.parameter, self.equal_to)
        return tuple(10 * self.link + PARAMETERS.index(name) for name in names)


@dataclass(frozen=True, eq=False)
class Unseen:
    """What may be chosen freely in an arm's inertial parameters.

    arm : whose parameters π are to be rewritten
    less : an arm of the same geometry, whose parameters are taken away: π then makes the difference
        of the two arms' torques
    seed : of the random states at which Y is asked; the answer does not depend on it
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
        """Directions that no torque sees, orthonormal, shape (10 n, k)."""
        _, s, Vt = np.linalg.svd(self.triangle)
        return np.asarray(Vt[s <= len(s) * _ROUNDING * s[0]].T)

    def cancellation_bound(self, pi: Array) -> float:
        """Σ of the torques that each parameter makes alone: what rounding is a part of."""
        return float(np.linalg.norm(self.triangle, axis=0) @ np.abs(pi))

    def change(self, pi: Array) -> float:
        """How far torques with parameters π' are from those of π, as a part of its loudness."""
        change = float(np.linalg.norm(self.triangle @ (pi - self.pi)))
        return change / (self.cancellation_bound(self.pi) or 1.0)

    def feasible(self, target_values: Sequence[TargetValue]) -> list[TargetValue]:
        """The first wishes that can all be granted, at most one a direction.

        Rows of the null space, made orthogonal one by one: rows = L · spanned.  L⁻¹ says how far
        directions must go to fulfil the wishes, however many nearly depend on each other: along a
        chain, small remainders multiply.
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
        """π', shape (10 n,): the same torques, and the wishes that can be granted."""
        E = _spelled_out(self.feasible(target_values), len(self.pi))
        torque, columns = self.triangle @ self.pi, self.triangle @ E
        z = np.linalg.lstsq(columns, torque, rcond=None)[0]
        z[
            np.abs(z) * np.linalg.norm(columns, axis=0) < _ZERO_TOLERANCE * np.linalg.norm(torque)
        ] = 0.0
        return np.asarray(E @ z)


def _spelled_out(target_values: Sequence[TargetValue], count: int) -> Array:
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
