"""How far apart two arms are as they move: tool poses and joint torques over many states."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._dynamics.kinematics import forward_kinematics
from .._robot.states import States
from .._robot.transforms import Array
from .arm_pair import Pair

__all__ = ["ToolError", "TorqueError", "compare_tools", "compare_torques", "tool_errors"]


@dataclass(frozen=True, eq=False)
class ToolError:
    """Largest distance and angle between the tools of two arms.

    When the axes coincide but the tool frames are two different ones, the constant pose between
    them is taken out first.

    Attributes
    ----------
    position : float
        [m]
    angle : float
        [rad]
    worst : int
        Index of the state with the largest distance.
    """

    position: float
    angle: float
    worst: int


@dataclass(frozen=True, eq=False)
class TorqueError:
    """Δτ = τ_a − τ_b over N states, per joint.

    Attributes
    ----------
    rms, maximum : ndarray, shape (n,)
        Root mean square and largest |Δτ| [N m].
    worst : ndarray, shape (n,)
        Index of the state of the maximum.
    scale : ndarray, shape (n,)
        RMS of arm a's own torque [N m], to judge a difference by.
    effort : ndarray, shape (n,)
        Effort limits [N m], see `Pair.effort_limits`.
    """

    rms: Array
    maximum: Array
    worst: Array
    scale: Array
    effort: Array

    def share_of_effort(self) -> Array:
        """The maximum as a share of the effort limit.

        Returns
        -------
        ndarray, shape (n,)
            nan where there is no limit.
        """
        return np.asarray(self.maximum / self.effort)


def tool_errors(T_a: Array, T_b: Array) -> tuple[Array, Array]:
    """Distance [m] and angle [rad] between poses of shape (..., 4, 4), each of shape (...)."""
    R = np.swapaxes(T_a[..., :3, :3], -1, -2) @ T_b[..., :3, :3]
    twice_sine = np.sqrt(
        (R[..., 2, 1] - R[..., 1, 2]) ** 2
        + (R[..., 0, 2] - R[..., 2, 0]) ** 2
        + (R[..., 1, 0] - R[..., 0, 1]) ** 2
    )
    angle = np.arctan2(twice_sine, np.trace(R, axis1=-2, axis2=-1) - 1.0)
    distance = np.linalg.norm(T_a[..., :3, 3] - T_b[..., :3, 3], axis=-1)
    return np.asarray(distance), np.asarray(angle)


def compare_tools(pair: Pair, states: States) -> ToolError:
    """The tools of both arms at every state."""
    T_a, T_b = forward_kinematics(pair.a, states.q), forward_kinematics(pair.b, states.q)
    if pair.alignment.exact:
        T_a = T_a @ pair.alignment.tool.matrix()
    position, angle = tool_errors(T_a, T_b)
    return ToolError(float(position.max()), float(angle.max()), int(position.argmax()))


def compare_torques(pair: Pair, delta: Array, tau_a: Array) -> TorqueError:
    """Statistics of a torque difference, shape (N, n) [N m]."""
    size = np.abs(delta)
    return TorqueError(
        rms=np.sqrt((delta**2).mean(axis=0)),
        maximum=size.max(axis=0),
        worst=size.argmax(axis=0),
        scale=np.sqrt((tau_a**2).mean(axis=0)),
        effort=pair.effort_limits,
    )
