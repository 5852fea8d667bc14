"""The arm that is read from a URDF is the one that Pinocchio's own parser reads."""

from __future__ import annotations

import hashlib

import numpy as np
import pinocchio as pin
import pytest

from kinematics_comparison import assert_same_inertias, assert_same_kinematics, only_these_joints
from ur5check._errors import ModelError
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._robot import Limits, SerialArm
from urdf_examples import GOOD, robot_path, spoiled

UR = {"base": "base_link", "tip": "tool0"}
ROBOTS = [
    ("ur3_robot.urdf", UR),
    ("ur3_gripper.urdf", UR),
    ("ur5_robot.urdf", UR),
    ("ur5_robot.urdf", {"base": "base", "tip": "ee_link"}),
    ("ur5_robot.urdf", {}),
    ("ur10_robot.urdf", UR),
    ("panda.urdf", {"tip": "panda_hand_tcp"}),
    ("panda.urdf", {"base": "panda_link2", "tip": "panda_hand"}),
    ("kinova.urdf", {"tip": "j2s6s200_end_effector"}),
    ("xarm7.urdf", {}),
    ("z1.urdf", {}),
    ("z1.urdf", {"tip": "gripperStator"}),
    ("so100.urdf", {"tip": "jaw"}),
    ("double_pendulum_continuous.urdf", {}),
    ("talos_left_arm.urdf", {"tip": "wrist_left_ft_link"}),
    ("baxter.urdf", {"base": "torso", "tip": "right_gripper"}),
    ("talos_reduced.urdf", {"base": "torso_2_link", "tip": "wrist_left_ft_link"}),
]
IDS = [f"{name}-{'-'.join(ends.values())}" for name, ends in ROBOTS]


def read(name: str, **ends: str) -> SerialArm:
    return read_urdf(robot_path(name).read_bytes(), file=name, **ends)


def changed(old: str, new: str, **ends: str) -> SerialArm:
    return read_urdf(spoiled(old, new), file="changed.urdf", **ends)


@pytest.mark.parametrize(("name", "ends"), ROBOTS, ids=IDS)
def test_the_chain_ends_where_pinocchio_puts_its_tip(name: str, ends: dict[str, str]) -> None:
    arm = read(name, **ends)
    model = pin.buildModelFromXML(robot_path(name).read_text())
    assert_same_kinematics(arm, model, arm.source.base, arm.source.tip)


@pytest.mark.parametrize(("name", "ends"), ROBOTS, ids=IDS)
def test_what_is_welded_weighs_as_in_pinocchio(name: str, ends: dict[str, str]) -> None:
    arm = read(name, **ends)
    model = pin.buildModelFromXML(robot_path(name).read_text())
    assert_same_inertias(arm, only_these_joints(model, arm.joint_names))


def test_quarter_turns_are_exact() -> None:
    arm = read_urdf(GOOD.encode(), file="good.urdf")
    assert arm.base.R.tolist() == [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]


def test_the_small_arm_is_bracketed_and_named() -> None:
    arm = read_urdf(GOOD.encode(), file="good.urdf")
    assert (arm.name, arm.joint_names) == ("two", ("j1", "j2"))
    assert [link.name for link in arm.links] == ["upper", "lower"]
    assert [joint.kind for joint in arm.joints] == ["revolute", "prismatic"]
    assert arm.joints[0].limits == Limits(-1.5, 2.5, 3.0, 10.0)
    np.testing.assert_allclose(arm.joints[1].axis, [0.0, 0.6, 0.8], atol=1e-16)
    assert arm.links[0].link_tip_frame.p.tolist() == [0.3, 0.0, 0.5]
    assert arm.links[1].link_tip_frame.p.tolist() == [0.0, 0.0, 0.05]
    assert arm.links[1].inertia.com.tolist() == [0.0, 0.0, -0.05]
    assert arm.links[1].source_frame.p.tolist() == [0.0, 0.0, -0.05]
    assert (arm.source.base, arm.source.tip, arm.source.urdf) == ("base", "tool", GOOD)
    assert arm.source.inputs == (("good.urdf", hashlib.sha256(GOOD.encode()).hexdigest()),)


