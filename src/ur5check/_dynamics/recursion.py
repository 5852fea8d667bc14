"""The paper's recursive Newton–Euler algorithm: torques from motion (SSRN 3939013, eqs 9–15).

Frame i is the tip frame of link i, gravity is a separate vector, and every vector of link i is
expressed in frame i.  With b_i the joint axis, r_{i−1,i} from origin i−1 to origin i, r_{i,ci} from
origin i to the centre of mass, and r_{i−1,ci} = r_{i−1,i} + r_{i,ci}:

  outward, i = 1 … n, from rest:
    ω_i     = R_iᵀ ω_{i−1} + b_i q̇_i                                                          (9)
    α_i     = R_iᵀ α_{i−1} + b_i q̈_i + ω_i × b_i q̇_i                                         (10)
    a_{e,i} = R_iᵀ a_{e,i−1} + α_i × r_{i−1,i}  + ω_i × (ω_i × r_{i−1,i})                      (11)
    a_{c,i} = R_iᵀ a_{e,i−1} + α_i × r_{i−1,ci} + ω_i × (ω_i × r_{i−1,ci})                     (12)
    g_i     = R_iᵀ g_{i−1}                                                                    (13)
  inward, i = n … 1, from a free tip:
    f_i = R_{i+1} f_{i+1} + m_i a_{c,i} − m_i g_i                                             (14)
    τ_i = R_{i+1} τ_{i+1} − f_i × r_{i−1,ci} + (R_{i+1} f_{i+1}) × r_{i,ci}
          + I_i α_i + ω_i × I_i ω_i                                                           (15)
    The joint torque is b_i · τ_i.

Four extensions of the paper's equations:

- Link i−1 stands for the parent of link i, which in a tree may carry several links.  The joint then
  lies at d_i from the parent's origin: motion is taken there, and d_i × R_i f_i joins the moment.
- The inertia of a motor adds armature_i · q̈_i to the torque of its joint.
- A prismatic joint adds b_i q̈_i + 2 ω_i × b_i q̇_i to both accelerations instead of its terms in
  (9) and (10); its joint force is b_i · f_i.
- For the closed form (`symbolic`), the reference point of a link need not be its centre of mass:
  the first moment h_i about that point adds α_i × h_i + ω_i × (ω_i × h_i) to f_i and
  h_i × (a_{c,i} − g_i) to τ_i.  And gravity may be replaced by `base_acceleration` = −g_0, which
  gives the same torques (Luh, Walker & Paul 1980).  Both cost nothing where they are not used.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._robot.as_arm import ModelSource, as_arm_or_tree
from .._robot.robot_tree import RobotTree
from .._robot.serial_arm import SerialArm
from .batching import JointState, evaluate, gravity_of
from .chain_constants import Chain, LinkConstants, Rotation, chain_of
from .vectors import ZERO, Scalar, Vector, plus, times

__all__ = ["LinkMotion", "inward", "joint_torques", "outward", "require_rest", "rnea"]


@dataclass(frozen=True, slots=True)
class LinkMotion:
    """Motion of link i; every vector in frame i."""

    link: LinkConstants
    R: Rotation  # R_i
    r: Vector  # r_{i−1,i} [m]
    w: Vector  # ω_i [rad/s]
    dw: Vector  # α_i [rad/s²]
    a: Vector  # acceleration of the point of the link at origin i−1 [m/s²]
    g: Vector  # gravity [m/s²]

    def acceleration_at(self, r: Vector) -> Vector:
        """Acceleration of the point of the link at `r` from origin i−1: eqs (11) and (12)."""
        return self.a + self.dw.cross(r) + self.w.cross(self.w.cross(r))

    def turning(self, h: Vector) -> Vector:
        """α_i × h + ω_i × (ω_i × h)."""
        return self.dw.cross(h) + self.w.cross(self.w.cross(h))


def outward(
    chain: Chain, state: JointState, gravity: Vector, base_acceleration: Vector = ZERO
) -> list[LinkMotion]:
    """Eqs (9)–(13): the motion of every link, from base to tip."""
    motions: list[LinkMotion] = []
    for link, q, cos, sin, qd, qdd in zip(
        chain.links, state.q, state.cos, state.sin, state.qd, state.qdd, strict=True
    ):
        R, r, b = link.rotation(cos, sin), link.link_vector(q), link.b
        w, dw, a, g = ZERO, ZERO, base_acceleration, gravity
        if link.parent >= 0:
            parent = motions[link.parent]
            w, dw, g = parent.w, parent.dw, parent.g
            a = parent.acceleration_at(parent.r + link.d)
        w, dw, a, g = R.back(w), R.back(dw), R.back(a), R.back(g)
        if link.prismatic:
            a = a + b * qdd + w.cross(b * (2.0 * qd))
        else:
            w = w + b * qd
            dw = dw + b * qdd + w.cross(b * qd)
        motions.append(LinkMotion(link, R, r, w, dw, a, g))
    return motions


def inward(motions: list[LinkMotion]) -> list[Scalar]:
    """Eqs (14) and (15): the torque (or force) of every joint, from tip to base."""
    torques: list[Scalar] = []
    carried = [(ZERO, ZERO) for _ in motions]  # R_{i+1} f_{i+1}, R_{i+1} τ_{i+1}
    for i in range(len(motions) - 1, -1, -1):
        motion, (f_next, tau_next) = motions[i], carried[i]
        link, w = motion.link, motion.w
        r_c = motion.r + link.c
        a_c = motion.acceleration_at(r_c) - motion.g
        f = f_next + a_c * link.m + motion.turning(link.h)
        tau = (
            tau_next
            - f.cross(r_c)
            + f_next.cross(link.c)
            + link.I @ motion.dw
            + w.cross(link.I @ w)
            + link.h.cross(a_c)
        )
        torques.append(link.b.dot(f if link.prismatic else tau))
        if link.parent >= 0:
            f_sum, tau_sum = carried[link.parent]
            f = motion.R @ f
            carried[link.parent] = f_sum + f, tau_sum + motion.R @ tau + link.d.cross(f)
    return torques[::-1]


def joint_torques(
    chain: Chain, state: JointState, gravity: Vector, base_acceleration: Vector = ZERO
) -> list[Scalar]:
    """τ of one block of states: both passes of the recursion, and the motors' inertias."""
    torques = inward(outward(chain, state, gravity, base_acceleration))
    return chain.of_coordinates(
        [
            plus(torque, times(link.armature, qdd))
            for torque, link, qdd in zip(torques, chain.links, state.qdd, strict=True)
        ]
    )


