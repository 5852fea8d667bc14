"""A DH table written and read is the same table."""

from __future__ import annotations

import tomllib
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from examples import UR5S, planar_arm, random_arm
from ur5check import strategies as ur5
from ur5check._errors import UsageError
from ur5check._io.dh.dh_frames import dh_frames
from ur5check._io.dh.dh_reader import read_dh
from ur5check._io.dh.dh_writer import dh_toml_of
from ur5check._robot import DHRow, Limits, Transform, arm_from_dh
from ur5check._robot.states import random_states


def assert_same(arm):
    again = read_dh(dh_toml_of(arm).encode("utf-8"), file="written.toml")
    assert (again.name, again.joint_names) == (arm.name, arm.joint_names)
    assert [j.limits for j in again.joints] == [j.limits for j in arm.joints]
    states = random_states(arm.n, 20, seed=2)
    taus = [ur5check.rnea(a, states.q, states.qd, states.qdd) for a in (arm, again)]
    np.testing.assert_allclose(*taus, rtol=0, atol=1e-12 * np.abs(taus[0]).max())


@pytest.mark.parametrize("name", ["paper", "paper-listing"])
def test_shipped_table_reads_back_as_itself(name):
    assert_same(ur5check.load(name))


lengths, angles = st.floats(-1, 1), st.floats(-np.pi, np.pi)
rows = st.lists(
    st.builds(
        DHRow, link=st.just(""), joint=st.just(""), d=lengths, a=lengths, alpha=angles,
        offset=angles, inertia=ur5.inertias(), kind=st.sampled_from(["revolute", "prismatic"]),
        limits=st.just(Limits(-1.0, 2.0, 3.0)),
    ),
    min_size=1, max_size=5,
)  # fmt: skip


@given(rows)
def test_any_standard_table_reads_back_as_itself(table):
    named = [replace(row, link=f"l{i}", joint=f"j{i}") for i, row in enumerate(table)]
    assert_same(arm_from_dh('a "quoted" name', named, gravity=(1.0, 2.0, -9.0)))


def test_lengths_are_those_of_the_table():
    body = ur5check.load("paper").links[0].inertia
    row = DHRow("l", 0.2, -0.3, np.pi / 2, body, "j", offset=0.7)
    text = dh_toml_of(arm_from_dh("one", [row]))
    assert "\nd = 0.2\na = -0.3\nalpha = 1.5707963267948966\noffset = 0.7\nmass" in text


def test_hand_written_reach_is_kept_where_d_and_a_do_not_give_it():
    text = dh_toml_of(ur5check.load("paper-listing"))
    assert "r = [0.0, 0.089159, 0.0]" in text


def torques_agree(a, b, tolerance=1e-12):
    states = random_states(a.n, 20, seed=2)
    tau_a, tau_b = (ur5check.rnea(arm, states.q, states.qd, states.qdd) for arm in (a, b))
    return np.abs(tau_a - tau_b).max() <= tolerance * np.abs(tau_a).max()


@pytest.mark.parametrize("name", UR5S)
def test_every_shipped_model_has_a_table(name):
    arm = ur5check.load(name)
    text = dh_toml_of(arm)
    again = read_dh(text.encode(), file="written.toml")
    assert torques_agree(arm, again)
    states = random_states(arm.n, 20, seed=2)
    poses = [ur5check.forward_kinematics(a, states.q) for a in (arm, again)]
    np.testing.assert_allclose(*poses, rtol=0, atol=1e-12)
    assert numbers_of(dh_toml_of(again)) == numbers_of(text)


def numbers_of(text):
    return [line for line in text.splitlines() if not line.startswith("#")]


def test_appendix_has_the_controllers_lengths():
    """Common normals of the URDF's axes: the DH parameters that the controller uses."""
    text = dh_toml_of(ur5check.load("appendix"))
    rows = tomllib.loads(text)["joint"]
    assert [row["d"] for row in rows] == [0.089159, 0.0, 0.0, 0.10915, 0.09465, 0.0823]
    assert [row["a"] for row in rows] == [0.0, 0.425, 0.39225, 0.0, 0.0, 0.0]
    assert "base" not in tomllib.loads(text) and "tool" not in tomllib.loads(text)


