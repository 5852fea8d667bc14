"""The paper's recursive Newton–Euler algorithm: torques from motion (SSRN 3939013, eqs 9–15).

Frame i sits at the tip frame of link i, gravity is carried from link to link as a vector of its
own, and every vector of link i is written in frame i.  With b_i the joint axis, r_{i−1,i} from
origin to origin and r_{i,ci} from the far origin to the centre of mass, r_{i−1,ci} = r_{i−1,i} +
r_{i,ci}:

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
    and the joint feels b_i · τ_i.

A motor's inertia, which the paper leaves out, adds armature_i · q̈_i to its own joint's torque.

A sliding joint, which the paper has no use for, adds b_i q̈_i + 2 ω_i × b_i q̇_i to both
accelerations in place of its share of (9) and (10), and feels b_i · f_i.

Two liberties for `closed_form`, which cost nothing where they are not taken.  A link may be held
about another point than its centre of mass: it then has a first moment h_i about that point, which
adds α_i × h_i + ω_i × (ω_i × h_i) to f_i and h_i × (a_{c,i} − g_i) to τ_i.  And the base may
accelerate: by `base_acceleration` = −g_0 instead of gravity, which no joint can tell apart (Luh,
Walker & Paul 1980).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike, NDArray

from .._robot.serial_arm import SerialArm
from .batching import JointState, evaluate, gravity_of
from .chain_constants import Chain, LinkConstants, Rotation, chain_of
from .vectors import ZERO, Scalar, Vector, plus, times

__all__ = ["LinkMotion", "inward", "joint_torques", "outward", "rnea"]


@dataclass(frozen=True, slots=True)
class LinkMotion:
    """How link i moves; every vector in frame i."""

    link: LinkConstants
    R: Rotation  # R_i
    r: Vector  # r_{i−1,i} [m]
    w: Vector  # ω_i [rad/s]
    dw: Vector  # α_i [rad/s²]
    a: Vector  # acceleration of the body's point at origin i−1, [m/s²]
    g: Vector  # gravity [m/s²]

    def acceleration_at(self, r: Vector) -> Vector:
        """Of the body's point that lies `r` from origin i−1: eqs (11) and (12)."""
        return self.a + self.dw.cross(r) + self.w.cross(self.w.cross(r))

    def turning(self, h: Vector) -> Vector:
        """α_i × h + ω_i × (ω_i × h)."""
        return self.dw.cross(h) + self.w.cross(self.w.cross(h))


def outward(
    chain: Chain, state: JointState, gravity: Vector, base_acceleration: Vector = ZERO
) -> list[LinkMotion]:
    """Eqs (9)–(13): the motion of every link, from base to tip."""
    motions: list[LinkMotion] = []
    w, dw, a, g = ZERO, ZERO, base_acceleration, gravity
    for link, q, cos, sin, qd, qdd in zip(
        chain.links, state.q, state.cos, state.sin, state.qd, state.qdd, strict=True
    ):
        R, r, b = link.rotation(cos, sin), link.link_vector(q), link.b
        w, dw, a, g = R.back(w), R.back(dw), R.back(a), R.back(g)
        if link.prismatic:
            a = a + b * qdd + w.cross(b * (2.0 * qd))
        else:
            w = w + b * qd
            dw = dw + b * qdd + w.cross(b * qd)
        motion = LinkMotion(link, R, r, w, dw, a, g)
        motions.append(motion)
        a = motion.acceleration_at(r)
    return motions


def inward(motions: list[LinkMotion]) -> list[Scalar]:
    """Eqs (14) and (15): the torque (or force) of every joint, from tip to base."""
    torques: list[Scalar] = []
    f_next, tau_next = ZERO, ZERO  # R_{i+1} f_{i+1} and R_{i+1} τ_{i+1}
    for motion in reversed(motions):
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
        f_next, tau_next = motion.R @ f, motion.R @ tau
    return torques[::-1]


def joint_torques(
    chain: Chain, state: JointState, gravity: Vector, base_acceleration: Vector = ZERO
) -> list[Scalar]:
    """τ of one block of states: out along the arm and back, and what the motors themselves ask."""
    torques = inward(outward(chain, state, gravity, base_acceleration))
    return [
        plus(torque, times(link.armature, qdd))
        for torque, link, qdd in zip(torques, chain.links, state.qdd, strict=True)
    ]


def rnea(
    arm: SerialArm,
    q: ArrayLike,
    qd: ArrayLike,
    qdd: ArrayLike,
    gravity: ArrayLike | None = None,
) -> NDArray[Any]:
    """Joint torques of a motion: τ = M(q) q̈ + C(q, q̇) q̇ + g(q).

    Parameters
    ----------
    q, qd, qdd : array-like, shape (..., n); real or complex; leading axes broadcast
        [rad], [rad/s], [rad/s²]; for a sliding joint [m], [m/s], [m/s²].
    gravity : array-like, shape (3,), in the arm's base frame [m/s²]; the arm's own when None,
        which is (0, 0, −9.81) unless its source says otherwise.

    Returns
    -------
    tau : shape (..., n) [N m]; [N] for a sliding joint.

    Raises
    ------
    StateError : wrong length, shapes that do not broadcast, or entries that are no finite numbers.

    References
    ----------
    R. Kumar, SSRN 3939013, eqs (9)–(15).
    """
    chain = chain_of(arm)
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))
    return evaluate(arm, lambda state: joint_torques(chain, state, g_0), (arm.n,), q, qd, qdd)
