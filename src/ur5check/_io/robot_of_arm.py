"""A `SerialArm` as a `Robot` without branches, in the frames of its source."""

from __future__ import annotations

import numpy as np

from .._finding import Place
from .._robot.robot import Inertial, Robot, RobotJoint, RobotLink
from .._robot.serial_arm import SerialArm

__all__ = ["robot_of_arm"]


def robot_of_arm(arm: SerialArm, file: str) -> Robot:
    """The robot of this arm's links, each inertia in the frame that its source wrote it in."""
    base = arm.source.base
    links, joints = [RobotLink(base, None, place=Place(file))], []
    parent, before = base, arm.base
    for joint, link in zip(arm.joints, arm.links, strict=True):
        T_tip_source = link.source_frame  # from the frame the source wrote in to the tip frame
        here = link.inertia.expressed_in(T_tip_source.inverse())
        place = Place(file, element=f"link {link.name!r}")
        tensor = here.tensor
        entries = {
            f"i{a}{b}": float(tensor["xyz".index(a), "xyz".index(b)])
            for a, b in ("xx", "xy", "xz", "yy", "yz", "zz")
        }
        inertial = Inertial(here.mass, here.com, np.zeros(3), entries, places={"inertial": place})
        links.append(RobotLink(link.name, inertial, place=place))
        joints.append(
            RobotJoint(
                joint.name,
                joint.kind,
                parent,
                link.name,
                before,
                joint.axis,
                joint.axis,
                joint.limits,
                carried=link.link_tip_frame @ T_tip_source,
                damping=joint.damping,
                friction=joint.friction,
                armature=joint.armature,
                place=Place(file, element=f"joint {joint.name!r}"),
            )
        )
        parent, before = link.name, T_tip_source.inverse()
    return Robot(
        arm.name,
        tuple(links),
        tuple(joints),
        arm.source.kind,
        file,
        np.array(arm.gravity),
        arm.source.inputs,
    )
