"""The cylinder behind a tensor: nearly every published link is one.

A solid cylinder of mass m, radius r and length l has I_axis = ½ m r² along its axis and
I_across = m (3 r² + l²) / 12 across it, about its middle (the paper's eqs 5–8).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._robot.transforms import Array

__all__ = ["Cylinder", "fit_cylinder"]

#: Two moments are equal, and products zero, to four printed digits.
_EQUAL = 1e-4


@dataclass(frozen=True)
class Cylinder:
    """A solid cylinder along coordinate axis `axis` (0, 1, 2), `radius` and `length` in [m]."""

    axis: int
    radius: float
    length: float

    def tensor(self, mass: float) -> Array:
        """Its inertia about its middle [kg m²]."""
        across = mass * (3.0 * self.radius**2 + self.length**2) / 12.0
        moments = np.full(3, across)
        moments[self.axis] = mass * self.radius**2 / 2.0
        return np.diag(moments)


def fit_cylinder(mass: float, tensor: Array) -> Cylinder | None:
    """The solid cylinder with this mass and tensor, if there is one."""
    moments = np.diag(tensor)
    size = float(np.abs(tensor).max())
    if mass <= 0.0 or size == 0.0 or np.abs(tensor - np.diag(moments)).max() > _EQUAL * size:
        return None
    for axis in (2, 0, 1):
        one, other = np.delete(moments, axis)
        if abs(one - other) > _EQUAL * size:
            continue
        radius_squared = 2.0 * moments[axis] / mass
        length_squared = 6.0 * (one + other) / mass - 3.0 * radius_squared
        if radius_squared > 0.0 and length_squared > 0.0:
            return Cylinder(axis, float(np.sqrt(radius_squared)), float(np.sqrt(length_squared)))
    return None
