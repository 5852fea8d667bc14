"""An arm written as a URDF reads back as the same arm, by everyone who reads URDF."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from io import BytesIO

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from examples import UR5S, random_arm
from ur5check import strategies as ur5
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._errors import ModelError
from ur5check._io.number_text import as_written, exact, roll_pitch_yaw
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._io.urdf.urdf_writer import NO_LIMIT, urdf_of
from ur5check._robot import Inertia, Joint, Limits, Link, SerialArm, Source, Transform
from ur5check._robot.states import random_states


def read_back(arm: SerialArm) -> SerialArm:
    """Through our own strict reader; gravity, which no URDF carries, given again."""
    return read_urdf(urdf_of(arm).encode("utf-8"), file="written.urdf").with_gravity(arm.gravity)


def assert_same_torques(a, b, states, tolerance=1e-12):
    tau_a, tau_b = (ur5check.rnea(arm, states.q, states.qd, states.qdd) for arm in (a, b))
    assert np.abs(tau_a - tau_b).max() <= tolerance * max(np.abs(tau_a).max(), 1e-3)


@pytest.mark.parametrize("name", UR5S)
def test_shipped_model_reads_back_as_itself(name):
    arm = ur5check.load(name)
    again = read_back(arm)
    assert again.joint_names == arm.joint_names
    assert [link.name for link in again.links] == [link.name for link in arm.links]
    assert [joint.limits for joint in again.joints] == [joint.limits for joint in arm.joints]
    states = random_states(6, 500, seed=1)
    assert_same_torques(arm, again, states)
    poses = [ur5check.forward_kinematics(a, states.q) for a in (arm, again)]
    np.testing.assert_allclose(*poses, atol=1e-14)


@given(ur5.arms_and_states())
def test_any_arm_reads_back_as_itself(arm_and_states):
    arm, states = arm_and_states
    assert_same_torques(arm, read_back(arm), states)


@given(ur5.arms_and_states(max_joints=4))
def test_pinocchios_own_parser_reads_the_same_arm(arm_and_states):
    arm, states = arm_and_states
    engine = PinocchioEngine(read_back(arm))
    assert engine.route == "URDF text, own parser"
    tau = ur5check.rnea(arm, states.q, states.qd, states.qdd)
    theirs = engine.inverse_dynamics(states.q, states.qd, states.qdd)
    # Pinocchio's sin π is 1e-16, ours 0: a torque of zero is zero to rounding of the weight.
    weight = sum(link.inertia.mass for link in arm.links) * np.linalg.norm(arm.gravity)
    assert np.abs(tau - theirs).max() <= 1e-11 * max(np.abs(tau).max(), weight, 1e-3)


@pytest.mark.parametrize("number", range(5))
def test_check_urdf_and_yourdfpy_take_it(number, tmp_path):
    from yourdfpy import URDF

    arm = random_arm(6, seed=number)
    text = urdf_of(arm)
    parsed = URDF.load(BytesIO(text.encode()), build_scene_graph=False, load_meshes=False).robot
    assert [joint.name for joint in parsed.joints[:6]] == list(arm.joint_names)
    if shutil.which("check_urdf"):
        file = tmp_path / "arm.urdf"
        file.write_text(text, encoding="utf-8")
        said = subprocess.run(["check_urdf", file], capture_output=True, text=True, check=False)
        assert said.returncode == 0, said.stderr


def test_numbers_are_those_that_somebody_wrote():
    """From the link's frame to its tip frame and back costs rounding; the text shows none of it."""
    text = urdf_of(ur5check.load("appendix"))
    assert '<origin xyz="0.0 0.0 0.28" rpy="0 0 0"/>' in text
    assert '<inertia ixx="0.010267495893"' in text
    assert "999999" not in text and "000000001" not in text


angles = st.one_of(
    st.sampled_from([0.0, np.pi / 2, -np.pi / 2, np.pi]),
    st.floats(-np.pi, np.pi),
    st.floats(-1e-6, 1e-6).map(lambda x: np.pi / 2 + x),
    st.floats(-1e-6, 1e-6).map(lambda x: x - np.pi / 2),
)


@given(angles, angles, angles)
def test_angles_make_the_same_rotation_at_gimbal_lock_too(roll, pitch, yaw):
    R = Transform.from_rpy((0, 0, 0), (roll, pitch, yaw)).R
    again = Transform.from_rpy((0, 0, 0), roll_pitch_yaw(R)).R
    np.testing.assert_allclose(again, R, atol=2e-15)


