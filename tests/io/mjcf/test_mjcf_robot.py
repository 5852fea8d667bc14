"""The whole tree of an MJCF: MuJoCo's own M and bias are the judge; every fault has its place."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

import ur5check
from ur5check import RobotTree
from ur5check._io.mjcf.mjcf_robot import read_mjcf_robot
from ur5check._rules.finding_log import FindingLog
from ur5check._validation.judgement import judge

BODY = '<inertial pos="0.01 0.02 0.1" mass="2" fullinertia="0.1 0.12 0.11 0.01 0.02 0.005"/>'
TWO_ARMS = f"""<mujoco model="two_arms">
  <compiler angle="degree"/>
  <default><joint armature="0.05" damping="1"/></default>
  <worldbody>
    <body name="trunk" pos="0 0 1" euler="10 20 30">{BODY}<joint name="lift" type="slide"/>
      <frame pos="0 0.2 0" euler="0 0 40">
        <body name="left" pos="0.1 0 0">{BODY}<joint name="l1" axis="1 2 0" pos="0 0 0.1"/>
          <joint name="l2" axis="0 0 3" ref="30"/>
          <body name="left_tip" pos="0.3 0 0"><geom type="box" size="0.1 0.05 0.02" pos="0.1 0 0"/>
            <joint name="l3" axis="0 1 0"/></body></body>
      </frame>
      <body name="right" pos="0 -0.2 0" quat="1 2 3 4">
        <inertial pos="0 0 0.1" mass="1" quat="1 1 0 1" diaginertia="0.1 0.2 0.15"/>
        <joint name="r1" axis="0 1 0" range="-90 45" frictionloss="0.5"/>
        <body name="sensor" pos="0 0 0.2">{BODY}</body></body>
    </body>
  </worldbody>
</mujoco>"""
HAND = f"""<mujoco model="hand"><option gravity="1 2 -9"/><worldbody>
  <body name="palm">{BODY}<freejoint/>
    <body name="f1" pos="0.1 0 0">{BODY}<joint name="j1" axis="0 1 0"/>
      <body name="f2" pos="0.1 0 0">{BODY}<joint name="j2" axis="0 1 0"/></body></body>
    <body name="f3" pos="0 0.1 0">{BODY}<joint name="j3" axis="1 0 0"/></body>
  </body></worldbody>
