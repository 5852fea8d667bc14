"""A URDF's text to a `Robot` with all that is wrong in it, or to a `SerialArm`."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from typing import Protocol

from ..._errors import ModelError
from ..._finding import Finding, Place
from ..._robot.robot import Robot
from ..._robot.serial_arm import SerialArm
from ..._rules.finding_log import FindingLog, finding_of
from ..arm_loading import load_arm
from ..model_format import ModelFile
from ..robot_arm import RobotDescription
from ..xml.xml_tree import XmlError, XmlNode, parse_xml
from .urdf_robot import read_urdf_robot

__all__ = ["description_of_arm", "read_robot_of_urdf", "read_urdf", "read_urdf_file"]

_OTHER_FORMATS = {
    "sdf": "this is an SDFormat file: name it .sdf",
    "mujoco": "this is a MuJoCo model: name it .xml",
    "COLLADA": "this is a mesh: give the robot's description",
}


def read_urdf_file(file: ModelFile) -> SerialArm:
    """The arm in a URDF.  Raises ModelError as `load_arm` does."""
    return read_urdf(file.data, file=file.label, base=file.base, tip=file.tip, strict=file.strict)


def read_urdf(
    data: bytes,
    *,
    file: str,
    base: str | None = None,
    tip: str | None = None,
    kind: str = "urdf",
    inputs: tuple[tuple[str, str], ...] = (),
    places: ElementPlaces | None = None,
    strict: bool = True,
) -> SerialArm:
    """The arm between two links of a URDF.  Raises ModelError as `load_arm` does.

    data, file, kind, inputs, places : as for `read_robot_of_urdf`
    base, tip, strict : as for `load_arm`
    """
    robot, findings = read_robot_of_urdf(data, file=file, kind=kind, inputs=inputs, places=places)
    return load_arm(robot, findings, base=base, tip=tip, strict=strict)


def description_of_arm(arm: SerialArm, file: str) -> tuple[RobotDescription, tuple[Finding, ...]]:
    """The robot in an arm's URDF text, joints beside the arm held where the arm has them.

    file : what errors and findings call the text
    """
    text = (arm.source.urdf or "").encode()
    robot, findings = read_robot_of_urdf(text, file=file)
    if robot is None:
        raise ModelError.of(findings[0])
    return RobotDescription(robot, dict(arm.source.held)), findings


class ElementPlaces(Protocol):
    """Where the elements of a text were written that was made from other files."""

    def attach(self, root: XmlNode) -> None:
        """Give each element its place."""


def read_robot_of_urdf(
    data: bytes,
    *,
    file: str,
    kind: str = "urdf",
    inputs: tuple[tuple[str, str], ...] = (),
    places: ElementPlaces | None = None,
) -> tuple[Robot | None, tuple[Finding, ...]]:
    """The robot that a URDF describes, None where it describes none, and all that is wrong.

    data : the file's bytes;  file : what findings and reports call it
    kind, inputs, places : of the robot, where the text was made from something else (xacro)
    """
    try:
        root = parse_xml(data, file)
    except XmlError as error:
        place = Place(file, error.line, error.column)
        return None, (finding_of("XML101", "file", error.problem, place, fix=error.fix),)
    if places is not None:
        places.attach(root)
    if root.tag != "robot" or "xmlns" in root.attributes:
        fix = _OTHER_FORMATS.get(root.tag, "a URDF's root is <robot>")
        if root.tag == "robot":
            fix = "remove the default namespace, xmlns=…: URDF has none"
        problem = f"the root element <{root.tag}> is not a URDF's"
        return None, (
            finding_of("XML102", f"<{root.tag}>", problem, root.place(), value=root.tag, fix=fix),
        )
    log = FindingLog()
    of_file = ((file, hashlib.sha256(data).hexdigest()),)
    robot = read_urdf_robot(root, log, kind=kind, inputs=inputs or of_file)
    return replace(robot, urdf=data.decode("utf-8")), tuple(log.findings)
