"""Joint states to ask questions at: drawn from a seed, so that every report can be made again."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._errors import UsageError
from .transforms import Array

__all__ = ["MAX_ACCELERATION", "MAX_ANGLE", "MAX_RATE", "States", "random_states"]

MAX_ANGLE = float(np.pi)  # [rad]
MAX_RATE = 3.2  # [rad/s], the UR5's fastest joints
MAX_ACCELERATION = 10.0  # [rad/s²]


@dataclass(frozen=True, eq=False)
class States:
    """N joint states: `q` [rad], `qd` [rad/s], `qdd` [rad/s²], each of shape (N, n)."""

    q: Array
    qd: Array
    qdd: Array

    def __len__(self) -> int:
        return len(self.q)

    def __getitem__(self, index: int) -> dict[str, list[float]]:
        """State number `index` as plain numbers, for a report."""
        return {
            "q": self.q[index].tolist(),
            "qd": self.qd[index].tolist(),
            "qdd": self.qdd[index].tolist(),
        }


def random_states(n: int, count: int, seed: int) -> States:
    """`count` states of n joints, each entry uniform in |q| ≤ π, |q̇| ≤ 3.2, |q̈| ≤ 10.

    Joint limits are left aside on purpose: the laws hold beyond them, and two models are compared
    over all that their joints could do.  Raises UsageError for a count below 1 or a negative seed.
    """
    if count < 1:
        raise UsageError(f"samples must be at least 1, not {count}")
    if seed < 0:
        raise UsageError(f"the seed must not be negative, not {seed}")
    rng = np.random.default_rng(seed)
    return States(
        *(
            rng.uniform(-bound, bound, (count, n))
            for bound in (MAX_ANGLE, MAX_RATE, MAX_ACCELERATION)
        )
    )
