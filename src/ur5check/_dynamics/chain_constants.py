"""The constants of an arm or a tree for the recursion: one `LinkConstants` a link, in frame i.

For link i (paper, eqs 9–15):

    R_i         rotation from frame i to frame i−1        depends on q_i when revolute
    b_i         joint axis in frame i                     constant: J_i leaves its axis fixed
    r_{i−1,i}   origin i−1 to origin i, in frame i        constant, + b_i q_i when prismatic
    r_{i,ci}    origin i to centre of mass, m_i, I_i      constant

For a joint about any unit axis u, let C be a constant rotation with C z = u.  Then
R_i = C Rot_z(q_i) Cᵀ R(P_i) for every axis, and for an axis along ±x, ±y or ±z the matrix C is a
signed permutation, which costs no multiplication.

In a tree, the parent of link i is any earlier link, and the joint's frame has a pose D_i in the
parent's: R_i = R(D_i) C Rot_z(q_i) Cᵀ R(P_i), and d_i leads from the parent's origin to the joint.
A chain is the case parent(i) = i − 1 and D_i = 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .._robot.robot_tree import RobotTree
from .._robot.serial_arm import Joint, Link, SerialArm
from .._robot.transforms import Array, Transform
from .vectors import ZERO, Matrix, Scalar, Vector, plus, times

__all__ = ["Chain", "LinkConstants", "Rotation", "chain_of"]


@dataclass(frozen=True, slots=True)
class LinkConstants:
    """The quantities of link i that do not depend on the state."""

    parent: int  # index of the link that carries the joint, -1 for the base
    prismatic: bool
    before: Matrix  # R(D_i) C
    after: Matrix  # Cᵀ R(P_i)
    b: Vector  # joint axis in frame i
    r: Vector  # r_{i−1,i} at q_i = 0 [m]
    c: Vector  # r_{i,ci}, or from origin i to the reference point of h and I [m]
    m: Scalar  # [kg]
    armature: Scalar  # of the joint's motor [kg m²]
    I: Matrix  # about c [kg m²]  # noqa: E741 - the usual symbol
    d: Vector = ZERO  # from the parent's origin to the joint, in the parent's frame [m]
    h: Vector = ZERO  # first moment about c [kg m]: zero where c is the centre of mass

    def rotation(self, cos: Scalar, sin: Scalar) -> Rotation:
        """R_i, from the cosine and sine of q_i."""
        return Rotation(self, 1.0, 0.0) if self.prismatic else Rotation(self, cos, sin)

    def link_vector(self, q: Scalar) -> Vector:
        """r_{i−1,i}."""
        return self.r + self.b * q if self.prismatic else self.r


@dataclass(frozen=True, slots=True)
class Rotation:
    """R_i = R(D_i) C Rot_z(q_i) Cᵀ R(P_i): `R @ v` goes to the parent's frame, `R.back(v)` back."""

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
    """The links, each after its parent, and the arm's base transform B.

    coordinates : for each coordinate, the joints that follow it, with their multipliers: the
        columns of G in q̇_joints = G q̇.  None where each joint has its own.
    """

    links: tuple[LinkConstants, ...]
    base: Matrix  # rotation of B
    origin: Vector  # translation of B [m]
    coordinates: tuple[tuple[tuple[int, float], ...], ...] | None = None

    def inner_gravity(self, gravity: Array) -> Vector:
        """g_0: gravity in frame 0 (after B), from gravity in the base frame."""
        return self.base.T @ Vector.of(gravity)

    def units(self) -> list[list[float]]:
        """Rates of all joints for a unit rate of each coordinate: the columns of G."""
        everyone = range(len(self.links))
        if self.coordinates is None:
            return [[1.0 if i == j else 0.0 for i in everyone] for j in everyone]
        return [[dict(column).get(i, 0.0) for i in everyone] for column in self.coordinates]

    def of_coordinates(self, torques: list[Scalar]) -> list[Scalar]:
        """Gᵀ τ: torques of the coordinates from those of all joints."""
        if self.coordinates is None:
            return torques
        found: list[Scalar] = []
        for column in self.coordinates:
            total: Scalar = 0.0
            for joint, multiplier in column:
                total = plus(total, times(multiplier, torques[joint]))
            found.append(total)
        return found


@lru_cache(maxsize=256)
def chain_of(arm: SerialArm | RobotTree) -> Chain:
    """The constants of an arm or tree, computed once for each (both are immutable)."""
    if isinstance(arm, RobotTree):
        links = tuple(
            _constants(link.parent, link.joint, link.link, link.origin) for link in arm.links
        )
        columns: list[list[tuple[int, float]]] = [[] for _ in arm.joint_names]
        for i, link in enumerate(arm.links):
            columns[link.coordinate].append((i, link.multiplier))
        return Chain(links, Matrix.of(np.eye(3)), ZERO, tuple(map(tuple, columns)))
    links = tuple(
        _constants(i - 1, joint, link)
        for i, (joint, link) in enumerate(zip(arm.joints, arm.links, strict=True))
    )
    return Chain(links, Matrix.of(arm.base.R), Vector.of(arm.base.p))


def _constants(
    parent: int, joint: Joint, link: Link, origin: Transform | None = None
) -> LinkConstants:
    P, C = link.link_tip_frame, _z_onto(joint.axis)
    return LinkConstants(
        parent=parent,
        prismatic=joint.kind == "prismatic",
        before=Matrix.of(C if origin is None else origin.R @ C),
        after=Matrix.of(C.T @ P.R),
        b=Vector.of(P.R.T @ joint.axis),
        r=Vector.of(P.R.T @ P.p),
        c=Vector.of(link.inertia.com),
        m=link.inertia.mass,
        armature=joint.armature,
        I=Matrix.of(link.inertia.tensor),
        d=ZERO if origin is None else Vector.of(origin.p),
    )


def _z_onto(axis: Array) -> Array:
    """A rotation C with C z = axis; a signed permutation when the axis is ±x, ±y or ±z."""
    helper = np.eye(3)[(int(np.abs(axis).argmax()) + 2) % 3]
    x = np.cross(helper, axis)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])