def require_rest(arm: SerialArm | RobotTree, *motion: ArrayLike) -> None:
    """Raise ModelError for a motion of an arm whose tensors are unknown: at rest they are not
    needed."""
    if isinstance(arm, SerialArm) and arm.unknown_tensors and any(np.any(x) for x in motion):
        arm.require_tensors("torques of a motion")


def rnea(
    arm: ModelSource,
    q: ArrayLike,
    qd: ArrayLike,
    qdd: ArrayLike,
    gravity: ArrayLike | None = None,
) -> NDArray[Any]:
    """Inverse dynamics by the recursive Newton–Euler algorithm: τ = M(q) q̈ + C(q, q̇) q̇ + g(q).

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q, qd, qdd : array-like, shape (..., n)
        Joint positions [rad], velocities [rad/s] and accelerations [rad/s²]; [m], [m/s] and [m/s²]
        for a prismatic joint.  Real or complex; leading axes broadcast.
    gravity : array-like, shape (3,), optional
        In the arm's base frame [m/s²]; `arm.gravity` when None.

    Returns
    -------
    tau : ndarray, shape (..., n)
        Joint torques [N m]; forces [N] for a prismatic joint.

    Raises
    ------
    InputError
        For an arm that cannot be read, or arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers; for a motion of an arm with unknown tensors.

    References
    ----------
    R. Kumar, SSRN 3939013, eqs (9)–(15).

    Examples
    --------
    >>> import ur5check
    >>> rest = [0.0] * 6
    >>> ur5check.rnea("appendix", rest, rest, rest)[1:3].round(2).tolist()
    [-57.97, -14.48]
    """
    arm = as_arm_or_tree(arm)
    require_rest(arm, qd, qdd)
    chain = chain_of(arm)
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))
    return evaluate(arm, lambda state: joint_torques(chain, state, g_0), (arm.n,), q, qd, qdd)
