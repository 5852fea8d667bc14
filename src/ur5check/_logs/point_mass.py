"""A point mass in one frame, from torques: mass and centre, of either sign of the mass.

Its ten parameters are m, m c and m (c·c 1 − c cᵀ): the first four are linear, the tensor follows by
iteration.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._robot.transforms import Array
from .least_squares import fit

__all__ = ["PointMass", "point_mass"]

_ROUNDS = 5  # the tensor is small beside m c: each gains two digits or more


@dataclass(frozen=True, eq=False)
class PointMass:
    """Mass [kg] and centre [m] in `value`, shape (4,); 95 % interval value ± half_width.

    residual : what is left, as given
    """

    value: Array
    half_width: Array
    residual: Array


def point_mass(Y: Array, residual: Array, blocks: NDArray[np.int64]) -> PointMass:
    """Fit one.

    Y : the ten columns of the body's regressor, shape (rows, 10);  residual : shape (rows,)
    blocks : of the rows
    """
    tensor = np.zeros(6)
    for _ in range(_ROUNDS):
        found = fit(Y[:, :4], residual - Y[:, 4:] @ tensor, blocks)
        mass, moment = found.value[0], found.value[1:]
        if abs(mass) < 1e-9:
            return PointMass(np.zeros(4), np.full(4, np.nan), found.residual)
        c = moment / mass
        full = mass * (c @ c * np.eye(3) - np.outer(c, c))
        tensor = np.array([full[0, 0], full[0, 1], full[1, 1], full[0, 2], full[1, 2], full[2, 2]])
    # c = (m c) / m: its variance by the derivative of the quotient.
    J = np.column_stack([-c, np.eye(3)]) / mass
    spread = found.quantile * np.sqrt(np.diag(J @ found.covariance @ J.T))
    return PointMass(np.array([mass, *c]), np.array([found.half_width[0], *spread]), found.residual)
