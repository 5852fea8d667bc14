"""How fast Coulomb friction changes its sign, drive by drive: by trial.

    coulomb tanh(q̇ / v0)

Dry gears change within a thousandth of a radian a second, greased ones within some hundredths.  A
wrong v0 would pass for viscous friction and rotor inertia.  No model is needed: each joint's torque
is fitted by all inertial parameters of the geometry and by its drive, and the v0 that leaves least
is taken.
"""

from __future__ import annotations

import numpy as np

from .._dynamics.regressor import torque_regressor
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .friction import FrictionModel
from .least_squares import UNEXCITED
from .recording import Recording
from .signals import filtered

__all__ = ["transition_speeds"]

#: Tried [rad/s or m/s]; the transition's own column interpolates between them.
_TRIED = (0.0025, 0.005, 0.01, 0.02, 0.04)

#: Samples of the recording, and of its filtered signals, that are tried on.
_ROWS, _SAMPLES = 60_000, 3_000


def transition_speeds(
    arm: SerialArm,
    recording: Recording,
    cutoff: float,
    friction: FrictionModel,
    *,
    velocity_from_position: bool,
) -> Array:
    """v0 of each joint, shape (n,) [rad/s or m/s]."""
    first = recording.selected(np.arange(recording.count) < _ROWS)
    left = []
    bases: list[Array] = []
    for v0 in _TRIED:
        signals = filtered(
            first, cutoff, friction, v0=v0, velocity_from_position=velocity_from_position
        )
        s = signals.selected(slice(None, None, -(-signals.count // _SAMPLES)))
        if not bases:
            Y = torque_regressor(arm, s.q, s.qd, s.qdd)
            bases = [_basis(np.column_stack([Y[:, j], s.qdd[:, j]])) for j in range(arm.n)]
        left.append([_left(Q, s.drive[:, j, :-1], s.tau[:, j]) for j, Q in enumerate(bases)])
    return np.asarray(np.array(_TRIED)[np.argmin(left, axis=0)])


def _basis(columns: Array) -> Array:
    scale = np.linalg.norm(columns, axis=0)
    U, s, _ = np.linalg.svd(columns / np.where(scale > 0.0, scale, 1.0), full_matrices=False)
    return np.asarray(U[:, s > UNEXCITED * s[0]])


def _left(Q: Array, columns: Array, tau: Array) -> float:
    """Sum of squares of tau that neither Q nor the columns explain."""
    X, y = (a - Q @ (Q.T @ a) for a in (columns, tau))
    return float(((y - X @ np.linalg.lstsq(X, y, rcond=None)[0]) ** 2).sum())
