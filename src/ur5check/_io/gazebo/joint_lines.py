"""Blocks of lines with one entry for every joint, for the templates of a package.

Controllers are numbered in the arm's order, as the paper numbers them; joints keep their names.
"""

from __future__ import annotations

import json
import shlex
from collections.abc import Sequence
from xml.sax.saxutils import escape, quoteattr

from ..number_text import exact

__all__ = ["NAMESPACE", "joint_blanks", "yaml_list"]

#: Namespace of the arm in the paper's launch file.
NAMESPACE = "ur"

_FORWARD = "forward_command_controller/ForwardCommandController"


def joint_blanks(
    names: Sequence[str], start: Sequence[float], tau: Sequence[float]
) -> dict[str, str]:
    """The blanks with one entry for each joint.

    start : positions at the beginning [rad, m];  tau : torques that hold them [N m, N]
    """
    numbered = list(enumerate(names, 1))
    placed = list(zip(names, start, strict=True))
    return {
        "pose": yaml_list(start),
        "joints_flow": f"[{', '.join(map(_text, names))}]",
        # ROS 2
        "controller_types": "\n".join(
            f"    {_controller(i)}:\n      type: {_FORWARD}" for i, _ in numbered
        ),
        "controller_joints": "\n\n".join(
            f"/{NAMESPACE}/{_controller(i)}:\n  ros__parameters:\n"
            f"    joints: [{_text(name)}]\n    interface_name: effort"
            for i, name in numbered
        ),
        "joints_xacro": "\n".join(
            f'    <xacro:effort_joint name={quoteattr(name)} start="{exact(q)}"/>'
            for name, q in placed
        ),
        # ROS 1
        "controllers_ros1": "\n".join(
            f"  {_controller(i)}:\n    type: effort_controllers/JointEffortController\n"
            f"    joint: {_text(name)}"
            for i, name in numbered
        ),
        "controller_names": "\n".join(f"              {_controller(i)}" for i, _ in numbered),
        "joints_xacro_ros1": "\n".join(
            f"  <xacro:effort_joint name={quoteattr(name)}/>" for name in names
        ),
        "joints_spawned": "\n              ".join(
            f"-J {_argument(name)} {exact(q)}" for name, q in placed
        ),
        # both
        "table": "\n".join(
            f"| {name} | {round(q, 4) + 0.0} | {round(torque, 4) + 0.0} |"
            for (name, q), torque in zip(placed, map(float, tau), strict=True)
        ),
    }


def yaml_list(values: Sequence[float]) -> str:
    """Numbers as a YAML list, each with a decimal point: ROS 2 refuses mixed types."""
    return f"[{', '.join(exact(value) for value in values)}]"


def _controller(number: int) -> str:
    return f"joint{number}_effort_controller"


def _argument(text: str) -> str:
    """A word of a command line, inside an XML attribute."""
    return escape(shlex.quote(text), {'"': "&quot;"})


def _text(text: str) -> str:
    """A JSON string is a YAML string."""
    return json.dumps(text)
