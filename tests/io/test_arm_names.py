"""An arm of several is chosen by the name that a person uses."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._cli.main import main
from ur5check._errors import UsageError
from ur5check._io.arm_names import tip_of_arm
from ur5check._io.robot_loading import read_robot
from ur5check._rules.examples import joint, link, robot


def two_arms() -> str:
    """Both arms on a waist, each of three joints, ending in fixed hands of other names."""
    parts = [joint("waist", child="torso"), link("torso")]
    for side, hand in (("left", "palm"), ("right", "hook")):
        above = "torso"
        for k in range(3):
            name = f"{side}_arm_{k}"
            parts += [joint(f"{side}_joint_{k}", parent=above, child=name), link(name)]
            above = name
        parts += [joint(f"{hand}_fixed", kind="fixed", parent=above, child=hand), link(hand)]
    parts += [joint("neck", parent="torso", child="arm_camera"), link("arm_camera")]
    return robot(*parts)


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "two.urdf"
    path.write_text(two_arms())
    return path


@pytest.mark.parametrize(
    ("name", "tip"),
    [
        ("left_arm_2", "left_arm_2"),  # the last link
        ("palm", "palm"),  # a link fixed to it
        ("left", "left_arm_2"),
        ("RIGHT", "right_arm_2"),
        ("arm_right", "right_arm_2"),
        ("camera", "arm_camera"),
        ("arm", "arm_camera"),  # how a name begins goes before a part of it
        ("right_joint_1", "right_arm_2"),  # a joint of this chain alone
    ],
)
def test_a_name_chooses_one_chain(file, name, tip):
    assert tip_of_arm(read_robot(file).robot, name) == tip
    arm = ur5check.load(file, arm=name)
    assert arm.source.tip == tip
    assert ur5check.judge(file, arm=name, samples=2).arm.source.tip == tip


@pytest.mark.parametrize("name", ["waist", "middle", "arm_2"])
def test_a_name_of_no_chain_or_of_several_lists_them(file, name):
    with pytest.raises(UsageError) as caught:
        ur5check.load(file, arm=name)
    assert all(tip in str(caught.value) for tip in ("left_arm_2", "right_arm_2"))
    assert ("arm_camera" in str(caught.value)) == (name != "arm_2")


def test_arm_and_tip_exclude_each_other(file):
    for function in (ur5check.load, ur5check.judge):
        with pytest.raises(UsageError):
            function(file, arm="left", tip="palm")


def test_an_arm_that_is_made_already_has_no_name_to_choose():
    with pytest.raises(UsageError):
        ur5check.load(ur5check.load("paper"), arm="left")


def test_commands_take_it(file, capsys):
    for command in (["validate", "--samples", "2"], ["show"]):
        assert main([*command, str(file), "--arm", "left", "--format", "json"]) == 0
        assert '"left_arm_2"' in capsys.readouterr().out
        assert main([*command, str(file), "--arm", "middle"]) == 2
        assert len(capsys.readouterr().err.splitlines()) <= 2
    models = [str(file), str(file)]
    chosen = ["--arm-a", "left", "--arm-b", "right"]
    assert main(["diff", *models, "--quick", "--samples", "2", *chosen]) == 0
    assert main(["diff", *models, "--quick", "--arm", "left"]) == 2
