"""A URDF made fit for Gazebo, and the same with limited joints.

What Gazebo would do with the file as it is, and what is done about it:

- its base would fall over: the root is fixed to a link named `world`, which Gazebo knows;
- joints outside the arm would swing: they are fixed where ur5check holds them still;
- a base without mass would be dropped with the whole arm: it is given some, which nobody feels;
- "no limit", written as the largest double, would be out of range: it is written as SDFormat does;
- two control plugins would fight: transmissions and control plugins are left out, the package
  brings its own;
- a moving link without mass would be dropped, and all that hangs on it: it is refused.

Fixed joints stay: Gazebo's reader lumps them into the link above, as ur5check does.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from functools import reduce
from operator import matmul
from pathlib import Path

from lxml import etree

from ..arm import SerialArm, Transform
from ..arm.transforms import Array
from ..errors import ModelError
from ..export.numbers import exact, roll_pitch_yaw, triple
from ..sources.packages import PackageMap
from ..sources.urdf_chain import Chain
from ..sources.urdf_robot import Robot
from ..sources.urdf_strict import check_urdf
from ..sources.xml_numbers import Element
from .joint_range import HALF_TURN
from .package_meshes import take_meshes

__all__ = ["GazeboModel", "gazebo_model"]

_CONTROL = ("ros_control", "ros2_control")
_NO_LIMIT = "1e16"  # SDFormat's own default for a bound that is not given
_BALL = """<link><inertial><mass value="1"/>
  <inertia ixx="0.004" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.004"/></inertial></link>"""
