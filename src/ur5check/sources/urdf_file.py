"""A URDF's text to a `SerialArm`.

Three readings, one after the other: `check_urdf` refuses what two readers could take differently,
`urdf_robot` has yourdfpy turn the text into numbers, and here the chain from base to tip is
bracketed as

    B · J1(q1) · P1 · … · Jn(qn) · Pn,

B and every P_i being products of joint origins.  What is fixed to a moving link is welded to it.
"""

from __future__ import annotations

import hashlib
from functools import reduce
from operator import add, matmul

from ..arm import Link, SerialArm, Source, Transform
from .urdf_chain import Chain, Edge
from .urdf_robot import Robot
from .urdf_strict import check_urdf
from .xml_text import checked_xml

__all__ = ["read_urdf"]


def read_urdf(
    data: bytes,
    *,
    file: str,
    base: str | None = None,
    tip: str | None = None,
    kind: str = "urdf",
    inputs: tuple[tuple[str, str], ...] | None = None,
) -> SerialArm:
    """The arm between two links of a URDF.

    data : the file's bytes;  file : what errors and reports call it
    base : link to start from, any from which the tip is reached without climbing a moving joint
        (default: the root)
    tip : link to end at (default: the end of the only chain of moving joints)
    kind, inputs : for `Source`, where the text was made from something else (xacro)

    Raises ModelError if the file is faulty, branches where no base and tip choose, or if the chain
    holds a joint that is not one angle or one length of its own.
    """
    text = checked_xml(data, file)
    robot = Robot(check_urdf(text, file), file)
    chain = robot.tree.chain(base, tip)
    for edge in chain.moving:
        _refuse_unless_simple(robot, edge)
    before, far_ends = _brackets(robot, chain)
    notes = list(chain.notes)
    links = tuple(
        _moving_link(robot, edge.child, far_end, chain, notes)
        for edge, far_end in zip(chain.moving, far_ends, strict=True)
    )
    return SerialArm(
        robot.name,
        tuple(robot.joint(edge) for edge in chain.moving),
        links,
        base=before,
        source=Source(
            kind=kind,
            inputs=inputs or ((file, hashlib.sha256(data).hexdigest()),),
            urdf=text.decode("utf-8"),
            base=chain.base,
            tip=chain.tip,
            notes=tuple(notes),
        ),
    )


def _refuse_unless_simple(robot: Robot, edge: Edge) -> None:
    """A joint of the chain must have one coordinate, and that its own."""
    if edge.kind in ("planar", "floating"):
        problem = f"is {edge.kind}: neither revolute nor prismatic"
        remedy = "choose base= and tip= so that it lies outside the arm"
        robot.fail("joint", edge.joint, "", problem, remedy)
    followed = robot.mimicked(edge.joint)
    if followed is not None:
        problem = f"mimics {followed!r}: it has no coordinate of its own"
        robot.fail("joint", edge.joint, "", problem, "choose a tip= before it, or remove <mimic>")


def _brackets(robot: Robot, chain: Chain) -> tuple[Transform, list[Transform]]:
    """B, and P_1 … P_n."""
    gathered = Transform.identity()
    for edge in chain.climbed:
        gathered = gathered @ robot.joint_origin(edge).inverse()
    pieces = []
    for edge in chain.descended:
        gathered = gathered @ robot.joint_origin(edge)
        if edge.moves:
            pieces.append(gathered)
            gathered = Transform.identity()
    return pieces[0], [*pieces[1:], gathered]


def _moving_link(
    robot: Robot, name: str, far_end: Transform, chain: Chain, notes: list[str]
) -> Link:
    """The link `name` with all that moves with it, in the frame at its far end."""
    moving = frozenset(edge.joint for edge in chain.moving)
    parts, welded, held, has_extent = [], [], [], False
    for way in robot.tree.rigid_group(name, chain):
        member = way[-1].child if way else name
        poses = (robot.held_pose(edge, moving) for edge in way)
        pose = reduce(matmul, poses, Transform.identity())
        own = robot.inertia(member)
        if own is not None:
            parts.append(own.expressed_in(pose))
            has_extent = has_extent or bool(own.tensor.any())
            if way and own.mass > 0.0:
                welded.append((member, parts[-1]))
        if way and way[-1].moves:
            held.append(way[-1].joint)
    if not parts:
        problem = "moves, but neither it nor anything fixed to it has an <inertial>"
        remedy = "give it one, or choose base= and tip= so that it is no part of the arm"
        robot.fail("link", name, "", problem, remedy)
    total = reduce(add, parts)
    is_last = name == chain.moving[-1].child
    if total.mass == 0.0 and is_last:
        problem = "mass zero on a moving tip: no torque would move it, so its motion is free"
        remedy = "give it a mass, or choose a tip= before it"
        robot.fail("link", name, " inertial/mass", problem, remedy)
    if total.mass > 0.0 and not has_extent:
        problem = "moves, but its inertia tensor is zero: not positive definite"
        robot.fail("link", name, " inertial/inertia", problem, "give the tensor of its mass")
    if total.mass == 0.0:
        notes.append(f"moving link {name!r} has mass zero")
    if welded:
        notes.append(f"merged into {name!r}: {_listed([member for member, _ in welded])}")
    if held:
        notes.append(f"held still, being outside the arm: {_listed(held)}")
    to_far_end = far_end.inverse()
    return Link(
        name,
        far_end,
        total.expressed_in(to_far_end),
        to_far_end,
        tuple((member, inertia.expressed_in(to_far_end)) for member, inertia in welded),
    )


def _listed(names: list[str]) -> str:
    return ", ".join(map(repr, names))