def test_angles_read_off_one_by_one_would_fail_there():
    """The planted fault: the textbook formula next to gimbal lock."""
    worst = 0.0
    for seed in range(50):
        rng = np.random.default_rng(seed)
        turn = (rng.uniform(-3, 3), np.pi / 2 + rng.uniform(-1e-9, 1e-9), rng.uniform(-3, 3))
        there = Transform.from_rpy((0, 0, 0), rng.uniform(-3, 3, 3))
        # As rotations come about: products, each entry rounded by itself.
        R = (there.inverse() @ (there @ Transform.from_rpy((0, 0, 0), turn))).R
        textbook = (
            np.arctan2(R[2, 1], R[2, 2]),
            np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0])),
            np.arctan2(R[1, 0], R[0, 0]),
        )
        worst = max(worst, abs(Transform.from_rpy((0, 0, 0), textbook).R - R).max())
        again = Transform.from_rpy((0, 0, 0), roll_pitch_yaw(R)).R
        np.testing.assert_allclose(again, R, atol=2e-15)
    assert worst > 1e-9


def one_joint(kind="revolute", **limits) -> SerialArm:
    body = Inertia.from_entries(1.0, (0.1, 0, 0), ixx=0.1, iyy=0.2, izz=0.2)
    joint = Joint("j", np.array([0.0, 0.0, 1.0]), kind, Limits(**limits))
    return SerialArm("one", (joint,), (Link("l", Transform.identity(), body),))


def test_unknown_position_limits_make_a_continuous_joint():
    text = urdf_of(one_joint())
    assert 'type="continuous"' in text and "<limit" not in text and "Not known" not in text


def test_known_limits_are_kept_and_unknown_ones_not_invented():
    arm = one_joint(lower=-1.0, upper=2.0)
    text = urdf_of(arm)
    assert 'type="revolute"' in text
    assert f"Not known, and written as {exact(NO_LIMIT)}, which means no limit: j effort" in text
    again = read_back(arm).joints[0].limits
    assert again == Limits(-1.0, 2.0, NO_LIMIT, NO_LIMIT)


def test_sliding_joint_always_has_its_limit():
    again = read_back(one_joint("prismatic", effort=5.0)).joints[0]
    assert again.kind == "prismatic"
    assert again.limits == Limits(-NO_LIMIT, NO_LIMIT, NO_LIMIT, 5.0)


def test_gravity_is_said_in_a_comment():
    assert "(0.0 0.0 -9.806) m/s²" in urdf_of(ur5check.load("paper-listing"))
    assert "gravity" not in urdf_of(ur5check.load("paper"))


def test_header_names_version_and_inputs():
    arm = ur5check.load("paper")
    text = urdf_of(arm)
    assert f"written by ur5check {ur5check.__version__}" in text
    assert arm.source.inputs[0][1] in text


def test_odd_names_do_no_harm():
    body = Inertia.from_entries(1.0, (0, 0, 0.1), ixx=0.1, iyy=0.1, izz=0.1)
    joint = Joint('a<b>&"c"', np.array([0.0, 0.0, 1.0]))
    link = Link("base", Transform.translation((0, 0, 1)), body)
    arm = SerialArm(
        "--x--->", (joint, joint), (link, link), source=Source(notes=("one -- two --",), tip="base")
    )
    again = read_back(arm)
    assert again.joint_names == ('a<b>&"c"', 'a<b>&"c"_joint')
    assert [link.name for link in again.links] == ["base_link", "base_link_2"]
    assert again.source.tip == "tool"
    assert again.name == "--x--->"


def test_link_and_joint_of_one_name_are_told_apart():
    """`paper` calls its first joint as it calls its base; Pinocchio finds frames by name."""
    arm = ur5check.load("paper")
    assert arm.source.base == arm.joints[0].name
    PinocchioEngine(read_back(arm))


def test_impossible_inertia_is_written_and_then_refused():
    arm = one_joint()
    body = replace(arm.links[0].inertia, tensor=np.diag([1.0, 1.0, 3.0]))
    with pytest.raises(ModelError, match="triangle"):
        read_back(arm.with_inertias([body]))


def test_a_planted_fault_is_seen():
    """A millionth on one mass, or an inertia left in its far frame, does not read back."""
    arm = random_arm(4, seed=3)
    states = random_states(4, 20, seed=1)
    inertias = [link.inertia for link in arm.links]
    inertias[2] = replace(inertias[2], mass=inertias[2].mass * (1 + 1e-6))
    unmoved = [link.inertia.expressed_in(link.link_tip_frame.inverse()) for link in arm.links]
    for wrong in (inertias, unmoved):
        with pytest.raises(AssertionError):
            assert_same_torques(arm, read_back(arm.with_inertias(wrong)), states)


@pytest.mark.parametrize(
    ("value", "error", "written"),
    [
        (0.27999999999999997, 1e-16, "0.28"),
        (1e-18, 1e-17, "0.0"),
        (0.1234567890123456, 0.0, "0.1234567890123456"),
        (-0.0, 0.0, "0.0"),
        (5e-324, 0.0, "5e-324"),
    ],
)
def test_shortest_number_within_the_rounding(value, error, written):
    assert exact(as_written(value, error)) == written
