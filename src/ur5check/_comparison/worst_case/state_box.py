"""The states that two arms may be in: a box of joint positions, velocities and accelerations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._robot.serial_arm import NO_LIMIT
from ..._robot.states import MAX_ANGLE, MAX_RATE, States
from ..._robot.transforms import Array
from ..arm_pair import Pair

__all__ = ["StateBox", "state_box"]


@dataclass(frozen=True, eq=False)
class StateBox:
    """lower ≤ q ≤ upper, |q̇| ≤ rate, |q̈| ≤ acceleration, joint by joint; each of shape (n,)."""

    lower: Array
    upper: Array
    rate: Array
    acceleration: Array

    def draw(self, count: int, seed: int | tuple[int, ...]) -> States:
        """`count` states, uniform in the box."""
        rng = np.random.default_rng(seed)
        shape = (count, len(self.lower))
        return States(
            rng.uniform(self.lower, self.upper, shape),
            rng.uniform(-self.rate, self.rate, shape),
            rng.uniform(-self.acceleration, self.acceleration, shape),
        )


def state_box(pair: Pair, acceleration: float) -> StateBox:
    """The box of a pair: arm a's limits, where it gives none arm b's, else a default.

    The defaults are those of `random_states`: |q| ≤ π and |q̇| ≤ 3.2.  No file
    limits accelerations, so that their bound is given [rad/s²], or [m/s²] for a sliding joint.  A
    velocity limit of zero would forbid all motion; files that write it mean "not known".
    """
    lower = _first(pair, "lower", -MAX_ANGLE)
    upper = _first(pair, "upper", MAX_ANGLE)
    rate = np.where((found := _first(pair, "velocity", MAX_RATE)) > 0.0, found, MAX_RATE)
    # One file's lower bound may lie above the default upper one of the other.
    return StateBox(
        np.minimum(lower, upper), np.maximum(lower, upper), rate, np.full(pair.a.n, acceleration)
    )


def _first(pair: Pair, name: str, default: float) -> Array:
    values = []
    for joints in zip(pair.a.joints, pair.b.joints, strict=True):
        given = [getattr(joint.limits, name) for joint in joints]
        known = [value for value in given if value is not None and abs(value) < NO_LIMIT]
        values.append(known[0] if known else default)
    return np.array(values, dtype=np.float64)
