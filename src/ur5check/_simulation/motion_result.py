"""The motion of an arm, and its energy balance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._dynamics.equations import kinetic_energy, potential_energy
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["EnergyBalance", "Motion", "energy_balance"]


@dataclass(frozen=True, eq=False)
class Motion:
    """An arm at K instants.

    t : shape (K,) [s], from 0
    q, qd : shape (K, n) [rad], [rad/s]
    tau : the applied joint torques, shape (K, n) [N m]
    work : of those torques since t = 0, shape (K,) [J]
    stopped : whether it ended at a joint's limit
    """

    t: Array
    q: Array
    qd: Array
    tau: Array
    work: Array
    stopped: bool = False


@dataclass(frozen=True, eq=False)
class EnergyBalance:
    """T + U of the rigid bodies against the work of the torques.

    total : T + U − (T + U at t = 0), shape (K,) [J]
    work : of the torques, shape (K,) [J]
    turned_over : the largest of |ΔT|, |ΔU| and |work| during the motion [J]: the scale of an error
    """

    total: Array
    work: Array
    turned_over: float

    @property
    def error(self) -> Array:
        """Energy error of the integrator, shape (K,) [J]."""
        return np.asarray(self.total - self.work)

    @property
    def worst(self) -> float:
        """The largest error during the motion [J]."""
        return float(np.abs(self.error).max())

    @property
    def relative(self) -> float:
        """The largest error relative to `turned_over`; 0 for an arm at rest."""
        return self.worst / self.turned_over if self.turned_over > 0.0 else 0.0


def energy_balance(arm: SerialArm, motion: Motion) -> EnergyBalance:
    """The balance of a motion, by the arm's own energies.

    Both energies come from velocities and heights (`_dynamics.equations`), not from the mass matrix
    and the torques that moved the arm: two different calculations.
    """
    kinetic = kinetic_energy(arm, motion.q, motion.qd)
    potential = potential_energy(arm, motion.q)
    changes = (kinetic - kinetic[0], potential - potential[0], motion.work)
    return EnergyBalance(
        total=changes[0] + changes[1],
        work=motion.work,
        turned_over=max(float(np.abs(change).max()) for change in changes),
    )
