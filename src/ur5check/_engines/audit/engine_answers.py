"""What an engine answers at given states, and how far apart two engines' answers lie."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._robot.states import States
from ..._robot.transforms import Array
from ..engine import Engine

__all__ = ["Answers", "Parity", "ask", "hold_against"]


@dataclass(frozen=True, eq=False)
class Answers:
    """An engine's answers at N states of n joints.

    torque : τ(q, q̇, q̈), shape (N, n) [N m];  mass : M, shape (N, n, n) [kg m²]
    bias : C q̇ + g, shape (N, n) [N m]
    acceleration : q̈ under torques that all engines are given, shape (N, n) [rad/s²]
    tool : its place, shape (N, 3) [m]
    """

    key: str
    torque: Array
    mass: Array
    bias: Array
    acceleration: Array
    tool: Array


@dataclass(frozen=True)
class Parity:
    """How far apart engines `a` and `b` are: the worst over states and joints of each answer.

    torque, bias [N m], mass [kg m²], tool [m]
    acceleration : of the largest acceleration at the same state, since M⁻¹ makes large ones of
        small torques
    joint, state : index of the joint and number of the state of the worst torque
    """

    a: str
    b: str
    torque: float
    mass: float
    bias: float
    acceleration: float
    tool: float
    joint: int
    state: int


def ask(key: str, engine: Engine, states: States, tau: Array) -> Answers:
    """Put the same five questions to an engine; `tau`, shape (N, n), is what moves the arm."""
    q, qd, qdd = states.q, states.qd, states.qdd
    return Answers(
        key,
        np.asarray(engine.inverse_dynamics(q, qd, qdd)),
        np.asarray(engine.mass_matrix(q)),
        np.asarray(engine.bias_torque(q, qd)),
        np.asarray(engine.forward_dynamics(q, qd, tau)),
        np.asarray(engine.forward_kinematics(q))[:, :3, 3],
    )


def hold_against(a: Answers, b: Answers) -> Parity:
    """The parity of two engines that were asked the same.

    What is no number (an engine that broke down at a state) counts as infinitely far.
    """
    gap = _gap(a.torque, b.torque)
    state, joint = np.unravel_index(int(gap.argmax()), gap.shape)
    size = np.maximum(np.abs(a.acceleration), np.abs(b.acceleration)).max(axis=1)
    accelerations = _gap(a.acceleration, b.acceleration).max(axis=1)
    relative = np.divide(accelerations, size, out=np.zeros_like(size), where=size > 0.0)
    return Parity(
        a.key,
        b.key,
        float(gap[state, joint]),
        float(_gap(a.mass, b.mass).max()),
        float(_gap(a.bias, b.bias).max()),
        float(np.nan_to_num(relative, nan=np.inf).max()),
        float(_gap(a.tool, b.tool).max()),
        int(joint),
        int(state),
    )


def _gap(a: Array, b: Array) -> Array:
    return np.asarray(np.nan_to_num(np.abs(a - b), nan=np.inf))
