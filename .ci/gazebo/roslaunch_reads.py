"""ROS 1's own roslaunch reads a launch file; is the arm's export all there?

    roslaunch_reads.py PACKAGE N FILE [ARGUMENT:=VALUE …]

N is the number of the arm's joints.  Run with the Python that has roslaunch.
"""

from __future__ import annotations

import sys
from xml.etree import ElementTree

from roslaunch.config import ROSLaunchConfig
from roslaunch.xmlloader import XmlLoader


def main(package: str, n: str, file: str, *arguments: str) -> None:
    """Print what was read; leave with a sentence if something is missing."""
    config = ROSLaunchConfig()
    XmlLoader().load(file, config, argv=list(arguments), verbose=False)
    params = {name: param.value for name, param in config.params.items()}
    nodes = {node.name: node for node in config.nodes}
    given = dict(argument.split(":=") for argument in arguments)
    controllers = [f"joint{i}_effort_controller" for i in range(1, int(n) + 1)]

    robot = ElementTree.fromstring(params["/robot_description"])  # noqa: S314 - our own file
    joints = {joint.get("name"): joint for joint in robot.findall("joint")}
    driven = [params.get(f"/ur/{name}/joint") for name in controllers]
    need(None not in driven, f"a controller is missing: {driven}")
    need(len(set(driven)) == int(n), f"two controllers drive one joint: {driven}")
    need(all(name in joints for name in driven), f"a driven joint is not in the model: {driven}")
    transmitted = {node.get("name") for node in robot.findall("transmission/joint")}
    need(set(driven) == transmitted, f"transmissions drive {transmitted}, controllers {driven}")
    spawned = nodes["controller_spawner"].args.split()
    need(spawned == ["joint_state_controller", *controllers], f"spawned: {spawned}")

    limited = given.get("limited") == "true"
    reach = max(float(joints[name].find("limit").get("upper")) for name in driven)
    need((reach < 3.2) == limited, f"limited is {limited}, and a joint turns to {reach}")
    need(("gazebo_gui" in nodes) == (given.get("gui") != "false"), "gui has no effect")
    model = nodes["spawn_gazebo_model"].args.split()
    need(("-unpause" in model) == (given.get("paused") != "true"), "paused has no effect")
    need(model[model.index("-z") + 1] == "0.1", "the arm is not spawned at 0.1 m")
    renamed = [tuple(pair) for pair in nodes["robot_state_publisher"].remap_args]
    need(renamed == [("/joint_states", "/ur/joint_states")], f"remapped: {renamed}")
    need(nodes["torque_publisher"].package == package, "the torque has no publisher")
    sys.stdout.write(
        f"roslaunch reads {' '.join(arguments) or 'the defaults'}: {len(nodes)} nodes\n"
    )


def need(true: bool, otherwise: str) -> None:
    """Leave with a sentence unless it is true."""
    if not true:
        raise SystemExit(otherwise)


if __name__ == "__main__":
    main(*sys.argv[1:])
