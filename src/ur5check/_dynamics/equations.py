"""M, C, g, T and U: the terms of the equation of motion, from the one recursion.

    τ = M(q) q̈ + C(q, q̇) q̇ + g(q)                                     (paper, eq. 2)

Nothing here knows a formula for a mass matrix: each term is the recursion, asked one question.
The energies are computed from velocities and heights instead, so that the laws that tie them to
the torques (g = ∂U/∂q, d(T+U)/dt = q̇ᵀτ) compare two different calculations.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._errors import StateError
from .._robot.serial_arm import SerialArm
from .batching import JointState, evaluate, gravity_of, joint_array
from .chain_constants import Chain, chain_of
from .kinematics import frames
from .recursion import joint_torques
from .vectors import ZERO, Scalar, Vector

__all__ = [
    "Acceleration",
    "acceleration_of",
    "bias_torque",
    "coriolis_matrix",
    "forward_dynamics",
    "gravity_torque",
    "kinetic_energy",
    "mass_columns",
    "mass_matrix",
    "potential_energy",
]

#: (q, q̇, τ), each of shape (n,), to q̈ [rad/s²].
Acceleration = Callable[[NDArray[Any], NDArray[Any], NDArray[Any]], NDArray[Any]]


def mass_matrix(arm: SerialArm, q: ArrayLike) -> NDArray[Any]:
    """M(q), shape (..., n, n) [kg m²]; q of shape (..., n) [rad], real or complex.

    Column j is the torque of a unit acceleration of joint j, at rest and without gravity:
    M e_j = τ(q, 0, e_j).  Both triangles are computed, so M = Mᵀ is a law that can fail.

    Raises StateError for a q that is not of shape (..., n) and finite.
    """
    chain = chain_of(arm)
    return evaluate(arm, lambda state: _as_rows(mass_columns(chain, state)), (arm.n, arm.n), q)


def coriolis_matrix(arm: SerialArm, q: ArrayLike, qd: ArrayLike) -> NDArray[Any]:
    """C(q, q̇), shape (..., n, n) [N m s], built from Christoffel symbols: Ṁ − 2C is skew.

    The velocity torque h(q̇) = C(q, q̇) q̇ is a quadratic form, h_i(u) = Σ c_ijk u_j u_k with the
    Christoffel symbols c_ijk symmetric in j, k.  Its polarisation is therefore their contraction:
    C e_j = Σ_k c_·jk q̇_k = ¼ [h(q̇ + e_j) − h(q̇ − e_j)], exactly.

    q, qd : array-like, shape (..., n) [rad], [rad/s]; real or complex.
    Raises StateError for arrays that are not of shape (..., n) and finite, or do not broadcast.

    References: Siciliano et al., Robotics (2009), ch. 7 (the symbols and the skewness).
    """
    chain = chain_of(arm)
    return evaluate(
        arm, lambda state: _as_rows(_coriolis_columns(chain, state)), (arm.n, arm.n), q, qd
    )


def gravity_torque(arm: SerialArm, q: ArrayLike, gravity: ArrayLike | None = None) -> NDArray[Any]:
    """g(q), shape (..., n) [N m]: the torque that holds the arm still, τ(q, 0, 0).

    q : array-like, shape (..., n) [rad];  gravity : shape (3,), base frame [m/s²], the arm's own
    when None.  Raises StateError for arrays of another shape, or not finite.
    """
    chain = chain_of(arm)
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))
    return evaluate(arm, lambda state: joint_torques(chain, state, g_0), (arm.n,), q)


def bias_torque(
    arm: SerialArm, q: ArrayLike, qd: ArrayLike, gravity: ArrayLike | None = None
) -> NDArray[Any]:
    """C(q, q̇) q̇ + g(q), shape (..., n) [N m]: the torque of the motion without acceleration."""
    chain = chain_of(arm)
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))
    return evaluate(arm, lambda state: joint_torques(chain, state, g_0), (arm.n,), q, qd)


def forward_dynamics(
    arm: SerialArm,
    q: ArrayLike,
    qd: ArrayLike,
    tau: ArrayLike,
    gravity: ArrayLike | None = None,
) -> NDArray[Any]:
    """q̈ = M⁻¹ (τ − C q̇ − g), shape (..., n) [rad/s²].

    q, qd, tau : array-like, shape (..., n) [rad], [rad/s], [N m];  gravity as in `rnea`.

    Raises StateError for arrays of another shape, or where M cannot be inverted (a link that moves
    nothing: its arm's numbers are wrong).
    """
    M = mass_matrix(arm, q)
    return _solved(arm, M, joint_array(arm, "tau", tau) - bias_torque(arm, q, qd, gravity))


def acceleration_of(arm: SerialArm, gravity: ArrayLike | None = None) -> Acceleration:
    """Forward dynamics prepared for one state at a time, as an integrator calls it.

    `forward_dynamics` runs the recursion n + 1 times, which is best for thousands of states at
    once.  For one state the cost is the number of runs: here n + 1 columns go through a single run,
    five times as fast.

        column 0       τ(q, q̇, 0) under gravity     = C q̇ + g
        column j       τ(q, 0, e_j) without gravity = M e_j

    gravity as in `rnea`.  The function takes q, q̇ and τ of shape (n,) and raises StateError for
    arrays that are not finite or not of this shape, and where M cannot be inverted.
    """
    n, chain = arm.n, chain_of(arm)
    only_first = np.zeros(n + 1)
    only_first[0] = 1.0
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))
    columns_of_gravity = Vector(*(only_first * entry for entry in g_0))
    units = np.vstack([np.zeros(n), np.eye(n)])

    def recursion(state: JointState) -> list[Scalar]:
        return joint_torques(chain, state, columns_of_gravity)

    def acceleration(q: NDArray[Any], qd: NDArray[Any], tau: NDArray[Any]) -> NDArray[Any]:
        columns = evaluate(arm, recursion, (n,), q, only_first[:, None] * qd, units)
        return _solved(arm, columns[1:].T, tau - columns[0])

    return acceleration


def _solved(arm: SerialArm, M: NDArray[Any], torque: NDArray[Any]) -> NDArray[Any]:
    """M⁻¹ τ, shape (..., n)."""
    try:
        return np.linalg.solve(M, torque[..., None])[..., 0]
    except np.linalg.LinAlgError as error:
        raise StateError(
            f"the mass matrix of arm {arm.name!r} is singular: some joint moves no mass; "
            "look at its inertias with `ur5check show`"
        ) from error


def kinetic_energy(arm: SerialArm, q: ArrayLike, qd: ArrayLike) -> NDArray[Any]:
    """T = Σ ½ m_i v_ci² + ½ ω_i · I_i ω_i + ½ armature_i q̇_i², shape (...) [J]; q, qd (..., n).

    From the links' velocities, not from M.  Raises StateError as `rnea` does.
    """
    chain = chain_of(arm)
    return evaluate(arm, lambda state: [_kinetic(chain, state)], (), q, qd)


def potential_energy(
    arm: SerialArm, q: ArrayLike, gravity: ArrayLike | None = None
) -> NDArray[Any]:
    """U = −Σ m_i g · p_ci, shape (...) [J], zero with every centre of mass at the base's origin.

    q of shape (..., n);  gravity as in `rnea`.  Raises StateError as `rnea` does.
    """
    chain, g = chain_of(arm), Vector.of(gravity_of(arm, gravity))

    def compute(state: JointState) -> list[Scalar]:
        moment = ZERO
        for link, frame in zip(chain.links, frames(chain, state), strict=True):
            moment = moment + frame.point(link.c) * link.m
        return [-g.dot(moment)]

    return evaluate(arm, compute, (), q)


def mass_columns(chain: Chain, state: JointState) -> list[list[Scalar]]:
    """M of one block of states, column by column: the torques of each joint's unit acceleration."""
    n = len(chain.links)
    still = [0.0] * n
    units = ([1.0 if i == j else 0.0 for i in range(n)] for j in range(n))
    return [joint_torques(chain, state.with_motion(still, unit), ZERO) for unit in units]


def _coriolis_columns(chain: Chain, state: JointState) -> list[list[Scalar]]:
    n = len(chain.links)
    still = [0.0] * n

    def velocity_torque(j: int, step: float) -> list[Scalar]:
        qd = [rate + step if i == j else rate for i, rate in enumerate(state.qd)]
        return joint_torques(chain, state.with_motion(qd, still), ZERO)

    columns = []
    for j in range(n):
        ahead, behind = velocity_torque(j, 1.0), velocity_torque(j, -1.0)
        columns.append([0.25 * (a - b) for a, b in zip(ahead, behind, strict=True)])
    return columns


def _as_rows(columns: list[list[Scalar]]) -> list[Scalar]:
    """The entries of a matrix given by its columns, row by row."""
    return [entry for row in zip(*columns, strict=True) for entry in row]


def _kinetic(chain: Chain, state: JointState) -> Scalar:
    energy: Scalar = 0.0
    w, v = ZERO, ZERO  # angular velocity, and linear velocity of origin i, both in frame i
    for link, q, cos, sin, qd in zip(
        chain.links, state.q, state.cos, state.sin, state.qd, strict=True
    ):
        R = link.rotation(cos, sin)
        w, v = R.back(w), R.back(v)
        if link.prismatic:
            v = v + link.b * qd
        else:
            w = w + link.b * qd
        r = link.link_vector(q)
        v_c = v + w.cross(r + link.c)
        energy = energy + 0.5 * (link.m * v_c.dot(v_c) + w.dot(link.I @ w))
        energy = energy + 0.5 * link.armature * qd * qd
        v = v + w.cross(r)
    return energy
