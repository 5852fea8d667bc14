"""The torque difference by the tool's position: a grid of its radius and height.

Radius is the distance from the z axis of the base frame, height the z coordinate.  A tool outside
the grid is counted in the cell at the edge.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._dynamics.batching import JointState, evaluate
from .._dynamics.chain_constants import chain_of
from .._dynamics.vectors import ZERO, Scalar, Vector
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["HEIGHTS", "RADII", "ReachGrid", "reach_grid", "tool_position"]

RADII, HEIGHTS = 24, 48  # cells outwards and upwards, each a square


@dataclass(frozen=True)
class ReachGrid:
    """Cells of radius 0 … reach and height −reach … reach [m]; numbered radius by radius."""

    reach: float

    @property
    def cells(self) -> int:
        return RADII * HEIGHTS

    def radii(self) -> Array:
        """Edges, shape (RADII + 1,) [m]."""
        return np.linspace(0.0, self.reach, RADII + 1)

    def heights(self) -> Array:
        """Edges, shape (HEIGHTS + 1,) [m]."""
        return np.linspace(-self.reach, self.reach, HEIGHTS + 1)

    def cell(self, p: Array) -> NDArray[np.intp]:
        """The cell of each tool position, shape (N, 3) [m]."""
        scale = RADII / self.reach
        column = (np.hypot(p[:, 0], p[:, 1]) * scale).astype(np.intp)
        row = ((p[:, 2] + self.reach) * scale).astype(np.intp)
        return np.minimum(column, RADII - 1) * HEIGHTS + np.clip(row, 0, HEIGHTS - 1)


def reach_grid(arm: SerialArm, extent: Array) -> ReachGrid:
    """A grid that contains the whole workspace.

    extent : largest |q| of each joint, shape (n,); used for prismatic joints only [m]
    """
    lengths = [float(np.linalg.norm(arm.base.p))]
    for joint, link, far in zip(arm.joints, arm.links, extent, strict=True):
        lengths.append(float(np.linalg.norm(link.link_tip_frame.p)))
        lengths.append(float(far) if joint.kind == "prismatic" else 0.0)
    reach = sum(lengths)
    return ReachGrid(reach if reach > 0.0 else 1.0)


def tool_position(arm: SerialArm, q: Array) -> NDArray[Any]:
    """Origin of the tool frame in the base frame, shape (N, 3) [m].

    `forward_kinematics` without rotations: one vector, transformed from the tip to the base.
    """
    chain = chain_of(arm)

    def compute(state: JointState) -> list[Scalar]:
        p = ZERO
        for link, q_i, cos, sin in reversed(
            list(zip(chain.links, state.q, state.cos, state.sin, strict=True))
        ):
            p = link.rotation(cos, sin) @ (link.link_vector(q_i) + p)
        tool: Vector = chain.origin + chain.base @ p
        return list(tool)

    return evaluate(arm, compute, (3,), q)
