"""The expanded appendix against the paper's tables, number by number."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from functools import cache
from math import pi

import pytest

from ur5check._io.ros_packages import default_packages
from ur5check._io.shipped_models import SHIPPED_MODELS
from ur5check._io.xacro.xacro_reader import Expansion, expand_xacro

Element = ElementTree.Element

EFFORT = "hardware_interface/EffortJointInterface"
POSITION = "hardware_interface/PositionJointInterface"

# link: mass, radius, length, inertial xyz, inertial rpy, mesh
LINKS = {
    "base_link": (4.0, 0.06, 0.05, (0, 0, 0), (0, 0, 0), "base"),
    "shoulder_link": (3.7, 0.06, 0.15, (0, 0, 0), (0, 0, 0), "shoulder"),
    "upper_arm_link": (8.393, 0.06, 0.56, (0, 0, 0.28), (0, 0, 0), "upperarm"),
    "forearm_link": (2.275, 0.06, 0.39225, (0, 0, 0.39225 / 2), (0, 0, 0), "forearm"),
    "wrist_1_link": (1.219, 0.06, 0.12, (0, 0.093, 0), (0, 0, 0), "wrist1"),
    "wrist_2_link": (1.219, 0.06, 0.12, (0, 0, 0.09465), (0, 0, 0), "wrist2"),
    "wrist_3_link": (
        *(0.1879, 0.0375, 0.0345),
        *((0, 0.0823 - 0.0345 / 2, 0), (pi / 2, 0, 0), "wrist3"),
    ),
}
Y, Z = (0, 1, 0), (0, 0, 1)
# joint: parent, child, xyz, rpy, axis, effort, velocity, unlimited range
JOINTS = {
    "shoulder_pan_joint": (
        *("base_link", "shoulder_link", (0, 0, 0.089159), (0, 0, 0)),
        *(Z, 150, 3.15, 2 * pi),
    ),
    "shoulder_lift_joint": (
        *("shoulder_link", "upper_arm_link", (0, 0.13585, 0), (0, pi / 2, 0)),
        *(Y, 150, 3.15, 2 * pi),
    ),
    "elbow_joint": (
        *("upper_arm_link", "forearm_link", (0, -0.1197, 0.425), (0, 0, 0)),
        *(Y, 150, 3.15, pi),
    ),
    "wrist_1_joint": (
        *("forearm_link", "wrist_1_link", (0, 0, 0.39225), (0, pi / 2, 0)),
        *(Y, 28, 3.2, 2 * pi),
    ),
    "wrist_2_joint": (
        *("wrist_1_link", "wrist_2_link", (0, 0.093, 0), (0, 0, 0)),
        *(Z, 28, 3.2, 2 * pi),
    ),
    "wrist_3_joint": (
        *("wrist_2_link", "wrist_3_link", (0, 0, 0.09465), (0, 0, 0)),
        *(Y, 28, 3.2, 2 * pi),
    ),
}
# fixed joint: parent, child, xyz, rpy
FIXED = {
    "ee_fixed_joint": ("wrist_3_link", "ee_link", (0, 0.0823, 0), (0, 0, pi / 2)),
    "base_link-base_fixed_joint": ("base_link", "base", (0, 0, 0), (0, 0, -pi)),
    "wrist_3_link-tool0_fixed_joint": (
        *("wrist_3_link", "tool0", (0, 0.0823, 0), (-pi / 2, 0, 0)),
    ),
}
# What the source defines and nothing uses: it can only be seen in the file itself.
UNUSED = {
    "shoulder_cog": "0.0 0.00193 -0.02561",
    "upper_arm_cog": "0.0 -0.024201 0.2125",
    "forearm_cog": "0.0 0.0265 0.11993",
    "wrist_1_cog": "0.0 0.110949 0.01634",
    "wrist_2_cog": "0.0 0.0018 0.11099",
    "wrist_3_cog": "0.0 0.001159 0.0",
    "shoulder_radius": "0.060",
    "upper_arm_radius": "0.054",
    "elbow_radius": "0.060",
    "forearm_radius": "0.040",
    "wrist_radius": "0.045",
}


@cache
def expansion(**arguments: str) -> Expansion:
    path = SHIPPED_MODELS["appendix"].path()
    return expand_xacro(path, arguments=arguments, packages=default_packages())


def robot(**arguments: str) -> Element:
    return ElementTree.fromstring(expansion(**arguments).text)  # noqa: S314 - our own file


def child(element: Element, path: str) -> Element:
    found = element.findall(path)
    assert len(found) == 1, (element.tag, element.attrib, path, len(found))
    return found[0]


def numbers(text: str | None) -> tuple[float, ...]:
    assert text is not None
    return tuple(map(float, text.split()))


def same(values: tuple[float, ...] | list[float]) -> object:
    return pytest.approx(list(values), rel=1e-15, abs=1e-15)


def assert_origin(element: Element, xyz: tuple[float, ...], rpy: tuple[float, ...]) -> None:
    origin = child(element, "origin")
    assert list(numbers(origin.get("xyz"))) == same(xyz)
    assert list(numbers(origin.get("rpy"))) == same(rpy)


def test_it_expands_without_a_warning_from_four_files() -> None:
    assert expansion().warnings == ()
    assert [name.rpartition("/")[2] for name, _ in expansion().inputs] == [
        *("ur5_robot.urdf.xacro", "ur5.urdf.xacro"),
        *("ur.transmission.xacro", "ur.gazebo.xacro"),
    ]


def test_it_has_these_links_and_joints_and_no_other() -> None:
    arm = robot()
    assert arm.get("name") == "ur5"
    assert [link.get("name") for link in arm.findall("link")] == [
        *LINKS,
        "ee_link",
        "base",
        "tool0",
    ]
    kinds = {joint.get("name"): joint.get("type") for joint in arm.findall("joint")}
    assert kinds == dict.fromkeys(JOINTS, "revolute") | dict.fromkeys(FIXED, "fixed")


@pytest.mark.parametrize("name", LINKS)
def test_a_link_weighs_what_its_cylinder_does(name: str) -> None:
    mass, radius, length, xyz, rpy, _ = LINKS[name]
    inertial = child(robot(), f"link[@name='{name}']/inertial")
    assert_origin(inertial, xyz, rpy)
    assert numbers(child(inertial, "mass").get("value")) == (mass,)
    entries = {key: float(value) for key, value in child(inertial, "inertia").attrib.items()}
    across = 0.0833333 * mass * (3 * radius**2 + length**2)
    expected = {"ixx": across, "iyy": across, "izz": 0.5 * mass * radius**2}
    assert entries == pytest.approx(
        expected | dict.fromkeys(("ixy", "ixz", "iyz"), 0.0), rel=1e-14, abs=0
    )


@pytest.mark.parametrize("name", LINKS)
def test_a_link_is_drawn_by_its_meshes_which_exist(name: str) -> None:
    link = child(robot(), f"link[@name='{name}']")
    mesh = LINKS[name][-1]
    for use, ending in (("visual", "dae"), ("collision", "stl")):
        uri = child(link, f"{use}/geometry/mesh").get("filename")
        assert uri == f"package://ur_description/meshes/ur5/{use}/{mesh}.{ending}"
        assert default_packages().resolve(uri, SHIPPED_MODELS["appendix"].path().parent).is_file()
    material = child(link, "visual/material")
    assert material.get("name") == "LightGrey"
    assert numbers(child(material, "color").get("rgba")) == (0.7, 0.7, 0.7, 1.0)


@pytest.mark.parametrize("name", JOINTS)
def test_a_joint_sits_and_turns_where_the_table_says(name: str) -> None:
    parent, moved, xyz, rpy, axis, *_ = JOINTS[name]
    joint = child(robot(), f"joint[@name='{name}']")
    assert child(joint, "parent").get("link") == parent
    assert child(joint, "child").get("link") == moved
    assert_origin(joint, xyz, rpy)
    assert numbers(child(joint, "axis").get("xyz")) == axis
    dynamics = {key: float(value) for key, value in child(joint, "dynamics").attrib.items()}
    assert dynamics == {"damping": 0.0, "friction": 0.0}


@pytest.mark.parametrize("limited", ["false", "true"])
@pytest.mark.parametrize("name", JOINTS)
def test_a_joint_has_the_limits_of_the_table(name: str, limited: str) -> None:
    *_, effort, velocity, unlimited = JOINTS[name]
    turn = pi if limited == "true" else unlimited
    joint = child(robot(limited=limited), f"joint[@name='{name}']")
    limit = {key: float(value) for key, value in child(joint, "limit").attrib.items()}
    assert limit == {"lower": -turn, "upper": turn, "effort": effort, "velocity": velocity}
    assert joint.find("safety_controller") is None


@pytest.mark.parametrize("limited", ["false", "true"])
@pytest.mark.parametrize("name", JOINTS)
def test_soft_limits_lie_inside_and_the_elbows_are_as_printed(name: str, limited: str) -> None:
    arm = robot(limited=limited, safety_limits="true")
    safety = child(arm, f"joint[@name='{name}']/safety_controller")
    # Unlimited, every joint's soft limits are counted from 2π: the elbow's too, which turns by π.
    soft = (pi if limited == "true" else 2 * pi) - 0.15
    assert {key: float(value) for key, value in safety.attrib.items()} == {
        "soft_lower_limit": -soft,
        "soft_upper_limit": soft,
        "k_position": 20.0,
        "k_velocity": 0.0,
    }


@pytest.mark.parametrize("name", FIXED)
def test_a_fixed_joint_sits_where_the_table_says(name: str) -> None:
    parent, moved, xyz, rpy = FIXED[name]
    joint = child(robot(), f"joint[@name='{name}']")
    assert child(joint, "parent").get("link") == parent
    assert child(joint, "child").get("link") == moved
    assert_origin(joint, xyz, rpy)


def test_the_end_has_a_box_and_no_mass() -> None:
    end = child(robot(), "link[@name='ee_link']")
    assert end.find("inertial") is None
    collision = child(end, "collision")
    assert numbers(child(collision, "geometry/box").get("size")) == (0.01, 0.01, 0.01)
    assert_origin(collision, (-0.01, 0, 0), (0, 0, 0))
    assert not list(child(robot(), "link[@name='base']"))
    assert not list(child(robot(), "link[@name='tool0']"))


@pytest.mark.parametrize("interface", [EFFORT, POSITION])
def test_every_joint_has_one_transmission_of_the_wanted_kind(interface: str) -> None:
    arm = robot(transmission_hw_interface=interface)
    transmissions = arm.findall("transmission")
    assert [child(t, "joint").get("name") for t in transmissions] == list(JOINTS)
    for transmission in transmissions:
        assert child(transmission, "type").text == "transmission_interface/SimpleTransmission"
        assert child(transmission, "joint/hardwareInterface").text == interface
        assert child(transmission, "actuator/mechanicalReduction").text == "1"


def test_without_being_asked_the_joints_take_efforts() -> None:
    interfaces = {e.text for e in robot().findall("transmission/joint/hardwareInterface")}
    assert interfaces == {EFFORT}


def test_gazebo_knows_the_links_and_drives_the_joints_under_ur() -> None:
    told = {e.get("reference") for e in robot().findall("gazebo") if e.get("reference")}
    assert told == (set(LINKS) - {"base_link"}) | {"ee_link"}
    plugin = child(robot(), "gazebo/plugin")
    assert plugin.get("filename") == "libgazebo_ros_control.so"
    assert child(plugin, "robotNamespace").text == "/ur"


def test_a_prefix_changes_every_name_and_nothing_else() -> None:
    plain, prefixed = expansion().text, expansion(prefix="left_").text
    arm = robot(prefix="left_")
    named = [*arm.findall("link"), *arm.findall("joint"), *arm.findall("transmission")]
    assert all(element.get("name", "").startswith("left_") for element in named)
    assert prefixed.replace("left_", "") == plain


@pytest.mark.parametrize("name", UNUSED)
def test_numbers_that_nothing_uses_are_kept(name: str) -> None:
    macros = SHIPPED_MODELS["appendix"].path().with_name("ur5.urdf.xacro")
    tag = "{http://wiki.ros.org/xacro}property"
    found = [
        e.get("value")
        for e in ElementTree.parse(macros).iter(tag)  # noqa: S314 - our own file
        if e.get("name") == name
    ]
    assert found == [UNUSED[name]]
