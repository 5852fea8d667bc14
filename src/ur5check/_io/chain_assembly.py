"""From any tree of bodies to the parts of a `SerialArm`: a chain, and what is fixed to it.

The chain from base to tip is bracketed as

    B · J1(q1) · P1 · … · Jn(qn) · Pn,

B and every P_i being products of fixed poses.  What is fixed to a moving link is welded to it.
URDF, MJCF and SDF differ in how a file says where things stand and what they weigh (`Description`);
what becomes of it is the same, and is here.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Literal, NoReturn, Protocol

from .._robot import Inertia, Joint, Link, Transform
from .urdf.urdf_chain import Chain, Edge, Tree

__all__ = ["Assembly", "Description", "assemble", "rigid_poses"]


class Description(Protocol):
    """What a format's reader must answer.

    A joint's motion stands between two poses: T_parent→child(q) = joint_origin · J(q) · carried.
    """

    @property
    def tree(self) -> Tree:
        """All links and joints."""

    def joint(self, edge: Edge) -> Joint:
        """The joint itself; raises ModelError where it is not one angle or one length."""

    def joint_origin(self, edge: Edge) -> Transform:
        """Pose of the joint's frame in the parent's."""

    def carried(self, edge: Edge) -> Transform:
        """Pose of the child's frame seen from the joint's moving side."""

    def held_pose(self, edge: Edge, moving: frozenset[str]) -> Transform:
        """Pose of the child in the parent, of a joint that is fixed or held still because it is
        not among the chain's `moving` ones."""

    def inertia(self, link: str) -> Inertia | None:
        """A link's own inertia, in the link's frame; None where the file gives none."""

    def fail(
        self,
        tag: Literal["link", "joint"],
        name: str,
        part: str,
        problem: str,
        fix: str,
        rule: str = "XML100",
    ) -> NoReturn:
        """Raise ModelError at a link or joint; part : " inertial/mass", or ""."""


@dataclass(frozen=True)
class Assembly:
    """The parts of a `SerialArm`; notes : what a reader of a report should know of them."""

    base: Transform
    joints: tuple[Joint, ...]
    links: tuple[Link, ...]
    notes: tuple[str, ...]


def assemble(description: Description, chain: Chain, *, strict: bool = True) -> Assembly:
    """The arm along `chain`.

    strict : refuse a moving tip without mass, and a moving mass without a tensor

    Raises ModelError for a joint or a link that no arm can have.
    """
    joints = tuple(description.joint(edge) for edge in chain.moving)
    base, link_tip_frames = _brackets(description, chain)
    notes = list(chain.notes)
    links = tuple(
        _moving_link(description, edge, link_tip_frame, chain, notes, strict)
        for edge, link_tip_frame in zip(chain.moving, link_tip_frames, strict=True)
    )
    return Assembly(base, joints, links, tuple(notes))


def _brackets(description: Description, chain: Chain) -> tuple[Transform, list[Transform]]:
    """B, and P_1 … P_n."""
    moving = chain.moving_joints
    gathered = Transform.identity()
    for edge in chain.climbed:
        gathered = gathered @ description.held_pose(edge, moving).inverse()
    pieces = []
    for edge in chain.descended:
        if edge.moves:
            pieces.append(gathered @ description.joint_origin(edge))
            gathered = description.carried(edge)
        else:
            gathered = gathered @ description.held_pose(edge, moving)
    return pieces[0], [*pieces[1:], gathered]


def rigid_poses(
    description: Description, link: str, edges: Iterable[Edge], moving: frozenset[str]
) -> dict[str, Transform]:
    """Poses of a link and of all that `Tree.rigid_group` joins to it, in the link's frame."""
    poses = {link: Transform.identity()}
    for edge in edges:
        poses[edge.child] = poses[edge.parent] @ description.held_pose(edge, moving)
    return poses


def _moving_link(
    description: Description,
    edge: Edge,
    link_tip_frame: Transform,
    chain: Chain,
    notes: list[str],
    strict: bool,
) -> Link:
    """The link that `edge` moves with all that moves with it, in the frame at its tip frame."""
    name = edge.child
    moving = chain.moving_joints
    edges = description.tree.rigid_group(name, chain)
    poses = rigid_poses(description, name, edges, moving)
    parts, welded, has_extent = [], [], False
    for member, pose in poses.items():
        own = description.inertia(member)
        if own is not None:
            parts.append(own.expressed_in(pose))
            has_extent = has_extent or own.judged().has_tensor
            if member != name and own.mass > 0.0:
                welded.append((member, parts[-1]))
    held = [other.joint for other in edges if other.moves]
    if not parts:
        problem = "moves, but neither it nor anything fixed to it has an <inertial>"
        fix = "give it one, or choose base= and tip= so that it is no part of the arm"
        description.fail("link", name, "", problem, fix, "INE104")
    total = reduce(add, parts)
    if strict and total.mass == 0.0 and edge is chain.moving[-1]:
        problem = "mass zero on a moving tip: no torque would move it, so its motion is free"
        fix = "give it a mass, or choose a tip= before it"
        description.fail("link", name, " inertial/mass", problem, fix, "INE105")
    if strict and total.mass > 0.0 and not has_extent:
        problem = "moves, but its inertia tensor is zero: not positive definite"
        fix = "give the tensor of its mass"
        description.fail("link", name, " inertial/inertia", problem, fix, "INE106")
    if total.mass == 0.0:
        notes.append(f"moving link {name!r} has mass zero")
    if welded:
        notes.append(f"merged into {name!r}: {_listed([member for member, _ in welded])}")
    if held:
        notes.append(f"held still, being outside the arm: {_listed(held)}")
    to_link_tip_frame = link_tip_frame.inverse() @ description.carried(edge)
    return Link(
        name,
        link_tip_frame,
        total.expressed_in(to_link_tip_frame),
        to_link_tip_frame,
        tuple((member, inertia.expressed_in(to_link_tip_frame)) for member, inertia in welded),
    )


def _listed(names: list[str]) -> str:
    return ", ".join(map(repr, names))
