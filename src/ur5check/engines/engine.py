"""What a referee can be asked.

All arrays are shape (..., n) in the joint order of the arm that the referee was made for; gravity
is in that arm's base frame and is fixed when the referee is made.
"""

from __future__ import annotations

from typing import Protocol

from ..arm.transforms import Array

__all__ = ["Engine"]


class Engine(Protocol):
    """Another implementation of rigid-body dynamics, holding one arm."""

    name: str
    version: str
    #: how the model reached the engine: "URDF text, own parser", "SerialArm", "pin.Model"
    route: str

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool in the base frame, shape (..., 4, 4)."""
        ...

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Joint torques, shape (..., n) [N m]."""
        ...

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Joint accelerations, shape (..., n) [rad/s²]."""
        ...

    def mass_matrix(self, q: Array) -> Array:
        """M(q), shape (..., n, n) [kg m²]."""
        ...

    def coriolis_matrix(self, q: Array, qd: Array) -> Array:
        """A C(q, q̇) with C q̇ the velocity torque, shape (..., n, n) [N m s]."""
        ...

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """C q̇ + g, shape (..., n) [N m]."""
        ...

    def gravity_torque(self, q: Array) -> Array:
        """g(q), shape (..., n) [N m]."""
        ...

    def torque_regressor(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Y, shape (..., n, 10 n), with the arm's parameters held in the arm's link frames."""
        ...
