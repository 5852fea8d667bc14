"""Engines on whole robots: agreement over all joints, mimic joints, and planted faults."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import ur5check
from ur5check._engines.adapters.drake import DrakeEngine
from ur5check._engines.adapters.mujoco import MuJoCoEngine
from ur5check._engines.audit.engine_comparison import SAME_ROBOT, compare_engines
from ur5check._engines.engine_entry import EngineEntry
from ur5check._engines.registry import REFERENCE, REGISTRY, make_engine
from ur5check._errors import ModelError, UsageError
from ur5check._io.ros_packages import example_robot_data
from ur5check._robot.robot_tree import RobotTree
from ur5check._robot.states import random_states
from ur5check._rules.examples import joint, link, robot

ENGINES = {"pinocchio", "mujoco", "drake", "dart", "idyntree"}
#: File: engines that refuse it, and engines that have another inertia of a moving link.
ROBOTS = {
    "allegro_hand_description/urdf/allegro_left_hand.urdf": ({"mujoco"}, {"drake"}),
    "anymal_b_simple_description/robots/anymal.urdf": ({"mujoco"}, set()),
    "baxter_description/urdf/baxter.urdf": (set(), set()),
    "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf": (set(), {"dart"}),
    "pr2_description/urdf/pr2.urdf": ({"mujoco"}, {"drake", "dart"}),
    "talos_data/robots/talos_full_v2.urdf": (set(), set()),
    "tiago_pro_description/robots/tiago_pro.urdf": (set(), {"dart"}),
}
TALOS = "talos_data/robots/talos_full_v2.urdf"


def path(file):
    return example_robot_data() / "robots" / file


@cache
def report(file):
    return compare_engines(path(file), whole=True, samples=10)


@pytest.mark.parametrize("file", ROBOTS)
def test_engines_agree_on_a_whole_robot_or_say_why_not(file):
    refusing, differing = ROBOTS[file]
    found = report(file)
    assert found.whole
    assert {reading.key for reading in found.as_read.refusals} == refusing
    assert all(reading.refused.startswith("MuJoCo") for reading in found.as_read.refusals)
    assert {r.key for r in found.as_read.readings if r.harmful} == differing
    assert found.explained
    for key in ENGINES - refusing:
        there = found.as_read.matrix.between(REFERENCE, key)
        assert (there.torque > SAME_ROBOT) == (key in differing), key
        # What only the author of the file can correct is not repaired.
        repaired = found.final.matrix.between(REFERENCE, key)
        assert (repaired.torque > SAME_ROBOT) == (key in differing - {"dart"}), key
        assert there.tool <= 1e-12
        assert key in differing or there.mass <= 1e-12
        kinds = set(found.as_read.reading(key).imported.kinds)
        assert not {"joint-moved", "axis", "gravity", "tool"} & kinds, key
    assert found.final.agrees() == (not refusing and not differing - {"dart"})


def test_mimic_joints_have_no_coordinate_of_their_own():
    found = report(TALOS)
    assert (found.arm.n, len(found.arm.links), len(found.mimic)) == (32, 44, 12)
    drake = found.as_read.reading("drake")
    assert len(drake.imported.imported_model.joints) == 44
    assert drake.answers.mass.shape == (10, 32, 32)


def test_the_constraint_is_that_of_our_recursion():
    """Every answer of an engine of all joints, against the recursion on the constrained tree."""
    tree = RobotTree.of(ur5check.load_robot(path(TALOS)))
    states = random_states(tree.n, 3, seed=5)
    ours, theirs = (make_engine(key, tree) for key in (REFERENCE, "pinocchio"))
    for name, arguments in {
        "inverse_dynamics": (states.q, states.qd, states.qdd),
        "mass_matrix": (states.q,),
        "bias_torque": (states.q, states.qd),
        "gravity_torque": (states.q,),
        "forward_kinematics": (states.q,),
        "forward_dynamics": (states.q, states.qd, states.qdd),
    }.items():
        a, b = (getattr(engine, name)(*arguments) for engine in (ours, theirs))
        assert np.abs(a - b).max() <= 1e-11 * np.abs(a).max(), name


# --- planted faults: one engine is given another text ---------------------------------------------


def tampered(engine, pattern, text):
    """The engine, which is given the file with one number changed."""

    def make(arm, gravity=None):
        other, count = re.subn(pattern, text, arm.source.urdf, count=1)
        assert count == 1
        return engine(replace(arm, source=replace(arm.source, urdf=other)), gravity)

    return make


MASS = r'(<link name="left_knee_link">.*?<mass value=")([0-9.]+)'
ORIGIN = r'(<joint name="left_knee_joint"[^>]*>\s*<origin xyz=")(\S+)'
AXIS = r'(<joint name="left_knee_joint".*?<axis xyz=")([^"]+)'
G1 = "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf"


@pytest.mark.parametrize("engine", [MuJoCoEngine, DrakeEngine])
@pytest.mark.parametrize(
    ("pattern", "text", "kind", "where"),
    [
        (MASS, r"\g<1>2.932", "mass-changed", "link 'left_knee_link'"),
        (ORIGIN, r"\g<1>0.0001", "joint-moved", "joint 'left_knee_joint'"),
        (AXIS, r"\g<1>0 0.6 0.8", "axis", "joint 'left_knee_joint'"),
    ],
)
def test_only_the_engine_with_another_number_is_named(
    engine, pattern, text, kind, where, monkeypatch
):
    pattern = re.compile(pattern, re.S)
    key, title = engine.name.lower(), engine.name
    entry = EngineEntry(key, title, 20, make=tampered(engine, pattern, text))
    monkeypatch.setitem(REGISTRY, key, entry)
    engines = ["pinocchio", "mujoco", "drake"]
    found = compare_engines(path(G1), engines=engines, whole=True, samples=5, repairs=False)
    assert {r.key for r in found.as_read.readings if r.harmful} == {key}
    kinds = {(one.kind, one.where) for one in found.as_read.reading(key).imported.harmful}
    assert (kind, where) in kinds
    if kind == "mass-changed":
        assert kinds == {(kind, where)}
        assert found.as_read.reading(key).explanation.explained
    honest = tuple(one for one in (REFERENCE, *engines) if one != key)
    assert found.as_read.matrix.agreeing(SAME_ROBOT) == (honest, (key,))
    assert found.as_read.matrix.between(REFERENCE, key).torque > 1e-6


# --- which models are whole -----------------------------------------------------------------------


def two_arms(tmp_path):
    file = tmp_path / "two.urdf"
    file.write_text(robot(joint(), link(), joint("k", child="other"), link("other")))
    return file


def test_a_file_with_several_chains_is_whole_and_one_arm_is_not(tmp_path):
    assert compare_engines(two_arms(tmp_path), engines=["pinocchio"], samples=5).whole
    one = tmp_path / "one.urdf"
    one.write_text(robot())
    assert not compare_engines(one, engines=["pinocchio"], samples=5).whole
    assert compare_engines(one, engines=["pinocchio"], samples=5, whole=True).whole


def test_path_robot_and_tree_are_the_same_model(tmp_path):
    file = two_arms(tmp_path)
    read = ur5check.load_robot(file)
    for model in (file, str(file), read, RobotTree.of(read)):
        found = compare_engines(model, engines=["mujoco"], samples=5)
        assert found.as_read.agrees()
        mujoco = found.as_read.reading("mujoco")
        assert mujoco.route == "URDF text, own parser"
        assert found.arm.joint_names == ("j", "k")


@pytest.mark.parametrize("key", sorted(ENGINES))
def test_a_tree_without_a_text_is_passed_joint_by_joint(key, tmp_path):
    tree = RobotTree.of(ur5check.load_robot(path("baxter_description/urdf/baxter.urdf")))
    bare = replace(tree, source=replace(tree.source, urdf=None))
    found = compare_engines(bare, engines=[key], samples=5)
    assert found.as_read.reading(key).route == "RobotTree"
    assert found.as_read.agrees()
    assert not {"joint-moved", "axis"} & set(found.as_read.reading(key).imported.kinds)


def test_a_faulty_file_is_an_error_of_the_file_not_a_whole_robot(tmp_path):
    file = tmp_path / "faulty.urdf"
    file.write_text(robot(joint(), link(mass="x"), joint("k", child="other"), link("other")))
    with pytest.raises(ModelError):
        compare_engines(file, engines=["pinocchio"])
    with pytest.raises(UsageError):
        compare_engines(ur5check.load("appendix"), whole=True)
