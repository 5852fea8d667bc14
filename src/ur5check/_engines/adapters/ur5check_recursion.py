"""The hand-written recursion behind the `Engine` protocol: the reference of every comparison.

Beyond the protocol it gives the two energies, and takes complex states: the laws need both.  It
moves an arm in time by SciPy's DOP853.
"""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..._dynamics import equations, kinematics, regressor
from ..._dynamics import recursion as newton_euler
from ..._dynamics.batching import gravity_of
from ..._robot.robot_tree import ArmOrTree, RobotTree
from ..._version import __version__
from ..engine_entry import EngineEntry
from ..imported_model import ImportedModel, strict_imported_model

__all__ = ["ENTRY", "RecursionEngine"]

Numbers = NDArray[Any]

_ANY_ERROR = 1e9  # a tolerance that no step of an arm exceeds: the step stays as it is given


class RecursionEngine:
    """The recursion of `_dynamics` on one arm or robot: a `ReferenceEngine`, on complex states too,
    and a `Stepper`.

    arm : an arm or a tree;  gravity : in its base frame [m/s²], its own when None.
    """

    name = "ur5check"
    version = __version__
    integrators: ClassVar[dict[str, int]] = {"DOP853": 8}

    def __init__(self, arm: ArmOrTree, gravity: ArrayLike | None = None) -> None:
        self.arm = arm
        self.route = type(arm).__name__
        self.gravity = gravity_of(arm, gravity)

    def forward_kinematics(self, q: Numbers) -> Numbers:
        """Pose of the tool, of a tree's last moving link, in the base frame, (..., 4, 4)."""
        if isinstance(self.arm, RobotTree):
            return kinematics.link_frames(self.arm, q)[..., -1, :, :]
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

    def step(
        self, q: Numbers, qd: Numbers, tau: Numbers, dt: float, integrator: str | None = None
    ) -> tuple[Numbers, Numbers]:
        """(q, q̇) after one step of `dt` [s] by DOP853, of order 8."""
        from scipy.integrate import DOP853

        n = self.arm.n
        accelerate = equations.acceleration_of(self.arm, self.gravity)

        def rate(_: float, y: Numbers) -> Numbers:
            return np.concatenate([y[n:], accelerate(y[:n], y[n:], tau)])

        solver = DOP853(
            rate, 0.0, np.concatenate([q, qd]), dt, first_step=dt, max_step=dt,
            rtol=_ANY_ERROR, atol=_ANY_ERROR,
        )  # fmt: skip
        solver.step()
        return np.array(solver.y[:n]), np.array(solver.y[n:])

    def imported_model(self) -> ImportedModel:
        """The arm itself, one body per joint."""
        return strict_imported_model(self.arm)


ENTRY = EngineEntry(key="ur5check", title="ur5check", order=0, make=RecursionEngine)