_OF_A_MOVING_JOINT = (
    "axis", "calibration", "dynamics", "limit", "mimic", "origin", "safety_controller",
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class GazeboModel:
    """urdf, limited : `<robot>` elements as text, without a header
    meshes : files to copy, by their path inside the package
    gravity : of the arm, in the world's frame, shape (3,) [m/s²]
    notes : what was changed, in sentences
    """

    urdf: str
    limited: str
    meshes: dict[str, Path]
    gravity: Array
    notes: tuple[str, ...]


def gazebo_model(arm: SerialArm, *, package: str, packages: PackageMap, file: str) -> GazeboModel:
    """The model of an arm that came from a URDF's text.

    package : name of the ROS package that will hold it;  packages : where its meshes are found
    file : what errors call the text; relative mesh names are seen from its folder

    Raises ModelError for a moving link without mass.
    """
    assert arm.source.urdf is not None  # noqa: S101 - the caller's duty, not the user's
    root = check_urdf(arm.source.urdf.encode("utf-8"), file)
    robot = Robot(root, file)
    chain = robot.tree.chain(arm.source.base, arm.source.tip)
    _refuse_massless(arm, file)
    notes = [*_without_control(root), *_held_still(root, robot, chain)]
    _fix_to_world(root, robot, file)
    notes += _weighty_base(root, robot, chain)
    _write_no_limit(root)
    meshes, unread = take_meshes(root, package=package, packages=packages, folder=Path(file).parent)
    limited = copy.deepcopy(root)
    _limit(limited, chain)
    R_world_base = _held_way(robot, chain).R
    return GazeboModel(
        _text(root), _text(limited), meshes, R_world_base @ arm.gravity, (*notes, *unread)
    )


def _refuse_massless(arm: SerialArm, file: str) -> None:
    for link in arm.links:
        if link.inertia.mass == 0.0:
            raise ModelError(
                "moves and has mass zero: Gazebo drops such a link and all that hangs on it",
                remedy="give it a small mass and inertia",
                file=file,
                element=f"link {link.name!r}",
            )


def _without_control(root: Element) -> list[str]:
    """Take out what drives the joints, of whichever ROS."""
    taken = [*root.iterchildren("transmission", "ros2_control")]
    for gazebo in root.iterchildren("gazebo"):
        for plugin in gazebo.findall("plugin"):
            named = f"{plugin.get('filename')} {plugin.get('name')}"
            if any(control in named for control in _CONTROL):
                gazebo.remove(plugin)
                taken += [gazebo] if len(gazebo) == 0 else []
    for element in taken:
        root.remove(element)
    return ["The model's own transmissions and control plugins are left out."] if taken else []


def _held_still(root: Element, robot: Robot, chain: Chain) -> list[str]:
    """Fix every moving joint that is none of the arm's."""
    moving = frozenset(edge.joint for edge in chain.moving)
    held = []
    for link, edge in robot.tree.above.items():
        if not edge.moves or edge.joint in moving:
            continue
        joint = next(node for node in root.iterchildren("joint") if node.get("name") == edge.joint)
        pose = robot.held_pose(edge, moving)
        for part in joint.findall("*"):
            if part.tag in _OF_A_MOVING_JOINT:
                joint.remove(part)
        joint.set("type", "fixed")
        joint.append(_origin(pose))
        held.append(f"{edge.joint!r} (which moves {link!r})")
    return [f"Fixed, being outside the arm: {', '.join(held)}."] if held else []


def _fix_to_world(root: Element, robot: Robot, file: str) -> None:
    top = robot.tree.root
    if top == "world":
        return
    names = {node.get("name") for node in root.iterchildren("link", "joint")}
    if names & {"world", "world_joint"}:
        raise ModelError(
            "the name is taken: Gazebo keeps it for what the base is fixed to",
            remedy="rename it",
            file=file,
            element="link or joint 'world' or 'world_joint'",
        )
    joint = etree.Element("joint", name="world_joint", type="fixed")
    joint.append(etree.Element("parent", link="world"))
    joint.append(etree.Element("child", link=top))
    joint.append(_origin(Transform.identity()))
    root.insert(0, joint)
    root.insert(0, etree.Element("link", name="world"))


def _weighty_base(root: Element, robot: Robot, chain: Chain) -> list[str]:
    """Give mass to what is fixed to the world and has none: 1 kg in a ball of 0.1 m."""
    top = robot.tree.root
    fixed = [edge for edge in robot.tree.below[top] if edge not in chain.moving]
    heads = [edge.child for edge in fixed] if top == "world" else [top]
    notes = []
    for head in heads:
        ways = robot.tree.rigid_group(head, chain)
        bodies = (robot.inertia(way[-1].child if way else head) for way in ways)
        if any(body is not None and body.mass > 0.0 for body in bodies):
            continue
        link = next(node for node in root.iterchildren("link") if node.get("name") == head)
        link.extend(etree.fromstring(_BALL))
        notes.append(
            f"Link {head!r} has no mass, so Gazebo would drop it and all that hangs on it. Here it "
            "weighs 1 kg; being fixed to the world, it bears on no torque."
        )
    return notes


def _write_no_limit(root: Element) -> None:
    """SDFormat reads the largest double in 16 digits, which is more than the largest double."""
    for limit in root.iterfind("joint/limit"):
        for key, text in limit.attrib.items():
            if abs(float(text)) > float(_NO_LIMIT):
                limit.set(key, f"-{_NO_LIMIT}" if float(text) < 0.0 else _NO_LIMIT)


def _limit(root: Element, chain: Chain) -> None:
    """Hold every turning joint of the arm within half a turn either way."""
    kinds = {edge.joint: edge.kind for edge in chain.moving}
    for joint in root.iterchildren("joint"):
        kind = kinds.get(joint.get("name"))
        if kind not in ("revolute", "continuous"):
            continue
        limit = joint.find("limit")
        if limit is None:
            limit = etree.SubElement(joint, "limit", effort=_NO_LIMIT, velocity=_NO_LIMIT)
        joint.set("type", "revolute")
        if kind == "continuous":
            lower, upper = -HALF_TURN, HALF_TURN
        else:  # URDF: a bound left out is 0
            lower, upper = float(limit.get("lower", 0.0)), float(limit.get("upper", 0.0))
        limit.set("lower", exact(max(lower, -HALF_TURN)))
        limit.set("upper", exact(min(upper, HALF_TURN)))


def _held_way(robot: Robot, chain: Chain) -> Transform:
    """T_world_base, all joints outside the arm held still."""
    moving = frozenset(edge.joint for edge in chain.moving)
    poses: list[Transform] = []
    link = chain.base
    while link in robot.tree.above:
        edge = robot.tree.above[link]
        poses.insert(0, robot.held_pose(edge, moving))
        link = edge.parent
    return reduce(matmul, poses, Transform.identity())


def _origin(T: Transform) -> Element:
    return etree.Element("origin", xyz=triple(T.p), rpy=triple(roll_pitch_yaw(T.R)))


def _text(root: Element) -> str:
    tidy = copy.deepcopy(root)
    etree.cleanup_namespaces(tidy)
    etree.indent(tidy)
    return str(etree.tostring(tidy, encoding="unicode", with_tail=False))
