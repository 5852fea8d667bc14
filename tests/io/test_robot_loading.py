"""`load_robot`: the whole file, or the first error in it."""

from __future__ import annotations

import pytest

from ur5check import ModelError, UsageError, load, load_robot
from ur5check._io.formats import FORMATS
from ur5check._io.ros_packages import example_robot_data
from ur5check._rules.examples import joint, link, robot

ROBOTS = example_robot_data() / "robots"


def test_all_branches_are_read():
    hand = load_robot(ROBOTS / "allegro_hand_description/urdf/allegro_left_hand.urdf")
    assert sum(joint.moves for joint in hand.joints) == 16
    assert len([name for name, below in hand.below.items() if not below]) == 4  # fingertips


def test_an_error_of_the_file_is_raised_with_its_place():
    file = ROBOTS / "alex_description/urdf/alex_psyonic_hands.urdf"
    with pytest.raises(ModelError) as caught:
        load_robot(file)
    error = caught.value
    assert (error.rule, error.element) == ("TRE102", "joint 'Left_index_q2'")
    line = file.read_text().splitlines()[error.line - 1]
    assert "<mimic" in line


def test_a_file_without_a_robot_is_refused(tmp_path):
    path = tmp_path / "broken.urdf"
    path.write_text("<robot name='r'><link")
    with pytest.raises(ModelError) as caught:
        load_robot(path)
    assert caught.value.rule == "XML101"


def test_the_root_of_an_xml_says_its_format(tmp_path):
    """A URDF may have a <mujoco> element for MuJoCo's compiler, and stays a URDF."""
    arm = robot(joint(), link(), joint("f", "fixed", "base", "box", axis="", limit=""), link("box"))
    urdf, mjcf = tmp_path / "u.xml", tmp_path / "m.xml"
    urdf.write_text(arm.replace("</robot>", "<mujoco><compiler/></mujoco></robot>"))
    mjcf.write_text(FORMATS["mjcf"].write(load("paper")))
    assert [one.name for one in load_robot(urdf).links] == ["base", "arm", "box"]
    assert len(load_robot(mjcf).links) == 9  # with the world and the tool


def test_a_file_that_is_not_there_is_wrong_usage(tmp_path):
    with pytest.raises(UsageError):
        load_robot(tmp_path / "absent.urdf")