def test_a_continuous_joint_is_one_unbounded_angle() -> None:
    arm = changed('type="revolute"', 'type="continuous"')
    assert arm.joints[0].kind == "revolute"
    assert arm.joints[0].limits == Limits(velocity=3.0, effort=10.0)


def test_an_axis_left_out_is_x() -> None:
    assert changed('<axis xyz="0 0 1"/>', "").joints[0].axis.tolist() == [1.0, 0.0, 0.0]


def test_two_fixed_ends_leave_the_last_moving_link_as_tip_and_say_so() -> None:
    arm = read("ur5_robot.urdf")
    assert arm.source.tip == "wrist_3_link"
    assert any("'ee_link', 'tool0'" in note for note in arm.source.notes)


def test_fingers_beside_the_arm_are_held_still_and_reported() -> None:
    arm = read("panda.urdf", tip="panda_link8")
    (held,) = [note for note in arm.source.notes if note.startswith("held still")]
    assert "panda_finger_joint1" in held
    assert "panda_finger_joint2" in held


SIDE = """<joint name="side" type="{kind}"><origin xyz="0 0 1"/><parent link="{parent}"/>
<child link="extra"/><axis xyz="1 0 0"/><limit lower="0" upper="1" effort="1" velocity="1"/>{more}
</joint><link name="extra"><inertial><mass value="3"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>"""


def with_side(parent: str, kind: str = "prismatic", more: str = "", **ends: str) -> SerialArm:
    side = SIDE.format(kind=kind, parent=parent, more=more)
    return changed("</robot>", side, **ends)


def test_a_mimicking_finger_is_held_where_its_offset_puts_it() -> None:
    master = SIDE.format(kind="prismatic", parent="lower", more="").replace("</robot>", "")
    finger = SIDE.format(
        kind="prismatic", parent="lower", more='<mimic joint="side" multiplier="2" offset="0.25"/>'
    )
    finger = finger.replace('"side" type', '"finger" type').replace('"extra"', '"tip2"')
    arm = changed("</robot>", master + finger, tip="lower")
    assert arm.links[1].inertia.mass == 1.0 + 3.0 + 3.0
    np.testing.assert_allclose(arm.links[1].inertia.com, [3 * 0.25 / 7, 0.0, 6 / 7])


def test_what_hangs_on_the_base_does_not_count() -> None:
    arm = with_side("base", tip="tool")
    assert [link.inertia.mass for link in arm.links] == [2.0, 1.0]


def test_floating_and_planar_joints_beside_the_arm_are_held() -> None:
    for kind in ("floating", "planar"):
        assert with_side("lower", kind, tip="lower").links[1].inertia.mass == 4.0


def test_a_massless_link_may_move_inside_but_is_noted() -> None:
    arm = changed(
        '<mass value="2.0"/>\n      <inertia ixx="0.02" ixy="0.001" ixz="0" iyy="0.03" iyz="0" '
        'izz="0.04"/>',
        '<mass value="0"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>',
    )
    assert arm.links[0].inertia.mass == 0.0
    assert arm.source.notes == ("moving link 'upper' has mass zero",)


LOWER = """<inertial>
      <mass value="1.0"/>
      <inertia ixx="0.010" ixy="0" ixz="0" iyy="0.010" iyz="0" izz="0.010"/>
    </inertial>"""
ZERO = LOWER.replace("0.010", "0")
SLIDE = '<axis xyz="0 3 4"/>'

