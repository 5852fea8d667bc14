"""q̈ of one state, from one sweep of the recursion: M's columns and C q̇ + g side by side.

`_dynamics.equations.forward_dynamics` runs the recursion n + 1 times, which is best for thousands
of states at once.  An integrator asks for one state after the other, where the cost is the number
of sweeps: here n + 1 columns go through a single one, five times as fast.

    column 0       τ(q, q̇, 0) under gravity     = C q̇ + g
    column j       τ(q, 0, e_j) without gravity = M e_j
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .._dynamics.batching import JointState, evaluate
from .._dynamics.chain_constants import chain_of
from .._dynamics.recursion import joint_torques
from .._dynamics.vectors import Scalar, Vector
from .._errors import StateError
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["Acceleration", "acceleration_of"]

#: (q, q̇, τ), each of shape (n,), to q̈ [rad/s²].
Acceleration = Callable[[Array, Array, Array], Array]


def acceleration_of(arm: SerialArm) -> Acceleration:
    """Forward dynamics of `arm` under its own gravity, for one state at a time.

    The function raises StateError for arrays that are not finite or not of shape (n,), and where M
    cannot be inverted.
    """
    n, chain = arm.n, chain_of(arm)
    only_first = np.zeros(n + 1)
    only_first[0] = 1.0
    gravity = Vector(*(only_first * entry for entry in chain.inner_gravity(arm.gravity)))
    units = np.vstack([np.zeros(n), np.eye(n)])

    def sweep(state: JointState) -> list[Scalar]:
        return joint_torques(chain, state, gravity)

    def acceleration(q: Array, qd: Array, tau: Array) -> Array:
        rates = only_first[:, None] * qd
        columns = evaluate(arm, sweep, (n,), q, rates, units)
        try:
            return np.asarray(np.linalg.solve(columns[1:].T, tau - columns[0]))
        except np.linalg.LinAlgError as error:
            raise StateError(
                f"the mass matrix of arm {arm.name!r} is singular: some joint moves no mass; "
                "look at its inertias with `ur5check show`"
            ) from error

    return acceleration
