"""The packages: read by those who read such files, and about one and the same arm."""

from __future__ import annotations

import ast
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import yaml
from catkin_pkg.package import InvalidPackage, parse_package
from lxml import etree

import ur5check
from examples import random_arm
from ur5check._errors import UsageError
from ur5check._io.gazebo.package_templates import fill, names_under
from ur5check._io.ros_packages import default_packages
from ur5check._io.xacro.xacro_reader import expand_xacro
from ur5check._paper.cases import case
from ur5check._robot import Inertia, Joint, Limits, Link, SerialArm, Transform

ROS = ("ros1", "ros2")
CASE_9 = case(9).joint_angles()[0]
PACKAGE = "appendix_gazebo"
CONTROLLERS = [f"joint{i}_effort_controller" for i in range(1, 7)]


@pytest.fixture(params=ROS)
def package(request, on_disk) -> Path:
    return on_disk / request.param / PACKAGE


def joint_names() -> list[str]:
    return list(ur5check.load("appendix").joint_names)


def test_package_xml_is_valid(package):
    parsed = parse_package(str(package), warnings=(said := []))
    assert not said
    assert parsed.name == PACKAGE
    built_with = {"ros1": "catkin", "ros2": "ament_cmake"}[package.parent.name]
    assert parsed.get_build_type() == built_with
    assert {"xacro", "robot_state_publisher", "std_msgs"} <= {d.name for d in parsed.exec_depends}


@pytest.mark.parametrize(
    ("written", "instead", "problem"),
    [
        ("<version>0.1.0</version>", "<version>first</version>", "version"),
        ("<name>appendix_gazebo</name>", "", "name"),
        (' email="ur5check@example.org"', "", "email"),
    ],
)
def test_a_faulty_package_xml_is_refused(package, tmp_path, written, instead, problem):
    text = (package / "package.xml").read_text()
    assert written in text
    (tmp_path / "package.xml").write_text(text.replace(written, instead))
    with pytest.raises(InvalidPackage, match=problem):
        parse_package(str(tmp_path))


def test_every_node_that_is_launched_is_depended_on(on_disk):
    launched = {
        "ros1": etree.parse(on_disk / "ros1" / PACKAGE / "launch/gazebo.launch").xpath("//@pkg"),
        "ros2": _keywords(on_disk / "ros2" / PACKAGE / "launch/gazebo.launch.py", "package"),
    }
    for ros, packages in launched.items():
        depended = {d.name for d in parse_package(str(on_disk / ros / PACKAGE)).exec_depends}
        assert set(packages) - {PACKAGE} <= depended
        assert len(set(packages)) >= 4


def _keywords(file: Path, keyword: str) -> list[str]:
    return [
        node.value.value
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.keyword) and node.arg == keyword
        and isinstance(node.value, ast.Constant)
    ]  # fmt: skip


def test_ros_2_controllers_drive_each_joint_once(on_disk):
    read = yaml.safe_load((on_disk / "ros2" / PACKAGE / "config/controllers.yaml").read_text())
    types = read.pop("/ur/controller_manager")["ros__parameters"]
    assert types.pop("joint_state_broadcaster")["type"].endswith("/JointStateBroadcaster")
    assert types.pop("update_rate") == 1000
    assert list(types) == CONTROLLERS
    assert list(read) == [f"/ur/{name}" for name in CONTROLLERS]
    parameters = [own["ros__parameters"] for own in read.values()]
    assert [p["joints"] for p in parameters] == [[name] for name in joint_names()]
    assert {p["interface_name"] for p in parameters} == {"effort"}


def test_ros_1_controllers_drive_each_joint_once(on_disk):
    read = yaml.safe_load((on_disk / "ros1" / PACKAGE / "config/controllers.yaml").read_text())[
        "ur"
    ]
    assert (
        read.pop("joint_state_controller")["type"] == "joint_state_controller/JointStateController"
    )
    assert list(read) == CONTROLLERS
    assert [own["joint"] for own in read.values()] == joint_names()
    assert {own["type"] for own in read.values()} == {"effort_controllers/JointEffortController"}


