"""Which chain is the arm, without being told."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from ur5check._errors import ModelError, UsageError
from ur5check._io.robot_arm import arm_of_robot
from ur5check._io.robot_loading import read_robot
from ur5check._io.ros_packages import example_robot_data
from ur5check._rules.examples import joint, link, robot
from ur5check._validation.judgement import judge

ROBOTS = example_robot_data() / "robots"


def arm_of(file, **options):
    reading = read_robot(file)
    return arm_of_robot(reading.robot, **options)


@pytest.mark.parametrize(
    ("file", "n", "tip"),
    [
        ("panda_description/urdf/panda.urdf", 7, "panda_link7"),
        ("xarm_description/urdf/xarm7.urdf", 7, "link_eef"),
        ("z1_description/urdf/z1.urdf", 6, "link06"),
        ("so_arm_description/urdf/so100.urdf", 5, "gripper"),
        ("ur_description/urdf/ur5_robot.urdf", 6, "wrist_3_link"),
        ("tiago_description/robots/tiago_no_hand.urdf", 8, "wrist_ft_tool_link"),
    ],
)
def test_the_arm_ends_where_a_person_would_say(file, n, tip):
    arm = arm_of(ROBOTS / file)
    assert (arm.n, arm.source.tip) == (n, tip)


@pytest.mark.parametrize(
    ("file", "ends"),
    [
        ("baxter_description/urdf/baxter.urdf", {"left_wrist", "right_wrist"}),
        ("g1_description/urdf/g1_29dof_rev_1_0.urdf", {"left_wrist_yaw_link"}),
    ],
)
def test_several_arms_are_listed_with_the_option_for_each(file, ends):
    with pytest.raises(ModelError) as caught:
        arm_of(ROBOTS / file)
    assert all(f"--tip {end}" in str(caught.value) for end in ends)


def _write(tmp_path, *parts):
    file = tmp_path / "arm.urdf"
    file.write_text(robot(*parts))
    return file


FINGERS = (
    joint(),
    link(),
    joint("k", parent="arm", child="tip", origin='<origin xyz="0 0 0.4"/>'),
    link("tip", mass="1"),
    joint("l", parent="tip", child="hand", origin='<origin xyz="0 0 0.2"/>'),
    link("hand", mass="1"),
    joint("left", "prismatic", "hand", "lf", origin='<origin xyz="0.01 0 0.1"/>'),
    link("lf", mass="1"),
    joint("right", "prismatic", "hand", "rf", origin='<origin xyz="-0.01 0 0.1"/>'),
    link("rf", mass="1"),
)


def test_opposed_fingers_are_held_and_weigh(tmp_path):
    arm = arm_of(_write(tmp_path, *FINGERS))
    assert arm.joint_names == ("j", "k", "l")
    assert arm.links[-1].inertia.mass == 3.0


def test_a_finger_is_held_where_it_is_asked_to_be(tmp_path):
    file = _write(tmp_path, *FINGERS)
    closed, open_ = arm_of(file), arm_of(file, hold={"left": 0.05})
    moved = open_.links[-1].inertia.com - closed.links[-1].inertia.com
    # 1 kg of 3 moved by 0.05 m along the finger's axis, y.
    np.testing.assert_allclose(np.abs(moved), [0, 0.05 / 3, 0], atol=1e-15)


@pytest.mark.parametrize("joint_name", ["j", "nowhere"])
def test_a_joint_of_the_arm_or_of_nothing_is_not_held(tmp_path, joint_name):
    with pytest.raises(UsageError, match=joint_name):
        arm_of(_write(tmp_path, *FINGERS), hold={joint_name: 0.1})


def test_gravity_is_turned_into_the_base_asked_for(tmp_path):
    tilted = joint("m", "fixed", "base", "plate", origin='<origin rpy="1.5707963267948966 0 0"/>')
    file = _write(tmp_path, tilted, '<link name="plate"/>', joint(parent="plate"), link())
    whole, seen_from_plate = arm_of(file), arm_of(file, base="plate")
    np.testing.assert_allclose(whole.gravity, [0, 0, -9.81])
    np.testing.assert_allclose(seen_from_plate.gravity, [0, -9.81, 0], atol=1e-14)
    q = [[0.3], [-1.0]]
    np.testing.assert_allclose(
        ur5check.gravity_torque(seen_from_plate, q), ur5check.gravity_torque(whole, q), atol=1e-14
    )


def test_it_is_the_arm_that_load_gives():
    file = ROBOTS / "xarm_description/urdf/xarm7.urdf"
    ours, loaded = arm_of(file), ur5check.load(file)
    np.testing.assert_array_equal(ours.parameters(), loaded.parameters())
    np.testing.assert_array_equal(ours.base.matrix(), loaded.base.matrix())


def test_pinocchio_holds_a_finger_where_the_arm_has_it(tmp_path):
    judged = judge(_write(tmp_path, *FINGERS), hold={"left": 0.05}, samples=20)
    assert judged.arm.source.held == (("left", 0.05),)
    assert judged.laws is not None
    assert judged.laws_hold
