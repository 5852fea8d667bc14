"""The constants of an arm that the recursion needs: one `LinkConstants` a link, in frame i.

For link i (paper, eqs 9–15):

    R_i         rotation from frame i to frame i−1        depends on q_i when revolute
    b_i         joint axis in frame i                     constant: J_i leaves its axis fixed
    r_{i−1,i}   origin i−1 to origin i, in frame i        constant, + b_i q_i when prismatic
    r_{i,ci}    origin i to centre of mass, m_i, I_i      constant

For a joint about any unit axis u, let C be a constant rotation with C z = u.  Then
R_i = C Rot_z(q_i) Cᵀ R(P_i) for every axis, and for an axis along ±x, ±y or ±z the matrix C is a
signed permutation, which costs no multiplication.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .vectors import ZERO, Matrix, Scalar, Vector

__all__ = ["Chain", "LinkConstants", "Rotation", "chain_of"]


@dataclass(frozen=True, slots=True)
class LinkConstants:
    """The quantities of link i that do not depend on the state."""

    prismatic: bool
    before: Matrix  # C
    after: Matrix  # Cᵀ R(P_i)
    b: Vector  # joint axis in frame i
    r: Vector  # r_{i−1,i} at q_i = 0 [m]
    c: Vector  # r_{i,ci}, or from origin i to the reference point of h and I [m]
    m: Scalar  # [kg]
    armature: Scalar  # of the joint's motor [kg m²]
    I: Matrix  # about c [kg m²]  # noqa: E741 - the usual symbol
    h: Vector = ZERO  # first moment about c [kg m]: zero where c is the centre of mass

    def rotation(self, cos: Scalar, sin: Scalar) -> Rotation:
        """R_i, from the cosine and sine of q_i."""
        return Rotation(self, 1.0, 0.0) if self.prismatic else Rotation(self, cos, sin)

    def link_vector(self, q: Scalar) -> Vector:
        """r_{i−1,i}."""
        return self.r + self.b * q if self.prismatic else self.r


@dataclass(frozen=True, slots=True)
class Rotation:
    """R_i = C Rot_z(q_i) Cᵀ R(P_i): `R @ v` goes from frame i to frame i−1, `R.back(v)` back."""

    link: LinkConstants
    cos: Scalar
    sin: Scalar

    def __matmul__(self, v: Vector) -> Vector:
        return self.link.before @ (self.link.after @ v).turned_about_z(self.cos, self.sin)

    def back(self, v: Vector) -> Vector:
        """R_iᵀ v."""
        turned = (self.link.before.T @ v).turned_back_about_z(self.cos, self.sin)
        return self.link.after.T @ turned


@dataclass(frozen=True, slots=True)
class Chain:
    """The links in order, and the arm's base transform B."""

    links: tuple[LinkConstants, ...]
    base: Matrix  # rotation of B
    origin: Vector  # translation of B [m]

    def inner_gravity(self, gravity: Array) -> Vector:
        """g_0: gravity in frame 0 (after B), from gravity in the base frame."""
        return self.base.T @ Vector.of(gravity)


@lru_cache(maxsize=256)
def chain_of(arm: SerialArm) -> Chain:
    """The constants of an arm, computed once for each arm (an arm is immutable)."""
    links = []
    for joint, link in zip(arm.joints, arm.links, strict=True):
        P, C = link.link_tip_frame, _z_onto(joint.axis)
        links.append(
            LinkConstants(
                prismatic=joint.kind == "prismatic",
                before=Matrix.of(C),
                after=Matrix.of(C.T @ P.R),
                b=Vector.of(P.R.T @ joint.axis),
                r=Vector.of(P.R.T @ P.p),
                c=Vector.of(link.inertia.com),
                m=link.inertia.mass,
                armature=joint.armature,
                I=Matrix.of(link.inertia.tensor),
            )
        )
    return Chain(tuple(links), Matrix.of(arm.base.R), Vector.of(arm.base.p))


def _z_onto(axis: Array) -> Array:
    """A rotation C with C z = axis; a signed permutation when the axis is ±x, ±y or ±z."""
    helper = np.eye(3)[(int(np.abs(axis).argmax()) + 2) % 3]
    x = np.cross(helper, axis)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])