REFUSED = [
    ("planar", 'type="prismatic"', 'type="planar"', {}, 18, ["'j2'", "planar"]),
    ("floating", 'type="prismatic"', 'type="floating"', {}, 18, ["'j2'", "floating"]),
    ("mimic", SLIDE, SLIDE + '<mimic joint="j1"/>', {}, 18, ["'j2'", "mimics 'j1'"]),
    ("no inertial", LOWER, "", {}, 25, ["link 'lower'", "has an <inertial>"]),
    ("massless tip", LOWER, ZERO.replace("1.0", "0"), {}, 25, ["mass zero on a moving tip"]),
    ("point mass", LOWER, ZERO, {}, 25, ["'lower'", "not positive definite"]),
    ("unknown base", SLIDE, SLIDE, {"base": "bse"}, None, ["base", "did you mean 'base'?"]),
    ("unknown tip", SLIDE, SLIDE, {"tip": "tol"}, None, ["tip", "did you mean 'tool'?"]),
    ("backwards", SLIDE, SLIDE, {"base": "lower", "tip": "base"}, None, ["climbs", "'j2'"]),
    ("no joint", SLIDE, SLIDE, {"base": "lower"}, None, ["no moving joint"]),
    ("no joint to tip", SLIDE, SLIDE, {"tip": "base"}, None, ["no moving joint", "base="]),
]  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "ends", "line", "words"), [case[1:] for case in REFUSED],
    ids=[case[0] for case in REFUSED],
)  # fmt: skip
def test_what_is_no_arm_is_refused(
    old: str, new: str, ends: dict[str, str], line: int | None, words: list[str]
) -> None:
    with pytest.raises(ModelError) as caught:
        changed(old, new, **ends)
    assert (caught.value.file, caught.value.line) == ("changed.urdf", line), caught.value
    for word in words:
        assert word in str(caught.value)


def test_branches_that_are_alike_are_listed_to_choose_from() -> None:
    with pytest.raises(ModelError, match=r"--tip right_wrist \(7 joints\), --tip left_wrist"):
        read("baxter.urdf")


def test_an_arm_ends_before_its_fingers() -> None:
    arm = read("panda.urdf")
    assert (arm.n, arm.source.tip) == (7, "panda_link7")


def test_a_joint_beside_the_arm_that_follows_one_of_it_is_refused() -> None:
    with pytest.raises(ModelError, match="joint 'side' mimic: moves with joint 'j1'"):
        with_side("lower", more='<mimic joint="j1"/>', tip="lower")
    with pytest.raises(ModelError, match="joint 'panda_finger_joint2' mimic: moves with"):
        read("panda.urdf", tip="panda_leftfinger")


def test_mimics_that_follow_each_other_are_refused() -> None:
    first = SIDE.format(kind="prismatic", parent="lower", more='<mimic joint="second"/>')
    second = SIDE.format(kind="prismatic", parent="lower", more='<mimic joint="side"/>')
    second = second.replace('"side" type', '"second" type').replace('"extra"', '"extra2"')
    with pytest.raises(ModelError, match="follows itself"):
        changed("</robot>", first.replace("</robot>", "") + second, tip="lower")


def test_bytes_that_are_no_xml_are_refused_before_anything_else() -> None:
    with pytest.raises(ModelError, match=r"cut\.urdf:\d+: .*well-formed"):
        read_urdf(GOOD.encode()[:400], file="cut.urdf")


# Files of example-robot-data that are wrong, and are said to be.
@pytest.mark.parametrize(
    ("name", "tip", "rule", "element"),
    [
        ("ur3.urdf", None, "XML104", "robot"),
        ("allegro_left_hand.urdf", "link_11.0_tip", "INE103", "link 'link_11.0'"),
        ("romeo_laas_small.urdf", "l_wrist", "INE103", "link 'LShoulderYaw_link'"),
        ("icub.urdf", "head", "INE106", "link 'neck_1'"),
        ("pr2.urdf", "head_tilt_link", "INE103", "link 'sensor_mount_link'"),
    ],
)
def test_wrong_files_in_circulation_are_found(
    name: str, tip: str | None, rule: str, element: str
) -> None:
    with pytest.raises(ModelError) as caught:
        read(name, **({} if tip is None else {"tip": tip}))
    assert caught.value.rule == rule
    assert str(caught.value.element).startswith(element)


@pytest.mark.parametrize(
    ("name", "tip"), [("tiago.urdf", "wrist_ft_tool_link"), ("centauro.urdf", "arm1_6")]
)
def test_a_fault_elsewhere_in_such_a_file_does_not_matter(name: str, tip: str) -> None:
    assert read(name, tip=tip).source.faults == ()
