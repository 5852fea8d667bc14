"""Dynamics of whole robots: against Pinocchio's tree, and laws on random trees."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from types import SimpleNamespace

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import ur5check
from kinematics_comparison import BODIES, configuration
from ur5check import Joint, Link, RobotTree, UsageError, strategies
from ur5check._io.ros_packages import example_robot_data
from ur5check._robot.robot_tree import TreeLink

WHOLE_ROBOTS = (
    "allegro_hand_description/urdf/allegro_left_hand.urdf",  # hand
    "anymal_b_simple_description/robots/anymal.urdf",  # quadruped
    "baxter_description/urdf/baxter.urdf",  # two arms, mimic prismatic fingers
    "double_pendulum_description/urdf/double_pendulum_continuous.urdf",
    "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf",  # humanoid with hands
    "pr2_description/urdf/pr2.urdf",  # prismatic torso, ten mimic joints
    "talos_data/robots/talos_full_v2.urdf",  # humanoid, twelve mimic joints
    "tiago_description/robots/tiago_dual.urdf",  # 101 joints, three of them prismatic
    "tiago_pro_description/robots/tiago_pro.urdf",  # two arms on a base with wheels
)
RELATIVE = 1e-12


@cache
def whole(file):
    """Our tree, Pinocchio's model of the same text, and G and the joints' q, q̇, q̈ at a state."""
    path = example_robot_data() / "robots" / file
    tree, model = RobotTree.of(ur5check.load_robot(path)), pin.buildModelFromXML(path.read_text())
    G = np.zeros((model.nv, tree.n))
    at = [model.joints[model.getJointId(link.joint.name)].idx_v for link in tree.links]
    for row, link in zip(at, tree.links, strict=True):
        G[row, link.coordinate] = link.multiplier
    q, qd, qdd = np.random.default_rng(1).uniform(-3.0, 3.0, (3, tree.n))
    names = [link.joint.name for link in tree.links]
    joints = dict(zip(names, tree.all_joints(q[:, None])[:, 0], strict=True))
    return SimpleNamespace(
        tree=tree,
        model=model,
        data=model.createData(),
        G=G,
        q=q,
        qd=qd,
        qdd=qdd,
        configuration=configuration(model, joints),
    )


def relative(ours, theirs):
    return np.abs(ours - theirs).max() / np.abs(theirs).max()


@pytest.mark.parametrize("file", WHOLE_ROBOTS)
def test_whole_robots_have_pinocchio_s_torques(file):
    at = whole(file)
    tree, model, data, G, full = at.tree, at.model, at.data, at.G, at.configuration
    tau = G.T @ pin.rnea(model, data, full, G @ at.qd, G @ at.qdd)
    assert relative(ur5check.rnea(tree, at.q, at.qd, at.qdd), tau) <= RELATIVE
    g = G.T @ pin.computeGeneralizedGravity(model, data, full)
    assert relative(ur5check.gravity_torque(tree, at.q), g) <= RELATIVE
    upper = np.triu(pin.crba(model, data, full))
    M = G.T @ (upper + np.triu(upper, 1).T) @ G
    assert relative(ur5check.mass_matrix(tree, at.q), M) <= RELATIVE
    bias = G.T @ pin.nonLinearEffects(model, data, full, G @ at.qd)
    C = ur5check.coriolis_matrix(tree, at.q, at.qd)
    assert relative(C @ at.qd + ur5check.gravity_torque(tree, at.q), bias) <= RELATIVE
    Y = ur5check.torque_regressor(tree, at.q, at.qd, at.qdd)
    assert relative(Y @ tree.parameters(), tau) <= RELATIVE
    qdd = ur5check.forward_dynamics(tree, at.q, at.qd, tau)
    # M is inverted: its condition number stands in the error.
    assert relative(M @ qdd + bias, tau) <= 1e-10


@pytest.mark.parametrize("file", WHOLE_ROBOTS)
def test_every_link_stands_where_pinocchio_has_it(file):
    at = whole(file)
    pin.framesForwardKinematics(at.model, at.data, at.configuration)
    for name in at.tree.placements:
        theirs = at.data.oMf[at.model.getFrameId(name, BODIES)].homogeneous
        ours = ur5check.forward_kinematics(at.tree, at.q, link=name)
        assert np.abs(ours - theirs).max() <= 1e-13, name


def test_a_link_on_a_wrong_parent_is_seen():
    at = whole("talos_data/robots/talos_full_v2.urdf")
    hip = next(i for i, link in enumerate(at.tree.links) if link.joint.name == "leg_right_1_joint")
    links = list(at.tree.links)
    torso = next(i for i, link in enumerate(links) if link.joint.name == "torso_1_joint")
    assert torso < hip
    links[hip] = replace(links[hip], parent=torso)
    wrong = replace(at.tree, links=tuple(links))
    tau = at.G.T @ pin.rnea(at.model, at.data, at.configuration, at.G @ at.qd, at.G @ at.qdd)
    assert relative(ur5check.rnea(wrong, at.q, at.qd, at.qdd), tau) > 1e-3


@pytest.mark.parametrize("name", ["paper", "appendix"])
def test_an_arm_and_its_tree_have_the_same_dynamics(name):
    tree, states = RobotTree.of(ur5check.load_robot(name)), ur5check.random_states(6, 20, seed=0)
    of_tree, of_arm = (
        ur5check.rnea(each, states.q, states.qd, states.qdd) for each in (tree, name)
    )
    assert np.abs(of_tree - of_arm).max() <= 1e-12 * np.abs(of_arm).max()


@st.composite
def trees(draw):
    """Trees of 2 to 6 joints, some of them driven by an earlier joint's coordinate."""
    links, names = [], []
    for i in range(draw(st.integers(2, 6))):
        kind = draw(st.sampled_from(["revolute", "revolute", "prismatic"]))
        joint = Joint(f"joint_{i}", draw(strategies.unit_vectors()), kind, armature=0.01 * i)
        link = Link(f"link_{i}", draw(strategies.transforms()), draw(strategies.inertias()))
        mimics = i > 0 and draw(st.booleans()) and draw(st.booleans())
        if not mimics:
            names.append(joint.name)
        links.append(
            TreeLink(
                draw(st.integers(-1, i - 1)),
                draw(strategies.transforms()),
                joint,
                link,
                draw(st.integers(0, len(names) - 1)) if mimics else len(names) - 1,
                draw(st.sampled_from([-1.0, 0.5, 2.0])) if mimics else 1.0,
                draw(st.sampled_from([0.0, 0.3])) if mimics else 0.0,
            )
        )
    return RobotTree("drawn", tuple(links), tuple(names), np.array([1.0, -2.0, -9.0]))


