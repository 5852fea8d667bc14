"""The joint torques of a simulation: constant, or a function of the state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from .._dynamics.equations import gravity_torque
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["ConstantTorque", "GravityCompensation", "TorqueSource"]


class TorqueSource(Protocol):
    """Joint torques as a function of the state."""

    def __call__(self, q: Array, qd: Array) -> Array:
        """τ, shape (n,) [N m], of a state of shape (n,) each [rad], [rad/s]."""
        ...


@dataclass(frozen=True, eq=False)
class ConstantTorque:
    """Constant torques, shape (n,) [N m], as the paper published them to Gazebo's topics."""

    tau: Array

    def __call__(self, q: Array, qd: Array) -> Array:
        """The constant torques, for any state."""
        return self.tau


@dataclass(frozen=True, eq=False)
class GravityCompensation:
    """Gravity compensation: at every instant the torques that hold `model` at the arm's posture."""

    model: SerialArm

    def __call__(self, q: Array, qd: Array) -> Array:
        """g(q) of the model."""
        return gravity_torque(self.model, q)
