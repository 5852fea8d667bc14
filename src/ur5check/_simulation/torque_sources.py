"""Where the torques come from that an arm is given while it moves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from .._dynamics.equations import gravity_torque
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["Held", "Recomputed", "TorqueSource"]


class TorqueSource(Protocol):
    """Torques at an instant."""

    def __call__(self, q: Array, qd: Array) -> Array:
        """τ, shape (n,) [N m], of a state of shape (n,) each [rad], [rad/s]."""
        ...


@dataclass(frozen=True, eq=False)
class Held:
    """One torque for all time, shape (n,) [N m]: what the paper published to Gazebo's topics."""

    tau: Array

    def __call__(self, q: Array, qd: Array) -> Array:
        """The same, wherever the arm has got to."""
        return self.tau


@dataclass(frozen=True, eq=False)
class Recomputed:
    """Gravity compensation: at every instant, what `model` needs to rest where the arm is now."""

    model: SerialArm

    def __call__(self, q: Array, qd: Array) -> Array:
        """g(q) of the model."""
        return gravity_torque(self.model, q)
