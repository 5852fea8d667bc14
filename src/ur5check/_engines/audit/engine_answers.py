"""An engine's answers at given states, and the difference between two engines' answers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._errors import StateError
from ..._robot.states import States
from ..._robot.transforms import Array
from ..engine import Engine

__all__ = ["AnswerDifference", "Answers", "answer_difference", "answers_of"]


@dataclass(frozen=True, eq=False)
class Answers:
    """An engine's answers at N states of n joints.

    torque : τ(q, q̇, q̈), shape (N, n) [N m];  mass : M, shape (N, n, n) [kg m²]
    bias : C q̇ + g, shape (N, n) [N m]
    acceleration : q̈ under the same torques for all engines, shape (N, n) [rad/s²]; nan where the
        mass matrix has no inverse
    tool : its position, shape (N, 3) [m]
    """

    key: str
    torque: Array
    mass: Array
    bias: Array
    acceleration: Array
    tool: Array


@dataclass(frozen=True)
class AnswerDifference:
    """Differences between engines `a` and `b`: the largest over states and joints of each answer.

    torque, bias [N m], mass [kg m²], tool [m]
    acceleration : relative to the largest acceleration at the same state, since M⁻¹ amplifies
        small torques
    joint, state : index of the joint and number of the state with the largest torque difference
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


def answers_of(key: str, engine: Engine, states: States, tau: Array) -> Answers:
    """The five answers of an engine; `tau`, shape (N, n), are the torques for accelerations."""
    q, qd, qdd = states.q, states.qd, states.qdd
    return Answers(
        key,
        np.asarray(engine.inverse_dynamics(q, qd, qdd)),
        np.asarray(engine.mass_matrix(q)),
        np.asarray(engine.bias_torque(q, qd)),
        _accelerations(engine, states, tau),
        np.asarray(engine.forward_kinematics(q))[:, :3, 3],
    )


def _accelerations(engine: Engine, states: States, tau: Array) -> Array:
    try:
        return np.asarray(engine.forward_dynamics(states.q, states.qd, tau))
    except (StateError, np.linalg.LinAlgError):
        return np.full_like(tau, np.nan)


def answer_difference(a: Answers, b: Answers) -> AnswerDifference:
    """The difference of two engines' answers at the same states.

    A value that is not a number (an engine that failed at a state) counts as infinite.
    """
    gap = _gap(a.torque, b.torque)
    state, joint = np.unravel_index(int(gap.argmax()), gap.shape)
    size = np.maximum(np.abs(a.acceleration), np.abs(b.acceleration)).max(axis=1)
    accelerations = _gap(a.acceleration, b.acceleration).max(axis=1)
    relative = np.divide(accelerations, size, out=np.zeros_like(size), where=size > 0.0)
    return AnswerDifference(
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
