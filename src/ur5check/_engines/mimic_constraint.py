"""Mimic joints for engines that move every joint on its own: our constraint on their answers.

Some engines leave a URDF's `<mimic>` out, others turn it into a force of their simulation.  Each is
therefore asked for all N joints, and the linear constraint q_joints = G q + g0 of the tree
(docs/architecture.md, "Tree dynamics") is applied to what it answers: τ = Gᵀ τ_joints and
M = Gᵀ M_joints G.
"""

from __future__ import annotations

import numpy as np

from .._robot.robot_tree import RobotTree
from .._robot.transforms import Array
from .engine import Engine
from .imported_model import ImportedModel

__all__ = ["Constrained"]


class Constrained:
    """An engine with all joints of a tree, answering in the tree's n coordinates.

    engine : made from `tree.unconstrained`
    """

    def __init__(self, engine: Engine, tree: RobotTree) -> None:
        self.engine, self.tree = engine, tree
        self.name, self.version, self.route = engine.name, engine.version, engine.route
        self._G = tree.all_rates(np.eye(tree.n))
        self._g0 = tree.all_joints(np.zeros((tree.n, 1)))[:, 0]

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the last moving link in the base frame, shape (..., 4, 4)."""
        return self.engine.forward_kinematics(self._joints(q))

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Gᵀ τ_joints, shape (..., n)."""
        rates = qd @ self._G.T, qdd @ self._G.T
        return np.asarray(self.engine.inverse_dynamics(self._joints(q), *rates) @ self._G)

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """The accelerations of M q̈ = τ − (C q̇ + g), solved, shape (..., n)."""
        rest = np.asarray(tau) - self.bias_torque(q, qd)
        return np.asarray(np.linalg.solve(self.mass_matrix(q), rest[..., None])[..., 0])

    def mass_matrix(self, q: Array) -> Array:
        """Gᵀ M_joints G, shape (..., n, n)."""
        return np.asarray(self._G.T @ self.engine.mass_matrix(self._joints(q)) @ self._G)

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """Gᵀ (C q̇ + g)_joints, shape (..., n); G is constant, so nothing is added."""
        return np.asarray(self.engine.bias_torque(self._joints(q), qd @ self._G.T) @ self._G)

    def gravity_torque(self, q: Array) -> Array:
        """Gᵀ g_joints, shape (..., n)."""
        return np.asarray(self.engine.gravity_torque(self._joints(q)) @ self._G)

    def imported_model(self) -> ImportedModel:
        """What the engine imported: all joints."""
        return self.engine.imported_model()

    def _joints(self, q: Array) -> Array:
        return np.asarray(q @ self._G.T + self._g0)
