"""An arm written as MJCF reads back as the same arm, by MuJoCo itself too."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest

import ur5check
from examples import UR5S, random_arm
from ur5check._errors import ModelError, UsageError
from ur5check._io.mjcf.mjcf_reader import read_mjcf
from ur5check._io.mjcf.mjcf_writer import mjcf_of
from ur5check._io.round_trip import quaternion_pose, rpy_pose
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._io.urdf.urdf_writer import urdf_of
from ur5check._robot import Inertia, Limits, SerialArm, Transform
from ur5check._robot.states import random_states

# MuJoCo keeps a tensor as principal moments, which its eigenvalue solver finds to about 1e-12 of
# the largest; times accelerations of 10 to 100 rad/s² that is some 1e-11 N m.
MUJOCO = 1e-10
CHAINS = [(n, seed) for n in (1, 3, 7, 10) for seed in (0, 1, 2)]


def read_back(text: str) -> SerialArm:
    return read_mjcf(text.encode(), file="written.xml", folder=Path())


def without_comments(text: str) -> str:
    return re.sub(r"<!--.*?-->\n", "", text)


def torques(arm: SerialArm, count: int = 20) -> np.ndarray:
    states = random_states(arm.n, count, seed=1)
    return ur5check.rnea(arm, states.q, states.qd, states.qdd)


def torques_by_mujoco(text: str, n: int, count: int = 20) -> np.ndarray:
    """mj_inverse without constraints; what damping and friction take, given back."""
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    data = mujoco.MjData(model)
    states, found = random_states(n, count, seed=1), []
    for k in range(count):
        data.qpos[:], data.qvel[:], data.qacc[:] = states.q[k], states.qd[k], states.qdd[k]
        mujoco.mj_inverse(model, data)
        found.append(data.qfrc_inverse + data.qfrc_passive)
    return np.array(found)


@pytest.mark.parametrize("name", UR5S)
def test_shipped_model_reads_back_as_itself(name):
    arm = ur5check.load(name)
    again = read_back(mjcf_of(arm))
    assert (again.name, again.joint_names) == (arm.name, arm.joint_names)
    assert [link.name for link in again.links] == [link.name for link in arm.links]
    assert again.source.base == arm.source.base
    q = random_states(arm.n, 20, seed=1).q
    poses = [ur5check.forward_kinematics(a, q) for a in (arm, again)]
    np.testing.assert_allclose(*poses, rtol=0, atol=1e-14)
    kept = [replace(joint.limits, velocity=None) for joint in arm.joints]
    assert [joint.limits for joint in again.joints] == kept
    np.testing.assert_array_equal(again.gravity, arm.gravity)
    assert np.abs(torques(arm) - torques(again)).max() <= 1e-12 * np.abs(torques(arm)).max()


@pytest.mark.parametrize(("n", "seed"), CHAINS)
def test_any_chain_reads_back_as_itself(n, seed):
    arm = random_arm(n, seed=seed)
    again = read_back(mjcf_of(arm))
    assert np.abs(torques(arm) - torques(again)).max() <= 1e-12 * np.abs(torques(arm)).max()


@pytest.mark.parametrize("name", UR5S)
def test_mujoco_computes_the_same_torques(name):
    arm = ur5check.load(name)
    assert np.abs(torques_by_mujoco(mjcf_of(arm), arm.n) - torques(arm)).max() <= MUJOCO


@pytest.mark.parametrize(("n", "seed"), CHAINS)
def test_mujoco_computes_the_same_torques_of_any_chain(n, seed):
    arm = random_arm(n, seed=seed)
    assert np.abs(torques_by_mujoco(mjcf_of(arm), n) - torques(arm)).max() <= MUJOCO


@pytest.mark.parametrize("seed", range(40))
def test_written_twice_is_the_same_text(seed):
    arm = random_arm(5, seed=seed)
    mjcf, urdf = mjcf_of(arm), urdf_of(arm)
    assert without_comments(mjcf_of(read_back(mjcf))) == without_comments(mjcf)
    again = read_urdf(urdf.encode(), file="written.urdf")
    assert without_comments(urdf_of(again)) == without_comments(urdf)


@pytest.mark.parametrize("name", UR5S)
def test_shipped_model_written_twice_is_the_same_text(name):
    arm = ur5check.load(name)
    text = mjcf_of(arm)
    assert without_comments(mjcf_of(read_back(text))) == without_comments(text)


def test_numbers_are_those_that_somebody_wrote():
    text = mjcf_of(ur5check.load("appendix"))
    assert '<inertial pos="0.0 0.0 0.28" mass="8.393" diaginertia="0.22689067591036 ' in text
    assert 'pos="0.0 -0.1197 0.425"' in text
    assert not re.search(r"\d99999|00000\d", without_comments(text))


def test_motor_bearing_and_limits_are_carried():
    arm = random_arm(3, seed=4)
    joint = replace(
        arm.joints[1], armature=0.3, damping=0.2, friction=0.1, limits=Limits(-1.0, None, None, 7.0)
    )
    again = read_back(mjcf_of(replace(arm, joints=(arm.joints[0], joint, arm.joints[2])))).joints[1]
    assert (again.armature, again.damping, again.friction) == (0.3, 0.2, 0.1)
    assert again.limits == joint.limits


def test_velocity_limits_are_said_in_a_comment():
    assert "cannot carry velocity limits: shoulder_pan_joint 3.15" in mjcf_of(
        ur5check.load("appendix")
    )


def test_massless_links_share_a_body_with_the_next():
    """MuJoCo refuses a moving body without mass; several joints in one body say the same."""
    arm = random_arm(4, seed=6)
    inertias = [link.inertia for link in arm.links]
    inertias[0] = inertias[1] = Inertia.zero()
    arm = arm.with_inertias(inertias)
    text = mjcf_of(arm)
    again = read_back(text)
    assert again.joint_names == arm.joint_names
    assert np.abs(torques(arm) - torques(again)).max() <= 1e-12 * np.abs(torques(arm)).max()
    assert np.abs(torques_by_mujoco(text, 4) - torques(arm)).max() <= MUJOCO


def test_massless_tip_is_refused():
    arm = random_arm(2, seed=6)
    with pytest.raises(UsageError, match="the last link has no mass"):
        mjcf_of(arm.with_inertias([arm.links[0].inertia, Inertia.zero()]))


def test_odd_names_do_no_harm():
    arm = random_arm(2, seed=1)
    links = tuple(replace(link, name="world") for link in arm.links)
    joints = tuple(replace(joint, name='a<b>&"c"') for joint in arm.joints)
    again = read_back(mjcf_of(replace(arm, name="--x--->", links=links, joints=joints)))
    assert again.name == "--x--->"
    assert again.joint_names == ('a<b>&"c"', 'a<b>&"c"_joint')
    assert [link.name for link in again.links] == ["world_link", "world_link_2"]


def test_impossible_inertia_is_written_and_then_refused():
    arm = random_arm(1, seed=0)
    body = replace(arm.links[0].inertia, tensor=np.diag([1.0, 1.0, 3.0]))
    with pytest.raises(ModelError, match="triangle"):
        read_back(mjcf_of(arm.with_inertias([body])))


@pytest.mark.parametrize("seed", range(20))
def test_a_pose_reads_back_as_what_was_meant(seed):
    rng = np.random.default_rng(seed)
    quarter = rng.integers(-2, 3, 3) * np.pi / 2
    for rpy in (rng.uniform(-3, 3, 3), quarter):
        T = Transform.from_rpy(rng.normal(size=3), rpy)
        for pose in (rpy_pose(T), quaternion_pose(T)):
            np.testing.assert_allclose(pose.read.R, T.R, rtol=0, atol=3e-15)
            np.testing.assert_array_equal(pose.read.p, T.p)
    exact = Transform.from_rpy((0.0, 0.0, 0.0), quarter)
    np.testing.assert_array_equal(quaternion_pose(exact).read.R, exact.R)


def test_a_planted_fault_is_seen():
    """A millionth on one mass, or a quaternion with its scalar last, is no rounding."""
    arm = random_arm(4, seed=3)
    text = mjcf_of(arm)
    swapped = re.sub(r'quat="(\S+) (\S+ \S+ \S+)"', r'quat="\2 \1"', text)
    heavier = re.sub(r'mass="(\S+)"', lambda m: f'mass="{float(m[1]) * (1 + 1e-6)!r}"', text)
    for wrong in (swapped, heavier):
        assert np.abs(torques_by_mujoco(wrong, 4) - torques(arm)).max() > 100 * MUJOCO
