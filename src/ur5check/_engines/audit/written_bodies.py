"""The inertia of every link that a joint carries as the file has it, and its known misreadings.

A `SerialArm` or `RobotTree` has one inertia per joint.  To name what an engine did to a link, the
links are needed one by one, with the known misreadings: the rotation of the `<inertial>` left out,
the body left out, a default body where none is written.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.robot_tree import ArmOrTree, RobotTree, tree_links
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from .audit_tolerances import tensor_rounding
from .import_difference import Kind
from .shape_masses import inertia_of_shapes

if TYPE_CHECKING:
    from lxml.etree import _Element

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
    from ..._io.urdf.urdf_robot import read_urdf_robot
    from ..._io.xml.safe_xml import parsed_xml
    from ..._io.xml.xml_tree import parse_xml
    from ..._rules.finding_log import FindingLog

    robot = read_urdf_robot(parse_xml(urdf.encode(), tree.name), FindingLog())
    nodes = {str(node.get("name")): node for node in parsed_xml(urdf).iterchildren("link")}
    bodies, on_base = [], []
    aboves: dict[str, tuple[str, ...]] = {}
    for name, (i, pose) in tree.placements.items():
        inertial = robot.link[name].inertial
        inertia = None if inertial is None else inertial.inertia
        if i < 0:
            on_base += [name] if inertia is not None and inertia.mass > 0.0 else []
            continue
        above: tuple[str, ...] = ()
        if name != tree.links[i].link.name:  # fixed to the moving link, or to what is
            parent = robot.above[name].parent
            above = (parent, *aboves[parent])
        aboves[name] = above
        bodies.append(_body(name, i, above, inertia, nodes[name], pose))
    return WrittenArm(tuple(bodies), tuple(on_base))


def _of_arm(arm: SerialArm) -> WrittenArm:
    from ..._io.urdf.urdf_checks import check_urdf
    from ..._io.urdf.urdf_values import Robot

    root = check_urdf(str(arm.source.urdf).encode(), arm.name)
    robot = Robot(root, arm.name)
    nodes = {str(node.get("name")): node for node in root.iterchildren("link")}
    chain = robot.tree.chain(arm.source.base, arm.source.tip)
    moving = frozenset(edge.joint for edge in chain.moving)
    bodies = []
    for i, edge in enumerate(chain.moving):
        poses = {edge.child: arm.links[i].link_tip_frame.inverse()}
        above: dict[str, tuple[str, ...]] = {edge.child: ()}
        for step in robot.tree.rigid_group(edge.child, chain):
            poses[step.child] = poses[step.parent] @ robot.held_pose(step, moving)
            above[step.child] = (step.parent, *above[step.parent])
        for name, pose in poses.items():
            bodies.append(_body(name, i, above[name], robot.inertia(name), nodes[name], pose))
    carried = {body.name for body in bodies}
    inertias = {name: robot.inertia(name) for name in nodes if name not in carried}
    on_base = tuple(name for name, inertia in inertias.items() if inertia and inertia.mass > 0.0)
    return WrittenArm(tuple(bodies), on_base)


def _body(
    name: str,
    i: int,
    above: tuple[str, ...],
    inertia: Inertia | None,
    node: _Element,
    pose: Transform,
) -> WrittenBody:
    """pose : of the link in frame i"""
    return WrittenBody(
        name,
        i,
        above,
        np.zeros(10) if inertia is None else inertia.expressed_in(pose).parameters(),
        inertia is not None,
        node.find("collision") is not None or node.find("visual") is not None,
        tuple(_misreadings(inertia, node, pose)),
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


def _misreadings(written: Inertia | None, node: _Element, pose: Transform) -> list[Misreading]:
    if written is None:
        unit = UNIT_BODY.expressed_in(pose).parameters()
        found = [Misreading("default-inertia", unit, "1 kg and a unit tensor")]
        solid = inertia_of_shapes(node)
        if solid is not None:
            parameters = solid.expressed_in(pose).parameters()
            imported = f"{solid.mass:.4g} kg, its shape at the density of water"
            found.append(Misreading("shape-mass", parameters, imported))
        return found
    found = [Misreading("body-lost", np.zeros(10), "nothing")]
    R = _written_rotation(node)
    unrotated = Inertia(written.mass, written.com, R.T @ written.tensor @ R)
    if np.abs(unrotated.tensor - written.tensor).max() > tensor_rounding(written.tensor):
        parameters = unrotated.expressed_in(pose).parameters()
        found.insert(0, Misreading("rotation-dropped", parameters, "the tensor not rotated"))
    return found


def _written_rotation(node: _Element) -> Array:
    """R of `<inertial><origin rpy>`: the strict reading has checked its three numbers."""
    origin = node.find("inertial/origin")
    rpy = "0 0 0" if origin is None else origin.get("rpy", "0 0 0")
    return Transform.from_rpy(np.zeros(3), [float(angle) for angle in rpy.split()]).R
