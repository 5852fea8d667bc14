"""Edits of a URDF's elements, each for one habit of Gazebo (`gazebo_model` says which).

They change the tree they are given, and return sentences for who reads the result.
"""

from __future__ import annotations

from lxml import etree

from ..arm import Transform
from ..errors import ModelError
from ..export.numbers import exact, roll_pitch_yaw, triple
from ..sources.urdf_chain import Chain
from ..sources.urdf_robot import Robot
from ..sources.xml_numbers import Element
from .joint_range import HALF_TURN

__all__ = [
    "fix_to_world",
    "give_base_mass",
    "hold_still",
    "leave_out_control",
    "limit_turns",
    "write_no_limit",
]

_CONTROL = ("ros_control", "ros2_control")
_NO_LIMIT = "1e16"  # SDFormat's own default for a bound that is not given
_BALL = """<link><inertial><mass value="1"/>
  <inertia ixx="0.004" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.004"/></inertial></link>"""
_OF_A_MOVING_JOINT = (
    "axis", "calibration", "dynamics", "limit", "mimic", "origin", "safety_controller",
)  # fmt: skip


def leave_out_control(root: Element) -> list[str]:
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


def hold_still(root: Element, robot: Robot, chain: Chain) -> list[str]:
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


def fix_to_world(root: Element, robot: Robot, file: str) -> None:
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


def give_base_mass(root: Element, robot: Robot, chain: Chain) -> list[str]:
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


def write_no_limit(root: Element) -> None:
    """SDFormat reads the largest double in 16 digits, which is more than the largest double."""
    for limit in root.iterfind("joint/limit"):
        for key, text in limit.attrib.items():
            if abs(float(text)) > float(_NO_LIMIT):
                limit.set(key, f"-{_NO_LIMIT}" if float(text) < 0.0 else _NO_LIMIT)


def limit_turns(root: Element, chain: Chain) -> None:
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


def _origin(T: Transform) -> Element:
    return etree.Element("origin", xyz=triple(T.p), rpy=triple(roll_pitch_yaw(T.R)))
