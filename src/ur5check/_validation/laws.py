"""The laws: true of any arm, whatever its numbers, if the algorithm is right.

Derivatives are taken by a complex step, f′ = Im f(x + i h) / h, which subtracts nothing and is
therefore exact to rounding for any tiny h (Martins, Sturdza & Alonso 2003).
"""

from __future__ import annotations

import numpy as np

from .._comparison.motion_difference import tool_errors
from .._robot.transforms import Array
from .law import Check, Measurement, Tolerance
from .law_subject import STEP, Subject

__all__ = ["LAWS"]

_ROUNDING = Tolerance(
    32,
    "rounding: a number that passes through n joints is rounded some 32 times in each, by ε of "
    "the size of what is added up",
)


def _per_state(difference: Array) -> Array:
    """The largest entry of each state's difference."""
    worst: Array = np.abs(difference).reshape(len(difference), -1).max(axis=1)
    return worst


# --- against the reference engine
# -------------------------------------------------------------------------


def _fk_reference(s: Subject) -> Measurement:
    recursion, other = (e.forward_kinematics(s.states.q) for e in (s.recursion, s.reference))
    position, angle = tool_errors(recursion, other)
    reach = sum(float(np.linalg.norm(link.link_tip_frame.p)) for link in s.arm.links)
    size = max(1.0, reach + float(np.linalg.norm(s.arm.base.p)))
    return Measurement(
        np.asarray(np.maximum(position, angle)),
        size,
        (f"position {position.max():.1e} m, angle {angle.max():.1e} rad",),
    )


def _torque_reference(s: Subject) -> Measurement:
    return Measurement(_per_state(s.tau - s.reference_tau), s.torque_size)


def _mass_reference(s: Subject) -> Measurement:
    return Measurement(_per_state(s.M - s.reference.mass_matrix(s.states.q)), s.mass_size)


def _bias_reference(s: Subject) -> Measurement:
    ours = np.einsum("kij,kj->ki", s.C, s.states.qd) + s.g
    theirs = s.reference.bias_torque(s.states.q, s.states.qd)
    return Measurement(_per_state(ours - theirs), s.torque_size)


def _gravity_reference(s: Subject) -> Measurement:
    return Measurement(_per_state(s.g - s.reference.gravity_torque(s.states.q)), s.torque_size)


def _forward_reference(s: Subject) -> Measurement:
    theirs = s.reference.forward_dynamics(s.states.q, s.states.qd, s.tau)
    return Measurement(_per_state(s.qdd - theirs), _acceleration_size(s))


def _regressor_reference(s: Subject) -> Measurement:
    theirs = s.reference.torque_regressor(s.states.q, s.states.qd, s.states.qdd)
    return Measurement(_per_state(s.regressor - theirs), float(np.abs(theirs).max()))


# --- among ourselves -----------------------------------------------------------------------------


def _mass_symmetric(s: Subject) -> Measurement:
    return Measurement(_per_state(s.M - np.swapaxes(s.M, -1, -2)), s.mass_size)


def _mass_positive(s: Subject) -> Measurement:
    smallest = np.linalg.eigvalsh((s.M + np.swapaxes(s.M, -1, -2)) / 2)[:, 0]
    return Measurement(np.asarray(smallest, dtype=np.float64), s.mass_size)


def _not_skew(rate_of_mass: Array, C: Array) -> Array:
    S = rate_of_mass - 2.0 * C
    return _per_state(S + np.swapaxes(S, -1, -2))


def _skew(s: Subject) -> Measurement:
    return Measurement(_not_skew(s.rate_of_M, s.C), s.polarised_size)


def _skew_reference(s: Subject) -> Measurement:
    C = s.reference.coriolis_matrix(s.states.q, s.states.qd)
    return Measurement(_not_skew(s.rate_of_M, C), s.world_rate_size)


def _gravity_gradient(s: Subject) -> Measurement:
    n = s.arm.n
    steps = s.states.q[:, None, :] + 1j * STEP * np.eye(n)  # one joint at a time
    gradient = s.recursion.potential_energy(steps).imag / STEP
    return Measurement(_per_state(gradient - s.g), s.torque_size)


def _power_balance(s: Subject) -> Measurement:
    q = s.states.q + 1j * STEP * s.states.qd
    qd = s.states.qd + 1j * STEP * s.states.qdd
    energy = s.recursion.kinetic_energy(q, qd) + s.recursion.potential_energy(q)
    power = np.einsum("ki,ki->k", s.states.qd, s.tau)
    return Measurement(
        np.abs(energy.imag / STEP - power), s.torque_size * float(np.abs(s.states.qd).max())
    )


def _forward_inverse(s: Subject) -> Measurement:
    return Measurement(_per_state(s.qdd - s.states.qdd), _acceleration_size(s))


def _acceleration_size(s: Subject) -> float:
    """What a torque of the size at hand can do to the lightest direction of M [rad/s²]."""
    smallest = np.linalg.eigvalsh((s.M + np.swapaxes(s.M, -1, -2)) / 2)[:, 0]
    return s.torque_size / float(smallest.min()) if smallest.min() > 0.0 else float("inf")


