"""The text for an engine's own parser: the arm's URDF without what is not part of the arm.

Two things are removed from the user's file, because they are no part of the arm's dynamics and
stop parsers: shapes that are meshes (their files may be missing), and the motion of joints beside
the arm (a gripper's), which are fixed where our own reading fixes them.  Numbers stay exactly as
they are written.
"""

from __future__ import annotations

from typing import Any

from lxml import etree

from .._errors import EngineError
from .._io.xml.safe_xml import parsed_xml
from .._robot.robot_tree import ArmOrTree

__all__ = ["parsed", "root_link", "text_for_engines", "written"]


def text_for_engines(arm: ArmOrTree) -> str:
    """The arm's URDF without meshes, joints beside the arm fixed.

    Raises EngineError if a joint beside the arm is held away from zero.
    """
    if arm.source.held:
        name, value = arm.source.held[0]
        raise EngineError(
            f"joint {name!r} beside the arm is held at {value:g}, which no engine can be given; "
            "choose a --tip without it"
        )
    root = parsed(arm)
    for link in root.iterchildren("link"):
        for shape in [*link.findall("visual"), *link.findall("collision")]:
            if shape.find("geometry/mesh") is not None:
                link.remove(shape)
    for joint in root.iterchildren("joint"):
        if joint.get("type") != "fixed" and joint.get("name") not in arm.joint_names:
            _fix(joint)
    return written(root)


def _fix(joint: Any) -> None:
    mimic = joint.find("mimic")
    if mimic is not None:
        if float(mimic.get("offset", "0")) != 0.0:
            raise EngineError(
                f"joint {joint.get('name')!r} beside the arm is placed away from zero by its "
                "<mimic>, which no engine can represent; choose a tip= without it, or remove the "
                "offset"
            )
        joint.remove(mimic)
    joint.set("type", "fixed")


def parsed(arm: ArmOrTree) -> Any:
    """The root element of the arm's URDF, which has passed the strict reading."""
    if arm.source.urdf is None:
        raise EngineError(f"arm {arm.name!r} did not come from a URDF")
    return parsed_xml(arm.source.urdf)


def written(root: Any) -> str:
    """A root element as text."""
    return str(etree.tostring(root, encoding="unicode")) + "\n"


def root_link(root: Any) -> str:
    """Name of the link that has no parent."""
    children = {joint.find("child").get("link") for joint in root.iterchildren("joint")}
    (name,) = (
        link.get("name") for link in root.iterchildren("link") if link.get("name") not in children
    )
    return str(name)