</mujoco>"""


def read(tmp_path, text):
    path = tmp_path / "robot.xml"
    path.write_text(text)
    return ur5check.load_robot(path)


def mujocos(text: str, tree: RobotTree, q, qd):
    """M, and the bias without acceleration, in the coordinates of the tree."""
    model = mujoco.MjModel.from_xml_string(text)
    data, M = mujoco.MjData(model), None
    rows = [int(model.joint(name).dofadr[0]) for name in tree.joint_names]
    for name, position, rate in zip(tree.joint_names, q, qd, strict=True):
        data.qpos[model.joint(name).qposadr[0]] = position
        data.qvel[model.joint(name).dofadr[0]] = rate
    mujoco.mj_forward(model, data)
    M = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, M)
    return M[np.ix_(rows, rows)], data.qfrc_bias[rows]


@pytest.mark.parametrize("text", [TWO_ARMS, HAND])
def test_mass_matrix_and_bias_of_the_tree_are_mujocos(tmp_path, text):
    tree = RobotTree.of(read(tmp_path, text))
    random = np.random.default_rng(5)
    for _ in range(5):
        q, qd = random.uniform(-1, 1, (2, tree.n))
        M, bias = mujocos(text, tree, q, qd)
        ours = ur5check.mass_matrix(tree, q)
        np.testing.assert_allclose(ours, M, rtol=0, atol=1e-10 * np.abs(M).max())
        tau = ur5check.rnea(tree, q, qd, np.zeros(tree.n))
        np.testing.assert_allclose(tau, bias, rtol=0, atol=1e-10 * max(1.0, np.abs(bias).max()))


def test_a_dropped_default_would_be_seen(tmp_path):
    """The planted fault: armature of a default class left out."""
    tree = RobotTree.of(read(tmp_path, TWO_ARMS.replace('armature="0.05"', "")))
    q = np.full(tree.n, 0.3)
    M, _ = mujocos(TWO_ARMS, tree, q, 0.0 * q)
    assert np.abs(ur5check.mass_matrix(tree, q) - M).max() > 0.01


def test_numbers_know_their_places(tmp_path):
    robot = read(tmp_path, TWO_ARMS)
    joint = robot.joint["r1"]
    lines = TWO_ARMS.splitlines()
    assert 'range="-90 45"' in lines[joint.at("upper").line - 1]
    assert lines[joint.at("upper").line - 1][joint.at("upper").column - 1 :].startswith("-90 45")
    place = robot.link["right"].inertial.place("mass")
    assert lines[place.line - 1][place.column - 1 :].startswith('1" quat')
    assert (joint.friction, joint.damping, joint.armature) == (0.5, 1.0, 0.05)
    assert robot.link["left_tip"].inertial.rounding == {}  # computed by MuJoCo, not printed
    (box,) = robot.link["left_tip"].shapes
    assert (box.kind, box.size) == ("collision", (0.2, 0.1, 0.04))


def test_a_linear_equality_makes_a_joint_follow_another(tmp_path):
    tie = '<equality><joint joint1="j2" joint2="j1" polycoef="0.1 2 0 0 0"/></equality></mujoco>'
    robot = read(tmp_path, HAND.replace("</mujoco>", tie))
    mimic = robot.joint["j2"].mimic
    assert (mimic.joint, mimic.multiplier, mimic.offset) == ("j1", 2.0, 0.1)
    assert RobotTree.of(robot).joint_names == ("j1", "j3")


def test_what_acts_beside_joints_is_a_note_and_stops_the_tree(tmp_path):
    weld = '<equality><weld body1="f2" body2="f3"/></equality></mujoco>'
    path = tmp_path / "r.xml"
    path.write_text(HAND.replace("</mujoco>", weld))
    found = judge(path, samples=5).findings
    assert {("TRE106", "note"), ("JNT115", "error")} & {(f.rule, f.severity) for f in found} == {
        ("TRE106", "note")
    }
    with pytest.raises(ur5check.ModelError, match="equality 'weld'"):
        RobotTree.of(ur5check.load_robot(path))


def faults(tmp_path, text):
    path = tmp_path / "r.xml"
    path.write_text(text)
    judgement = judge(path, samples=5)
    found = [f for f in judgement.findings if f.severity == "error"]
    return judgement, {(f.rule, f.subject, f.place.line) for f in found}


def test_all_faults_of_a_file_in_one_run(tmp_path):
    bad = TWO_ARMS.replace('mass="1" quat', 'mass="-1" quat').replace('"0 0 3"', '"0 0 0"')
    bad = bad.replace('range="-90 45"', 'range="90 45"')
    judgement, found = faults(tmp_path, bad)
    assert found == {
        ("INE101", "link 'right'", 13),
        ("JNT101", "joint 'l2'", 8),
        ("JNT105", "joint 'r1'", 14),
    }
    assert judgement.robot is not None
    assert not judgement.passed()


@pytest.mark.parametrize(
    ("old", "new", "rule", "line"),
    [
        ('frictionloss="0.5"', 'bad="0.5"', "XML109", 14),
        ('frictionloss="0.5"', 'frictionloss="0,5"', "XML103", 14),
        ('<body name="sensor"', '<composite/><body name="sensor"', "XML108", 15),
        ('name="l3"', 'name="l3" type="ball"', None, 0),
        ("two_arms", "two_arms", None, 0),
    ],
)
def test_each_fault_has_its_rule_and_line(tmp_path, old, new, rule, line):
    _, found = faults(tmp_path, TWO_ARMS.replace(old, new, 1))
    assert {(r, n) for r, _, n in found} == ({(rule, line)} if rule else set())


def test_a_compiler_that_crashes_or_never_ends_is_a_finding(tmp_path, monkeypatch):
    from ur5check._io.mjcf import mjcf_robot

    monkeypatch.setattr(mjcf_robot, "_MEMORY", 2**20)  # too little to start MuJoCo with
    log = FindingLog()
    assert read_mjcf_robot(TWO_ARMS.encode(), "r.xml", tmp_path, log) is None
    assert [finding.rule for finding in log.findings] == ["XML109"]