def _regressor_torque(s: Subject) -> Measurement:
    linear = s.regressor @ s.arm.parameters() + s.arm.armature * s.states.qdd
    return Measurement(_per_state(linear - s.tau), s.torque_size)


LAWS: tuple[Check[Subject], ...] = (
    Check(
        "fk-reference",
        "algorithm",
        "forward kinematics, ours and the reference engine's",
        "T_own(q) = T_reference(q)",
        "the chain B · J1(q1) · P1 · … · Jn(qn) · Pn; DH: paper, eq. (1)",
        "m or rad",
        _ROUNDING,
        _fk_reference,
    ),
    Check(
        "torque-reference",
        "algorithm",
        "torque, ours and the reference engine's inverse dynamics",
        "τ_own(q, q̇, q̈) = τ_reference(q, q̇, q̈)",
        "paper, eqs (9)–(15); Pinocchio: rnea (Featherstone 2008, §5.3)",
        "N m",
        _ROUNDING,
        _torque_reference,
    ),
    Check(
        "mass-reference",
        "algorithm",
        "mass matrix, ours and the reference engine's",
        "M_own(q) = M_reference(q)",
        "paper, eq. (2); Pinocchio: crba (Featherstone 2008, §6.2)",
        "kg m²",
        _ROUNDING,
        _mass_reference,
    ),
    Check(
        "mass-symmetric",
        "algorithm",
        "the mass matrix is symmetric",
        "M = Mᵀ",
        "T = ½ q̇ᵀ M q̇ is a quadratic form; Siciliano et al. 2009, ch. 7",
        "kg m²",
        _ROUNDING,
        _mass_symmetric,
    ),
    Check(
        "mass-positive",
        "algorithm",
        "the mass matrix is positive definite",
        "λ_min(M) > 0",
        "kinetic energy is positive for any motion; Siciliano et al. 2009, ch. 7",
        "kg m²",
        Tolerance(1, "an eigenvalue is known to n ε of the largest entry: above that it is > 0"),
        _mass_positive,
        positive=True,
    ),
    Check(
        "bias-reference",
        "algorithm",
        "velocity and gravity torque, ours and the reference engine's",
        "C(q, q̇) q̇ + g(q) = b_reference(q, q̇)",
        "paper, eq. (2); Pinocchio: nonLinearEffects",
        "N m",
        _ROUNDING,
        _bias_reference,
    ),
    Check(
        "gravity-reference",
        "algorithm",
        "gravity torque, ours and the reference engine's",
        "g_own(q) = g_reference(q)",
        "paper, eq. (13); Pinocchio: computeGeneralizedGravity",
        "N m",
        _ROUNDING,
        _gravity_reference,
    ),
    Check(
        "gravity-gradient",
        "algorithm",
        "gravity torque is the gradient of potential energy",
        "g = ∂U/∂q",
        "Siciliano et al. 2009, ch. 7; derivative by complex step",
        "N m",
        _ROUNDING,
        _gravity_gradient,
    ),
    Check(
        "coriolis-skew",
        "algorithm",
        "Ṁ − 2C is skew, with our C",
        "(Ṁ − 2C) + (Ṁ − 2C)ᵀ = 0",
        "Siciliano et al. 2009, ch. 7; Ṁ by complex step",
        "N m s",
        _ROUNDING,
        _skew,
    ),
    Check(
        "coriolis-skew-reference",
        "algorithm",
        "Ṁ − 2C is skew, with the reference engine's C",
        "(Ṁ − 2C_reference) + (Ṁ − 2C_reference)ᵀ = 0",
        "as above; Pinocchio: computeCoriolisMatrix",
        "N m s",
        _ROUNDING,
        _skew_reference,
    ),
    Check(
        "power-balance",
        "algorithm",
        "the torques' power is the rate of energy",
        "d(T + U)/dt = q̇ᵀ τ",
        "conservation of energy; derivative by complex step along the motion",
        "W",
        _ROUNDING,
        _power_balance,
    ),
    Check(
        "regressor-torque",
        "algorithm",
        "torque is linear in the inertial parameters",
        "τ = Y(q, q̇, q̈) π + armature ∘ q̈",
        "Khalil & Dombre 2002, ch. 9",
        "N m",
        _ROUNDING,
        _regressor_torque,
    ),
    Check(
        "regressor-reference",
        "algorithm",
        "torque regressor, ours and the reference engine's",
        "Y_own = Y_reference · A",
        "Pinocchio: computeJointTorqueRegressor, taken to our link frames by A",
        "N m per unit",
        _ROUNDING,
        _regressor_reference,
    ),
    Check(
        "forward-inverse",
        "algorithm",
        "forward dynamics inverts inverse dynamics",
        "q̈(q, q̇, τ(q, q̇, q̈)) = q̈",
        "paper, eq. (2) solved for the acceleration",
        "rad/s²",
        _ROUNDING,
        _forward_inverse,
    ),
    Check(
        "forward-reference",
        "algorithm",
        "forward dynamics, ours and the reference engine's",
        "q̈_own(q, q̇, τ) = q̈_reference(q, q̇, τ)",
        "Pinocchio: aba (Featherstone 2008, §7.3)",
        "rad/s²",
        _ROUNDING,
        _forward_reference,
    ),
)