@st.composite
def trees_and_states(draw):
    tree = draw(trees())
    return tree, draw(strategies.states(tree.n))


def pinocchio_model(tree):
    """The tree, built joint by joint; P_i is applied to the inertia and to the children."""
    model = pin.Model()
    model.gravity.linear = tree.gravity
    for i, each in enumerate(tree.links):
        P = pin.SE3.Identity() if each.parent < 0 else se3(tree.links[each.parent].link)
        D = P * pin.SE3(each.origin.R, each.origin.p)
        kind = pin.JointModelPrismaticUnaligned
        if each.joint.kind == "revolute":
            kind = pin.JointModelRevoluteUnaligned
        index = model.addJoint(each.parent + 1, kind(each.joint.axis), D, f"j{i}")
        inertia = each.link.inertia
        body = pin.Inertia(inertia.mass, inertia.com, inertia.tensor)
        model.appendBodyToJoint(index, body, se3(each.link))
    return model


def se3(link):
    return pin.SE3(link.link_tip_frame.R, link.link_tip_frame.p)


@settings(max_examples=60, deadline=None)
@given(trees_and_states())
def test_laws_of_random_trees(tree_and_states):
    tree, states = tree_and_states
    q, qd, qdd = states.q, states.qd, states.qdd
    M = ur5check.mass_matrix(tree, q)
    size = np.abs(M).max()
    assert np.abs(M - M.swapaxes(-1, -2)).max() <= 1e-12 * size
    assert (np.linalg.eigvalsh(M) > 0.0).all()
    rate = ur5check.mass_matrix(tree, q + 1e-30j * qd).imag / 1e-30
    C = ur5check.coriolis_matrix(tree, q, qd)
    S = rate - 2.0 * C
    assert np.abs(S + S.swapaxes(-1, -2)).max() <= 1e-11 * (size + np.abs(C).max())
    tau = ur5check.rnea(tree, q, qd, qdd)
    equation = M @ qdd[..., None] + C @ qd[..., None]
    bound = 1e-11 * (1.0 + np.abs(tau).max() + size * np.abs(qdd).max() + np.abs(C).max())
    assert np.abs(equation[..., 0] + ur5check.gravity_torque(tree, q) - tau).max() <= bound
    energy = 0.5 * np.einsum("...i,...ij,...j", qd, M, qd)
    assert np.abs(ur5check.kinetic_energy(tree, q, qd) - energy).max() <= 1e-12 * (
        1.0 + np.abs(energy).max()
    )
    slope = [
        ur5check.potential_energy(tree, q + 1e-30j * unit).imag / 1e-30 for unit in np.eye(tree.n)
    ]
    assert np.abs(np.stack(slope, -1) - ur5check.gravity_torque(tree, q)).max() <= bound


@settings(max_examples=60, deadline=None)
@given(trees_and_states())
def test_random_trees_have_pinocchio_s_torques_and_regressor(tree_and_states):
    tree, states = tree_and_states
    model = pinocchio_model(tree)
    G = tree.all_rates(np.eye(tree.n))
    armature = np.array([link.joint.armature for link in tree.links])
    for q, qd, qdd in zip(states.q, states.qd, states.qdd, strict=True):
        full, v, a = tree.all_joints(q[:, None])[:, 0], G @ qd, G @ qdd
        data = model.createData()
        joint_torques = pin.rnea(model, data, full, v, a)
        tau = G.T @ (joint_torques + armature * a)
        size = 1.0 + np.abs(joint_torques).max()
        assert np.abs(ur5check.rnea(tree, q, qd, qdd) - tau).max() <= RELATIVE * size
        Y = ur5check.torque_regressor(tree, q, qd, qdd)
        ours = Y @ tree.parameters()
        assert np.abs(ours - G.T @ joint_torques).max() <= RELATIVE * size


def test_a_tree_has_no_tool_and_an_arm_takes_no_link():
    tree = RobotTree.of(ur5check.load_robot("appendix"))
    for model, link in ((tree, None), (tree, "absent"), ("appendix", "tool0")):
        with pytest.raises(UsageError):
            ur5check.forward_kinematics(model, np.zeros(6), link=link)
