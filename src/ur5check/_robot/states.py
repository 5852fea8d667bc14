"""Joint states, and states drawn at random from a seed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._arguments import integer, number_array
from .._errors import StateError
from .transforms import Array

__all__ = ["MAX_ACCELERATION", "MAX_ANGLE", "MAX_RATE", "States", "random_states"]

MAX_ANGLE = float(np.pi)  # [rad]
MAX_RATE = 3.2  # [rad/s], the UR5's fastest joints
MAX_ACCELERATION = 10.0  # [rad/s²]


@dataclass(frozen=True, eq=False)
class States:
    """N states of n joints.

    Parameters
    ----------
    q, qd, qdd : array-like, shape (N, n)
        Positions [rad], velocities [rad/s] and accelerations [rad/s²]; [m], [m/s], [m/s²] for a
        prismatic joint.

    Raises
    ------
    StateError
        For arrays that are not two-dimensional, not of one shape, or hold no numbers.

    Examples
    --------
    >>> from ur5check import States
    >>> len(States(q=[[0.0, 1.0]], qd=[[0.0, 0.0]], qdd=[[0.0, 0.0]]))
    1
    """

    q: Array
    qd: Array
    qdd: Array

    def __post_init__(self) -> None:
        for name in ("q", "qd", "qdd"):
            array = np.asarray(number_array(name, getattr(self, name)), dtype=np.float64)
            object.__setattr__(self, name, array)
        shapes = {self.q.shape, self.qd.shape, self.qdd.shape}
        if len(shapes) > 1 or self.q.ndim != 2:
            raise StateError(
                f"q, qd and qdd have shapes {self.q.shape}, {self.qd.shape} and {self.qdd.shape}; "
                "give three arrays of one shape (N, n)"
            )

    def __len__(self) -> int:
        return len(self.q)

    def __getitem__(self, index: int) -> dict[str, list[float]]:
        """State number `index` as lists of floats."""
        return {
            "q": self.q[index].tolist(),
            "qd": self.qd[index].tolist(),
            "qdd": self.qdd[index].tolist(),
        }


def random_states(n: int, count: int, seed: int) -> States:
    """Random joint states, uniform in |q| ≤ π rad, |q̇| ≤ 3.2 rad/s, |q̈| ≤ 10 rad/s².

    Joint limits are ignored on purpose: the laws of dynamics hold beyond them, and two models are
    compared over the whole range of their joints.

    Parameters
    ----------
    n : int
        Number of joints.
    count : int
        Number of states, at least 1.
    seed : int
        Seed of NumPy's default generator, not negative; the same seed gives the same states.

    Returns
    -------
    States

    Raises
    ------
    UsageError
        For numbers that are not whole, a count or n below 1, or a negative seed.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.random_states(6, 100, seed=0).q.shape
    (100, 6)
    """
    n, count = integer("n", n, least=1), integer("samples", count, least=1)
    rng = np.random.default_rng(integer("seed", seed, least=0))
    return States(
        *(
            rng.uniform(-bound, bound, (count, n))
            for bound in (MAX_ANGLE, MAX_RATE, MAX_ACCELERATION)
        )
    )
