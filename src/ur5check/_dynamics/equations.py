"""M, C, g, T and U: the terms of the equation of motion.

    τ = M(q) q̈ + C(q, q̇) q̇ + g(q)                                     (paper, eq. 2)

M, C and g are evaluations of the Newton–Euler recursion at special motions.  The energies are
computed from velocities and positions instead, so that the laws that relate them to the torques
(g = ∂U/∂q, d(T+U)/dt = q̇ᵀτ) compare two different calculations.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._errors import StateError
from .._robot.as_arm import ModelSource, as_arm_or_tree
from .._robot.robot_tree import RobotTree
from .._robot.serial_arm import SerialArm
from .batching import JointState, evaluate, gravity_of, joint_array
from .chain_constants import Chain, chain_of
from .kinematics import frames
from .recursion import joint_torques, require_rest
from .vectors import ZERO, Scalar, Vector, plus

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


def mass_matrix(arm: ModelSource, q: ArrayLike) -> NDArray[Any]:
    """Mass matrix M(q) of the joint space.

    Column j is the torque of a unit acceleration of joint j, at rest and without gravity:
    M e_j = τ(q, 0, e_j).  Both triangles are computed, so that M = Mᵀ can be tested.

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q : array-like, shape (..., n)
        Joint positions [rad], or [m] for a prismatic joint; real or complex.

    Returns
    -------
    M : ndarray, shape (..., n, n)
        [kg m²]

    Raises
    ------
    InputError
        For an arm that cannot be read, or arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers.

    Examples
    --------
    >>> import ur5check
    >>> M = ur5check.mass_matrix("paper", [0.0] * 6)
    >>> bool(abs(M - M.T).max() < 1e-14)
    True
    """
    arm = _with_tensors(arm, "the mass matrix")
    chain = chain_of(arm)
    return evaluate(arm, lambda state: _as_rows(mass_columns(chain, state)), (arm.n, arm.n), q)


def coriolis_matrix(arm: ModelSource, q: ArrayLike, qd: ArrayLike) -> NDArray[Any]:
    """Coriolis matrix C(q, q̇) of Christoffel symbols, for which Ṁ − 2C is skew-symmetric.

    The Coriolis and centrifugal torque h(q̇) = C(q, q̇) q̇ is a quadratic form,
    h_i(u) = Σ c_ijk u_j u_k with the Christoffel symbols c_ijk symmetric in j and k, so that
    C e_j = Σ_k c_·jk q̇_k = ¼ [h(q̇ + e_j) − h(q̇ − e_j)] exactly (polarisation).

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q, qd : array-like, shape (..., n)
        Joint positions [rad] and velocities [rad/s] ([m] and [m/s] for a prismatic joint); real or
        complex; leading axes broadcast.

    Returns
    -------
    C : ndarray, shape (..., n, n)
        [N m s]

    Raises
    ------
    InputError
        For an arm that cannot be read, or arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers.

    References
    ----------
    Siciliano et al., Robotics: Modelling, Planning and Control, 2009, ch. 7.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.coriolis_matrix("paper", [0.0] * 6, [0.1] * 6).shape
    (6, 6)
    """
    arm = _with_tensors(arm, "the Coriolis matrix")
    chain = chain_of(arm)
    return evaluate(
        arm, lambda state: _as_rows(_coriolis_columns(chain, state)), (arm.n, arm.n), q, qd
    )


def gravity_torque(
    arm: ModelSource, q: ArrayLike, gravity: ArrayLike | None = None
) -> NDArray[Any]:
    """Gravity torque g(q) = τ(q, 0, 0): the torque that holds the arm at rest.

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q : array-like, shape (..., n)
        Joint positions [rad], or [m] for a prismatic joint; real or complex.
    gravity : array-like, shape (3,), optional
        In the arm's base frame [m/s²]; `arm.gravity` when None.

    Returns
    -------
    g : ndarray, shape (..., n)
        [N m]; [N] for a prismatic joint.

    Raises
    ------
    InputError
        For an arm that cannot be read, or arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.gravity_torque("appendix", [0.0] * 6)[1:3].round(2).tolist()
    [-57.97, -14.48]
    """
    arm = as_arm_or_tree(arm)
    chain = chain_of(arm)
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))
    return evaluate(arm, lambda state: joint_torques(chain, state, g_0), (arm.n,), q)


def bias_torque(
    arm: ModelSource, q: ArrayLike, qd: ArrayLike, gravity: ArrayLike | None = None
) -> NDArray[Any]:
    """C(q, q̇) q̇ + g(q), shape (..., n) [N m]: the torque of the motion without acceleration."""
    arm = as_arm_or_tree(arm)
    require_rest(arm, qd)
    chain = chain_of(arm)
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))
    return evaluate(arm, lambda state: joint_torques(chain, state, g_0), (arm.n,), q, qd)


def forward_dynamics(
    arm: ModelSource,
    q: ArrayLike,
    qd: ArrayLike,
    tau: ArrayLike,
    gravity: ArrayLike | None = None,
) -> NDArray[Any]:
    """Forward dynamics: q̈ = M⁻¹ (τ − C q̇ − g).

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q, qd, tau : array-like, shape (..., n)
        Joint positions [rad], velocities [rad/s] and torques [N m] ([m], [m/s] and [N] for a
        prismatic joint); leading axes broadcast.
    gravity : array-like, shape (3,), optional
        In the arm's base frame [m/s²]; `arm.gravity` when None.

    Returns
    -------
    qdd : ndarray, shape (..., n)
        [rad/s²]; [m/s²] for a prismatic joint.

    Raises
    ------
    InputError
        For an arm that cannot be read; arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers; a singular mass matrix (a joint that moves no mass).

    Examples
    --------
    >>> import ur5check
    >>> rest = [0.0] * 6
    >>> tau = ur5check.gravity_torque("paper", rest)
    >>> bool(abs(ur5check.forward_dynamics("paper", rest, rest, tau)).max() < 1e-9)
    True
    """
    arm = as_arm_or_tree(arm)
    M, bias = mass_matrix(arm, q), bias_torque(arm, q, qd, gravity)
    given = joint_array(arm, "tau", tau)
    try:
        torque = given - bias
    except ValueError:
        raise StateError(
            f"these shapes do not broadcast: tau {given.shape}, q and qd {bias.shape}"
        ) from None
    return _solved(arm, M, torque)


def acceleration_of(arm: SerialArm | RobotTree, gravity: ArrayLike | None = None) -> Acceleration:
    """Forward dynamics prepared for one state at a time, as an integrator calls it.

    `forward_dynamics` runs the recursion n + 1 times, which is best for thousands of states at
    once.  For one state the cost is the number of runs: here n + 1 columns go through a single run,
    five times as fast.

        column 0       τ(q, q̇, 0) under gravity     = C q̇ + g
        column j       τ(q, 0, e_j) without gravity = M e_j

    gravity as in `rnea`.  The function takes q, q̇ and τ of shape (n,) and raises StateError for
    arrays that are not finite or not of this shape, and where M cannot be inverted.
    """
    n, chain = arm.n, chain_of(_with_tensors(arm, "accelerations"))
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


def _solved(arm: SerialArm | RobotTree, M: NDArray[Any], torque: NDArray[Any]) -> NDArray[Any]:
    """M⁻¹ τ, shape (..., n)."""
    try:
        return np.linalg.solve(M, torque[..., None])[..., 0]
    except np.linalg.LinAlgError as error:
        raise StateError(
            f"the mass matrix of arm {arm.name!r} is singular: a joint moves no mass; "
            "check its inertias with `ur5check show`"
        ) from error


def kinetic_energy(arm: ModelSource, q: ArrayLike, qd: ArrayLike) -> NDArray[Any]:
    """Kinetic energy T = Σ ½ m_i v_ci² + ½ ω_i · I_i ω_i + ½ armature_i q̇_i².

    It is computed from the velocities of the links, not from M.

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q, qd : array-like, shape (..., n)
        Joint positions [rad] and velocities [rad/s] ([m] and [m/s] for a prismatic joint); real or
        complex; leading axes broadcast.

    Returns
    -------
    T : ndarray, shape (...)
        [J]

    Raises
    ------
    InputError
        For an arm that cannot be read, or arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers.

    Examples
    --------
    >>> import ur5check
    >>> float(ur5check.kinetic_energy("paper", [0.0] * 6, [0.0] * 6))
    0.0
    """
    arm = _with_tensors(arm, "the kinetic energy")
    chain = chain_of(arm)
    return evaluate(arm, lambda state: [_kinetic(chain, state)], (), q, qd)


def potential_energy(
    arm: ModelSource, q: ArrayLike, gravity: ArrayLike | None = None
) -> NDArray[Any]:
    """Potential energy U = −Σ m_i g · p_ci, zero for centres of mass at the base origin.

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q : array-like, shape (..., n)
        Joint positions [rad], or [m] for a prismatic joint; real or complex.
    gravity : array-like, shape (3,), optional
        In the arm's base frame [m/s²]; `arm.gravity` when None.

    Returns
    -------
    U : ndarray, shape (...)
        [J]

    Raises
    ------
    InputError
        For an arm that cannot be read, or arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers.

    Examples
    --------
    >>> import ur5check
    >>> weightless = ur5check.potential_energy("paper", [0.0] * 6, gravity=(0, 0, 0))
    >>> bool(weightless == 0.0)
    True
    """
    arm = as_arm_or_tree(arm)
    chain, g = chain_of(arm), Vector.of(gravity_of(arm, gravity))

    def compute(state: JointState) -> list[Scalar]:
        moment = ZERO
        for link, frame in zip(chain.links, frames(chain, state), strict=True):
            moment = moment + frame.point(link.c) * link.m
        return [-g.dot(moment)]

    return evaluate(arm, compute, (), q)


def _with_tensors(model: ModelSource, what: str) -> SerialArm | RobotTree:
    """The arm or tree, whose tensors must be known for `what`."""
    arm = as_arm_or_tree(model)
    if isinstance(arm, SerialArm):
        arm.require_tensors(what)
    return arm


def mass_columns(chain: Chain, state: JointState) -> list[list[Scalar]]:
    """M of one block of states, by columns: the torques of a unit acceleration of each joint."""
    still = [0.0] * len(chain.links)
    return [joint_torques(chain, state.with_motion(still, unit), ZERO) for unit in chain.units()]


def _coriolis_columns(chain: Chain, state: JointState) -> list[list[Scalar]]:
    still = [0.0] * len(chain.links)

    def velocity_torque(unit: list[float], step: float) -> list[Scalar]:
        qd = [plus(rate, step * each) for rate, each in zip(state.qd, unit, strict=True)]
        return joint_torques(chain, state.with_motion(qd, still), ZERO)

    columns = []
    for unit in chain.units():
        ahead, behind = velocity_torque(unit, 1.0), velocity_torque(unit, -1.0)
        columns.append([0.25 * (a - b) for a, b in zip(ahead, behind, strict=True)])
    return columns


def _as_rows(columns: list[list[Scalar]]) -> list[Scalar]:
    """The entries of a matrix given by its columns, row by row."""
    return [entry for row in zip(*columns, strict=True) for entry in row]


def _kinetic(chain: Chain, state: JointState) -> Scalar:
    energy: Scalar = 0.0
    # Angular velocity, and linear velocity of origin i, of each link, both in its frame i.
    velocities: list[tuple[Vector, Vector]] = []
    for link, q, cos, sin, qd in zip(
        chain.links, state.q, state.cos, state.sin, state.qd, strict=True
    ):
        R = link.rotation(cos, sin)
        w, v = velocities[link.parent] if link.parent >= 0 else (ZERO, ZERO)
        w, v = R.back(w), R.back(v + w.cross(link.d))
        if link.prismatic:
            v = v + link.b * qd
        else:
            w = w + link.b * qd
        r = link.link_vector(q)
        v_c = v + w.cross(r + link.c)
        energy = energy + 0.5 * (link.m * v_c.dot(v_c) + w.dot(link.I @ w))
        energy = energy + 0.5 * link.armature * qd * qd
        velocities.append((w, v + w.cross(r)))
    return energy
