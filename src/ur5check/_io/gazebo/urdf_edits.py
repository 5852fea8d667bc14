"""Edits of a URDF's elements, each for one known issue of Gazebo (`gazebo_model` says which).

They change the given tree, and return sentences that describe the change.
"""

from __future__ import annotations

from lxml import etree

from ..._engines.adapters.gazebo import NO_LIMIT
from ..._robot import Transform
from ..number_text import exact, roll_pitch_yaw, triple
from ..robot_arm import RobotDescription
from ..urdf.urdf_chain import Chain
from ..xml.xml_numbers import Element
from .start_posture import HALF_TURN

__all__ = [
    "hold_still",
    "leave_out_control",
    "limit_turns",
]

_CONTROL = ("ros_control", "ros2_control")
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


def hold_still(root: Element, description: RobotDescription, chain: Chain) -> list[str]:
    """Fix every moving joint that is none of the arm's."""
    moving = frozenset(edge.joint for edge in chain.moving)
    held = []
    for link, edge in description.tree.above.items():
        if not edge.moves or edge.joint in moving:
            continue
        joint = next(node for node in root.iterchildren("joint") if node.get("name") == edge.joint)
        pose = description.held_pose(edge, moving)
        for part in joint.findall("*"):
            if part.tag in _OF_A_MOVING_JOINT:
                joint.remove(part)
        joint.set("type", "fixed")
        joint.append(_origin(pose))
        held.append(f"{edge.joint!r} (which moves {link!r})")
    return [f"Fixed, being outside the arm: {', '.join(held)}."] if held else []


def limit_turns(root: Element, chain: Chain) -> None:
    """Hold every turning joint of the arm within half a turn either way."""
    kinds = {edge.joint: edge.kind for edge in chain.moving}
    for joint in root.iterchildren("joint"):
        kind = kinds.get(joint.get("name"))
        if kind not in ("revolute", "continuous"):
            continue
        limit = joint.find("limit")
        if limit is None:
            limit = etree.SubElement(joint, "limit", effort=NO_LIMIT, velocity=NO_LIMIT)
        joint.set("type", "revolute")
        if kind == "continuous":
            lower, upper = -HALF_TURN, HALF_TURN
        else:  # URDF: a bound left out is 0
            lower, upper = float(limit.get("lower", 0.0)), float(limit.get("upper", 0.0))
        limit.set("lower", exact(max(lower, -HALF_TURN)))
        limit.set("upper", exact(min(upper, HALF_TURN)))


def _origin(T: Transform) -> Element:
    return etree.Element("origin", xyz=triple(T.p), rpy=triple(roll_pitch_yaw(T.R)))
