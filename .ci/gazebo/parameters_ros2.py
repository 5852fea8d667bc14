"""ROS 2's own parser reads controllers.yaml, and gives each controller the joint it drives.

    parameters_ros2.py FILE.yaml JOINT…

A node is made under each controller's name, as the controller manager would make it.
"""

from __future__ import annotations

import sys

import rclpy
from rclpy.node import Node

file, *joints = sys.argv[1:]
rclpy.init(args=["--ros-args", "--params-file", file])


def parameters(name: str) -> dict[str, object]:
    """All that the file gives to the node /ur/NAME."""
    node = Node(name, namespace="ur", automatically_declare_parameters_from_overrides=True)
    return {key: parameter.value for key, parameter in node.get_parameters_by_prefix("").items()}


manager = parameters("controller_manager")
for number, joint in enumerate(joints, 1):
    name = f"joint{number}_effort_controller"
    if manager.get(f"{name}.type") != "forward_command_controller/ForwardCommandController":
        raise SystemExit(f"the controller manager knows no type for {name}: {manager}")
    own = parameters(name)
    if (own.get("joints"), own.get("interface_name")) != ([joint], "effort"):
        raise SystemExit(f"{name} drives {own}, not the effort of {joint!r}")
sys.stdout.write(f"ROS 2 reads {len(joints)} controllers, each with its own joint\n")
