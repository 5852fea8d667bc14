"""The inertia of every link that a joint carries as the file has it, and its known misreadings.

A `SerialArm` or `RobotTree` has one inertia per joint.  To name what an engine did to a link, the
links are needed one by one, with the known misreadings: the rotation of the `<inertial>` left out,
the body left out, a default body where none is written.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.robot import RobotLink
from ..._robot.robot_tree import ArmOrTree, RobotTree, tree_links
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from .audit_tolerances import tensor_rounding
from .import_difference import Kind
from .shape_masses import inertia_of_shapes

__all__ = ["Misreading", "WrittenArm", "WrittenBody", "written_arm"]

#: The default of engines that need an inertia for every link.
UNIT_BODY = Inertia(1.0, np.zeros(3), np.eye(3))


@dataclass(frozen=True, eq=False)
class Misreading:
    """A body read wrongly: `parameters` in frame i, shape (10,); `imported` describes it."""

    kind: Kind
    parameters: Array
    imported: str


@dataclass(frozen=True, eq=False)
class WrittenBody:
    """A link as the file has it.

    carried_by : index of the joint
    above : links on the way from the joint's own link to this one, nearest first
    parameters : of its `<inertial>` in frame i, shape (10,); zeros where it has none
    has_inertial, has_shape : whether the file gives it an `<inertial>`, and a shape
    """

    name: str
    carried_by: int
    above: tuple[str, ...]
    parameters: Array
    has_inertial: bool
    has_shape: bool
    misreadings: tuple[Misreading, ...]


@dataclass(frozen=True, eq=False)
class WrittenArm:
    """bodies : every link that moves, a joint's own before those fixed to it
    on_base : names of the links with a mass that no joint of the arm or tree carries
    """

    bodies: tuple[WrittenBody, ...]
    on_base: tuple[str, ...] = ()


@lru_cache(maxsize=4)  # the audits of all engines need the same arm
def written_arm(arm: ArmOrTree) -> WrittenArm:
    """The source of an arm or a tree, link by link."""
    if arm.source.urdf is None:
        return _of_values(arm)
    return _of_tree(arm, arm.source.urdf) if isinstance(arm, RobotTree) else _of_arm(arm)


def _of_tree(tree: RobotTree, urdf: str) -> WrittenArm:
    from ..._io.urdf.urdf_reader import read_robot_of_urdf

    robot, _ = read_robot_of_urdf(urdf.encode(), file=tree.name)
    assert robot is not None  # noqa: S101 - the tree was read from this text
    bodies, on_base = [], []
    aboves: dict[str, tuple[str, ...]] = {}
    for name, (i, pose) in tree.placements.items():
        link = robot.link[name]
        inertia = None if link.inertial is None else link.inertial.inertia
        if i < 0:
            on_base += [name] if inertia is not None and inertia.mass > 0.0 else []
            continue
        above: tuple[str, ...] = ()
        if name != tree.links[i].link.name:  # fixed to the moving link, or to what is
            parent = robot.above[name].parent
            above = (parent, *aboves[parent])
        aboves[name] = above
        bodies.append(_body(i, above, inertia, link, pose))
    return WrittenArm(tuple(bodies), tuple(on_base))


def _of_arm(arm: SerialArm) -> WrittenArm:
    from ..._io.urdf.urdf_reader import description_of_arm

    description, _ = description_of_arm(arm, arm.name)
    links = description.robot.link
    chain = description.tree.chain(arm.source.base, arm.source.tip)
    moving = frozenset(edge.joint for edge in chain.moving)
    bodies = []
    for i, edge in enumerate(chain.moving):
        poses = {edge.child: arm.links[i].link_tip_frame.inverse()}
        above: dict[str, tuple[str, ...]] = {edge.child: ()}
        for step in description.tree.rigid_group(edge.child, chain):
            poses[step.child] = poses[step.parent] @ description.held_pose(step, moving)
            above[step.child] = (step.parent, *above[step.parent])
        for name, pose in poses.items():
            bodies.append(_body(i, above[name], description.inertia(name), links[name], pose))
    carried = {body.name for body in bodies}
    on_base = tuple(
        name
        for name, link in links.items()
        if name not in carried and link.inertial is not None and link.inertial.mass > 0.0
    )
    return WrittenArm(tuple(bodies), on_base)


def _body(
    i: int, above: tuple[str, ...], inertia: Inertia | None, link: RobotLink, pose: Transform
) -> WrittenBody:
    """pose : of the link in frame i"""
    return WrittenBody(
        link.name,
        i,
        above,
        np.zeros(10) if inertia is None else inertia.expressed_in(pose).parameters(),
        inertia is not None,
        bool(link.shapes),
        tuple(_misreadings(inertia, link, pose)),
    )


def _of_values(arm: ArmOrTree) -> WrittenArm:
    """A DH table or a value: one body a joint."""
    lost = (Misreading("body-lost", np.zeros(10), "nothing"),)
    return WrittenArm(
        tuple(
            WrittenBody(each.link.name, i, (), each.link.inertia.parameters(), True, False, lost)
            for i, each in enumerate(tree_links(arm))
        )
    )


def _misreadings(written: Inertia | None, link: RobotLink, pose: Transform) -> list[Misreading]:
    if written is None:
        unit = UNIT_BODY.expressed_in(pose).parameters()
        found = [Misreading("default-inertia", unit, "1 kg and a unit tensor")]
        solid = inertia_of_shapes(link.shapes)
        if solid is not None:
            parameters = solid.expressed_in(pose).parameters()
            imported = f"{solid.mass:.4g} kg, its shape at the density of water"
            found.append(Misreading("shape-mass", parameters, imported))
        return found
    found = [Misreading("body-lost", np.zeros(10), "nothing")]
    rpy = np.zeros(3) if link.inertial is None else link.inertial.rpy
    R = Transform.from_rpy(np.zeros(3), rpy.tolist()).R
    unrotated = Inertia(written.mass, written.com, R.T @ written.tensor @ R)
    if np.abs(unrotated.tensor - written.tensor).max() > tensor_rounding(written.tensor):
        parameters = unrotated.expressed_in(pose).parameters()
        found.insert(0, Misreading("rotation-dropped", parameters, "the tensor not rotated"))
    return found