@pytest.mark.parametrize("limited", ["false", "true"])
def test_xacro_makes_one_robot_of_arm_and_drive(package, limited):
    expansion = expand_xacro(
        package / "urdf/gazebo.urdf.xacro",
        arguments={"limited": limited},
        packages=default_packages().with_packages({PACKAGE: package}),
    )
    robot = etree.fromstring(expansion.text.encode())
    reach = {float(x.get("upper")) for x in robot.iterfind("joint[@type='revolute']/limit")}
    assert (max(reach) == math.pi) == (limited == "true")
    if package.parent.name == "ros1":
        assert robot.xpath("transmission/joint/@name") == joint_names()
        assert robot.xpath("//robotNamespace/text()") == ["/ur"]
        return
    driven = robot.findall("ros2_control/joint")
    assert [joint.get("name") for joint in driven] == joint_names()
    for joint in driven:
        assert joint.xpath("command_interface/@name") == ["effort"]
        assert joint.xpath("state_interface/@name") == ["position", "velocity", "effort"]
    assert robot.xpath("//plugin/parameters/text()") == [f"{package}/config/controllers.yaml"]


def test_launch_arguments_are_those_of_the_paper(on_disk):
    root = etree.parse(on_disk / "ros1" / PACKAGE / "launch/gazebo.launch").getroot()
    one = {arg.get("name"): arg.get("default") for arg in root.iterfind("arg[@default]")}
    file = on_disk / "ros2" / PACKAGE / "launch/gazebo.launch.py"
    two = {
        call.args[0].value: next(k.value.value for k in call.keywords if k.arg == "default_value")  # type: ignore[attr-defined]
        for call in ast.walk(ast.parse(file.read_text()))
        if isinstance(call, ast.Call) and ast.unparse(call.func) == "DeclareLaunchArgument"
    }
    assert one == two == {"limited": "false", "paused": "false", "gui": "true", "z": "0.1"}


def test_python_compiles(on_disk):
    """No more can be had of ROS 2's launch file: no registry carries ROS 2's launch library."""
    files = sorted(on_disk.rglob("*.py"))
    assert len(files) == 5
    for file in files:
        compile(file.read_text(), str(file), "exec")


def test_every_file_opens_with_where_it_comes_from(appendix):
    _, digest = ur5check.load("appendix").source.inputs[0]
    for path, content in appendix.files.items():
        if "/meshes/" in path:
            continue
        opening = content.decode()[:1200]
        assert f"Written by ur5check {ur5check.__version__} from the model appendix" in opening, (
            path
        )
        assert digest in opening, path
        assert "ur5check export gazebo somewhere" in opening, path
        assert "@{" not in content.decode(), path
        if path.endswith((".xml", ".urdf", ".xacro", ".sdf", ".world", ".launch")):
            etree.fromstring(content)


def test_the_programs_print_the_torque_that_ur5check_computes(on_disk, appendix):
    """As the node asks for it: its own parameters, and the model that the package carries."""
    own = on_disk / "ros2" / PACKAGE
    given = yaml.safe_load((own / "config/torque.yaml").read_text())
    given = given["/ur/torque_publisher"]["ros__parameters"]
    request = {key: given[key] for key in ("pose", "base", "tip", "gravity")}
    request["model"] = str(own / "urdf/appendix.urdf")
    script = own / "scripts/gravity_torque.py"

    def asked(**changed):
        command = [sys.executable, script, json.dumps(request | changed)]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    printed = json.loads(asked().stdout)
    expected = ur5check.gravity_torque(ur5check.load("appendix"), CASE_9)
    np.testing.assert_allclose(printed, expected, atol=1e-14 * np.abs(expected).max())
    np.testing.assert_allclose(appendix.tau, expected, atol=1e-14 * np.abs(expected).max())
    refused = asked(pose=[0.0])
    assert refused.returncode == 1 and refused.stderr.startswith("ur5check: ")


