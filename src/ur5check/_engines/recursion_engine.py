"""The hand-written dynamics behind the same counter as the reference engines.

What can be asked of an `Engine` can be asked of our own side, so that a check, a parity table or a
simulation takes either.  It answers three questions more, which the laws need: the two energies,
and anything at all on complex numbers.
"""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike, NDArray

from .._dynamics import equations, kinematics, regressor
from .._dynamics import recursion as newton_euler
from .._dynamics.batching import gravity_of
from .._robot.serial_arm import SerialArm
from .._version import __version__
from .imported_model import ImportedModel, strict_imported_model

__all__ = ["RecursionEngine"]

Numbers = NDArray[Any]


class RecursionEngine:
    """The recursion of `dynamics` on one arm; satisfies `engine.ReferenceEngine`, on complex states
    too.

    arm : the arm;  gravity : in its base frame [m/s²], the arm's own when None.
    """

    name = "ur5check"
    version = __version__
    route = "SerialArm"

    def __init__(self, arm: SerialArm, gravity: ArrayLike | None = None) -> None:
        self.arm = arm
        self.gravity = gravity_of(arm, gravity)

    def forward_kinematics(self, q: Numbers) -> Numbers:
        """Pose of the tool in the base frame, shape (..., 4, 4)."""
        return kinematics.forward_kinematics(self.arm, q)

    def inverse_dynamics(self, q: Numbers, qd: Numbers, qdd: Numbers) -> Numbers:
        """Joint torques, shape (..., n) [N m]."""
        return newton_euler.rnea(self.arm, q, qd, qdd, self.gravity)

    def forward_dynamics(self, q: Numbers, qd: Numbers, tau: Numbers) -> Numbers:
        """Joint accelerations, shape (..., n) [rad/s²]."""
        return equations.forward_dynamics(self.arm, q, qd, tau, self.gravity)

    def mass_matrix(self, q: Numbers) -> Numbers:
        """M(q), shape (..., n, n) [kg m²]."""
        return equations.mass_matrix(self.arm, q)

    def coriolis_matrix(self, q: Numbers, qd: Numbers) -> Numbers:
        """C(q, q̇), shape (..., n, n) [N m s]."""
        return equations.coriolis_matrix(self.arm, q, qd)

    def bias_torque(self, q: Numbers, qd: Numbers) -> Numbers:
        """C q̇ + g, shape (..., n) [N m]."""
        return equations.bias_torque(self.arm, q, qd, self.gravity)

    def gravity_torque(self, q: Numbers) -> Numbers:
        """g(q), shape (..., n) [N m]."""
        return equations.gravity_torque(self.arm, q, self.gravity)

    def torque_regressor(self, q: Numbers, qd: Numbers, qdd: Numbers) -> Numbers:
        """Y, shape (..., n, 10 n)."""
        return regressor.torque_regressor(self.arm, q, qd, qdd, self.gravity)

    def kinetic_energy(self, q: Numbers, qd: Numbers) -> Numbers:
        """T, shape (...) [J]."""
        return equations.kinetic_energy(self.arm, q, qd)

    def potential_energy(self, q: Numbers) -> Numbers:
        """U, shape (...) [J]."""
        return equations.potential_energy(self.arm, q, self.gravity)

    def imported_model(self) -> ImportedModel:
        """Our own reading, in the words that engines use of theirs."""
        return strict_imported_model(self.arm)