@pytest.mark.parametrize("n", [1, 2, 4, 7, 10])
@pytest.mark.parametrize("seed", range(4))
def test_any_chain_has_a_table(n, seed):
    arm = random_arm(n, seed=seed + 40)
    again = read_dh(dh_toml_of(arm).encode(), file="written.toml")
    assert torques_agree(arm, again)
    assert [j.kind for j in again.joints] == [j.kind for j in arm.joints]


def test_motor_and_bearing_are_carried():
    arm = random_arm(2, seed=1)
    joint = replace(arm.joints[0], armature=0.3, damping=0.2, friction=0.1)
    arm = replace(arm, joints=(joint, arm.joints[1]))
    again = read_dh(dh_toml_of(arm).encode(), file="written.toml").joints[0]
    assert (again.armature, again.damping, again.friction) == (0.3, 0.2, 0.1)


def test_axes_parallel_but_for_a_rounded_angle_are_refused():
    """Their common normal lies far away; to ignore the angle would be a silent repair."""
    arm = planar_arm((0.4, 0.3, 0.2), (1.0, 1.0, 1.0))
    arm = arm.with_inertias([replace(x.inertia, tensor=0.01 * np.eye(3)) for x in arm.links])
    assert torques_agree(arm, read_dh(dh_toml_of(arm).encode(), file="written.toml"))
    tilt = Transform.from_rpy((0.4, 0.0, 0.0), (0.0, 0.0, 1e-6))
    tilted = replace(arm, links=(replace(arm.links[0], link_tip_frame=tilt), *arm.links[1:]))
    with pytest.raises(UsageError, match="'joint_0' and 'joint_1' are all but parallel"):
        dh_toml_of(tilted)


def test_a_tip_that_is_all_but_parallel_is_left_to_the_tool():
    arm = planar_arm((0.4, 0.3), (1.0, 1.0))
    arm = arm.with_inertias([replace(x.inertia, tensor=0.01 * np.eye(3)) for x in arm.links])
    askew = Transform.from_rpy((0.3, 0.0, 0.0), (np.pi / 2 + 1e-6, 1e-6, 0.0))
    arm = replace(arm, links=(arm.links[0], replace(arm.links[1], link_tip_frame=askew)))
    text = dh_toml_of(arm)
    assert "\ntool = " in text
    again = read_dh(text.encode(), file="written.toml")
    assert torques_agree(arm, again)
    q = random_states(2, 5, seed=1).q
    poses = [ur5check.forward_kinematics(a, q) for a in (arm, again)]
    np.testing.assert_allclose(*poses, rtol=0, atol=1e-13)


def test_a_frame_left_where_it_was_would_be_seen():
    """The planted fault: DH rows with the inertias of the old frames."""
    arm = random_arm(3, seed=42)
    frames = dh_frames(arm)
    wrong = [replace(b, inertia=a.inertia) for a, b in zip(arm.links, frames.links, strict=True)]
    tip = wrong[-1]
    wrong[-1] = replace(tip, link_tip_frame=tip.link_tip_frame @ frames.tool)
    joints = tuple(replace(joint, axis=np.array([0.0, 0.0, 1.0])) for joint in arm.joints)
    moved = replace(arm, joints=joints, links=tuple(wrong), base=frames.base)
    assert not torques_agree(arm, moved, 1e-3)


def test_one_line_for_two_joints_has_a_table_whatever_its_frames():
    """The same axis twice, the frame's own x along it: x must come from elsewhere."""
    arm = planar_arm((0.0, 0.0), (1.0, 1.0))
    arm = arm.with_inertias([replace(x.inertia, tensor=0.01 * np.eye(3)) for x in arm.links])
    along_x = tuple(replace(joint, axis=np.array([1.0, 0.0, 0.0])) for joint in arm.joints)
    arm = replace(arm, joints=along_x)
    assert torques_agree(arm, read_dh(dh_toml_of(arm).encode(), file="written.toml"))