def test_worlds_pull_with_the_models_own_gravity(packages_of):
    """Gazebo's empty world has 9.8; the listing computes with 9.806."""
    files = packages_of("paper-listing").files
    for world in ("ros1/paper_listing_gazebo/worlds/empty.world",
                  "ros2/paper_listing_gazebo/worlds/empty.sdf"):  # fmt: skip
        assert etree.fromstring(files[world]).xpath("//gravity/text()") == ["0.0 0.0 -9.806"]


@pytest.mark.parametrize("name", ["paper", "paper-listing"])
def test_a_dh_table_is_handed_over_as_a_urdf(packages_of, name):
    arm, pose = ur5check.load(name), CASE_9
    packages = packages_of(name, pose, ros=("2",))
    expected = ur5check.gravity_torque(arm, pose)
    np.testing.assert_allclose(packages.tau, expected, atol=1e-12 * np.abs(expected).max())
    assert not any("meshes" in path for path in packages.files)


@pytest.mark.parametrize("n", [1, 4])
def test_any_arm_has_a_controller_a_joint(packages_of, n):
    arm = random_arm(n, seed=n)
    files = packages_of(arm, [0.1] * n).files
    text = files[f"ros1/chain_{n}_gazebo/config/controllers.yaml"].decode()
    assert [c["joint"] for k, c in yaml.safe_load(text)["ur"].items() if "effort" in k] == list(
        arm.joint_names
    )


def test_odd_names_do_no_harm(packages_of):
    body = Inertia.from_entries(1.0, (0, 0, 0.1), ixx=0.1, iyy=0.1, izz=0.1)
    joint = Joint("a<b> & 'c': \"d\"", np.array([0.0, 0.0, 1.0]))
    arm = SerialArm("7 Of<9>", (joint,), (Link("l", Transform.identity(), body),))
    files = packages_of(arm, [0.5]).files
    for path, content in files.items():
        if path.endswith((".xml", ".urdf", ".xacro", ".sdf", ".world", ".launch")):
            etree.fromstring(content)
    two = yaml.safe_load(files["ros2/arm_7_of_9_gazebo/config/controllers.yaml"])
    assert two["/ur/joint1_effort_controller"]["ros__parameters"]["joints"] == [joint.name]


def limited_joint(lower: float, upper: float) -> SerialArm:
    body = Inertia.from_entries(1.0, (0, 0, 0.1), ixx=0.1, iyy=0.1, izz=0.1)
    joint = Joint("j", np.array([0.0, 1.0, 0.0]), limits=Limits(lower, upper))
    return SerialArm("one", (joint,), (Link("l", Transform.identity(), body),))


@pytest.mark.parametrize(
    ("asked", "start"),
    [(3.5, 3.5 - math.tau), (-3.5, math.tau - 3.5), (3.0, 3.0), (13.0, 13.0 - 2 * math.tau)],
)
def test_a_start_that_the_limited_model_cannot_hold_is_taken_a_turn_away(packages_of, asked, start):
    arm = limited_joint(-math.tau, math.tau)
    packages = packages_of(arm, [asked], ros=("2",))
    assert packages.start == (start,)
    assert any("whole turns" in note for note in packages.notes) == (asked != start)
    np.testing.assert_allclose(packages.tau, ur5check.gravity_torque(arm, [asked]), atol=1e-14)


@pytest.mark.parametrize("pose", [[2.0], [math.nan], [0.1, 0.2], []])
def test_a_start_that_cannot_be_is_refused(packages_of, pose):
    with pytest.raises(UsageError, match="--pose"):
        packages_of(limited_joint(-1.0, 1.0), pose)


def test_a_blank_that_nobody_fills_is_no_file():
    assert "launch/gazebo.launch.py" in names_under("ros2")
    with pytest.raises(KeyError):
        fill("ros2/package.xml", {})


def test_every_mesh_that_a_urdf_names_is_in_the_package(package):
    for variant in ("appendix", "appendix_limited"):
        names = etree.parse(package / f"urdf/{variant}.urdf").xpath("//mesh/@filename")
        assert len(names) == 14
        for name in names:
            inside = name.removeprefix(f"package://{PACKAGE}/")
            assert inside != name and (package / inside).stat().st_size > 0
