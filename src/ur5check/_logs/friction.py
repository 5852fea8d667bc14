"""Friction and rotor inertia: what a joint's drive adds to the torque of the links.

    τ_drive = viscous q̇ + coulomb tanh(u) + offset + transition u / cosh²(u) + rotor q̈,  u = q̇ / v0

linear in its coefficients, which are each joint's own (Khalil & Dombre, Modeling, Identification
and Control of Robots, 2002, ch. 9; Swevers et al., IEEE Control Systems 27(5), 2007).  How fast
Coulomb friction changes its sign is a drive's own too: the transition is the derivative of tanh(u)
by v0.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._robot.transforms import Array

__all__ = ["USUAL_V0", "FrictionModel"]

#: The usual v0 [rad/s or m/s]: below it Coulomb friction goes through zero gradually, as any
#: measured velocity does.
USUAL_V0 = 0.02

#: Stribeck's velocity [rad/s or m/s]: above it the excess of static friction has faded.
_STRIBECK = 0.1


@dataclass(frozen=True)
class FrictionModel:
    """Which terms a drive has.

    Attributes
    ----------
    stribeck : bool
        Whether friction is larger at low speed.
    asymmetric : bool
        Whether each direction has Coulomb friction of its own.
    """

    stribeck: bool = False
    asymmetric: bool = False

    @property
    def names(self) -> tuple[str, ...]:
        """Of the coefficients, the rotor inertia last."""
        return (*self.usual_names, "transition", "rotor")

    @property
    def usual_names(self) -> tuple[str, ...]:
        """The first of them: friction alone, with the same transition for all drives."""
        coulomb = ("coulomb+", "coulomb-") if self.asymmetric else ("coulomb",)
        return ("viscous", *coulomb, *(("stribeck",) if self.stribeck else ()), "offset")

    def columns(self, qd: Array, qdd: Array, v0: Array | float = USUAL_V0) -> Array:
        """What each coefficient is multiplied with.

        Parameters
        ----------
        qd : ndarray, shape (…)
            Velocities [rad/s or m/s].
        qdd : ndarray, shape (…)
            Accelerations [rad/s² or m/s²].
        v0 : float or ndarray that broadcasts with qd
            Below it Coulomb friction changes its sign gradually [rad/s or m/s].

        Returns
        -------
        ndarray, shape (…, len(names))
            In the order of `names`.
        """
        direction = np.tanh(qd / v0)
        transition = qd / v0 * (1.0 - direction**2)
        columns = [qd]
        if self.asymmetric:
            # Their mean is the offset's column, which is left to the offset.
            columns += [np.maximum(direction, 0.0), np.minimum(direction, 0.0)]
        else:
            columns.append(direction)
        if self.stribeck:
            columns.append(np.exp(-((qd / _STRIBECK) ** 2)) * direction)
        return np.stack([*columns, np.ones_like(qd), transition, qdd], axis=-1)
