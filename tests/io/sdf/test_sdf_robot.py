"""The whole tree of an SDF: Drake's own M and bias are the judge; every fault has its place."""

from __future__ import annotations

import numpy as np
import pytest
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant

import ur5check
from ur5check import RobotTree
from ur5check._validation.judgement import judge

INERTIAL = """<inertial><pose>0.01 0.02 0.1 0.3 0.2 0.1</pose><mass>2</mass>
<inertia><ixx>0.01</ixx><ixy>1e-3</ixy><ixz>2e-3</ixz><iyy>0.012</iyy><iyz>5e-4</iyz><izz>0.011</izz>
</inertia></inertial>"""


def joint(name, kind, parent, child, xyz="0 1 0", more=""):
    axis = f"<axis><xyz>{xyz}</xyz>{more}</axis>" if kind != "fixed" else ""
    return (
        f'<joint name="{name}" type="{kind}"><parent>{parent}</parent><child>{child}</child>'
        f"{axis}</joint>\n"
    )


def link(name, pose="0 0 0 0 0 0", inertial=INERTIAL):
    return f'<link name="{name}"><pose>{pose}</pose>{inertial}</link>\n'


PARTS = {
    "base": link("base", "0 0 1 0.1 0.2 0.3"),
    "left": link("left", "0.3 0.1 1.2 0.4 0 0"),
    "tip": link("tip", "0.3 0.1 1.6 0 0.5 0"),
    "right": link("right", "-0.3 0 1.2 0 0 0.7"),
    "foot": joint("foot", "fixed", "world", "base"),
    "l1": joint("l1", "revolute", "base", "left", "1 2 3"),
    "l2": joint("l2", "prismatic", "left", "tip", "0 0 1"),
    "r1": joint("r1", "continuous", "base", "right", "1 0 0"),
}


def text_of(**parts: str) -> str:
    inside = "".join({**PARTS, **parts}.values())
    return f'<sdf version="1.9"><model name="two">\n{inside}</model></sdf>'


def write(tmp_path, **parts):
    path = tmp_path / "robot.sdf"
    path.write_text(text_of(**parts))
    return path


def drakes(tree, q, qd):
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(text_of(), "sdf")
    plant.Finalize()
    context = plant.CreateDefaultContext()
    rows = [plant.GetJointByName(name).velocity_start() for name in tree.joint_names]
    full_q, full_qd = np.zeros(plant.num_positions()), np.zeros(plant.num_velocities())
    full_q[rows], full_qd[rows] = q, qd
    plant.SetPositions(context, full_q)
    plant.SetVelocities(context, full_qd)
    bias = plant.CalcBiasTerm(context) - plant.CalcGravityGeneralizedForces(context)
    return plant.CalcMassMatrix(context)[np.ix_(rows, rows)], bias[rows]


def test_mass_matrix_and_bias_of_the_tree_are_drakes(tmp_path):
    tree = RobotTree.of(ur5check.load_robot(write(tmp_path)))
    random = np.random.default_rng(5)
    for _ in range(5):
        q, qd = random.uniform(-1, 1, (2, tree.n))
        M, bias = drakes(tree, q, qd)
        ours = ur5check.mass_matrix(tree, q)
        np.testing.assert_allclose(ours, M, rtol=0, atol=1e-10 * np.abs(M).max())
        tau = ur5check.rnea(tree, q, qd, np.zeros(tree.n))
        np.testing.assert_allclose(tau, bias, rtol=0, atol=1e-10 * np.abs(bias).max())


def test_a_dropped_inertial_pose_would_be_seen(tmp_path):
    """The planted fault."""
    bare = link("tip", "0.3 0.1 1.6 0 0.5 0", INERTIAL.replace("0.3 0.2 0.1<", "0 0 0<"))
    tree = RobotTree.of(ur5check.load_robot(write(tmp_path, tip=bare)))
    q = np.full(tree.n, 0.3)
    gap = ur5check.mass_matrix(tree, q) - drakes(tree, q, 0 * q)[0]
    assert np.abs(gap).max() > 1e-4


def test_a_mimic_joint_follows(tmp_path):
    numbers = "<multiplier>2</multiplier><offset>1</offset><reference>3</reference>"
    follow = f'<mimic joint="l1">{numbers}</mimic>'
    robot = ur5check.load_robot(
        write(tmp_path, r1=joint("r1", "continuous", "base", "right", "1 0 0", follow))
    )
    mimic = robot.joint["r1"].mimic
    assert (mimic.joint, mimic.multiplier, mimic.offset) == ("l1", 2.0, -5.0)


LIMIT = "<limit><lower>2</lower><upper>-2</upper></limit>"
NEGATIVE = INERTIAL.replace("<mass>2<", "<mass>-2<")


@pytest.mark.parametrize(
    ("parts", "rules"),
    [
        ({}, set()),
        ({"tip": link("tip", inertial=NEGATIVE), "l1": joint("l1", "revolute", "base", "left",
          "0 0 0")}, {("INE101", 7), ("JNT101", 12)}),
        ({"l1": joint("l1", "revolute", "base", "left", more=LIMIT)}, {("JNT105", 15)}),
        ({"l1": joint("l1", "hinge", "base", "left"), "tip": link("tip", inertial=NEGATIVE)},
         {("JNT100", 15), ("INE101", 8), ("TRE103", 5)}),
        ({"tip": link("tip", inertial="")}, {("XML104", 8)}),
        ({"tip": link("tip", pose="0 0")}, {("XML109", 8)}),
        ({"x": joint("x", "fixed", "tip", "right")}, {("TRE104", 18)}),
        ({"x": joint("x", "fixed", "tip", "nothing")}, {("TRE102", 18)}),
        ({"x": '<include><uri>model://x</uri></include>'}, {("XML108", 18)}),
    ],
)  # fmt: skip
def test_every_fault_is_found_with_its_line(tmp_path, parts, rules):
    judgement = judge(write(tmp_path, **parts), samples=5)
    found = {(f.rule, f.place.line) for f in judgement.findings if f.severity == "error"}
    assert {rule for rule, _ in found} == {rule for rule, _ in rules}
    assert judgement.passed() == (not rules)
    assert all(line > 0 for _, line in found)
