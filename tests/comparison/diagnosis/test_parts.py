"""Bodies, cylinders and the other DH rule, each on its own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from examples import planar_arm
from ur5check import strategies
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.diagnosis.cylinder_fit import Cylinder, fit_cylinder
from ur5check._comparison.diagnosis.dh_convention import read_by_the_other_rule
from ur5check._comparison.diagnosis.link_numbers import LinkPair, body_of, with_body
from ur5check._comparison.diagnosis.mistakes import MISTAKES
from ur5check._reports import explanation_summary as summary
from ur5check._robot.states import random_states


@given(strategies.arms(max_joints=4), st.data())
def test_a_body_put_back_changes_nothing(arm, data):
    link = data.draw(st.integers(0, arm.n - 1))
    again = with_body(arm, link, body_of(arm, link))
    np.testing.assert_allclose(again.parameters(), arm.parameters(), atol=1e-12)


@pytest.mark.parametrize("name", ["paper", "appendix"])
def test_a_body_is_what_its_file_says(name):
    body = body_of(ur5check.load(name), 1)
    expected = {"paper": [0.2125, 0, 0.11336], "appendix": [0, 0, 0.28]}[name]
    np.testing.assert_allclose(body.com, expected, atol=1e-15)
    lengths = {"paper": [-0.425, 0, 0], "appendix": [0, -0.1197, 0.425]}[name]
    np.testing.assert_allclose(body.link_vector, lengths, atol=1e-15)


@pytest.mark.parametrize("name", ["paper", "appendix"])
def test_a_longer_link_keeps_its_other_numbers(name):
    arm = ur5check.load(name)
    body = body_of(arm, 1)
    changed = body_of(with_body(arm, 1, replace(body, offset=2.0 * body.offset)), 1)
    np.testing.assert_allclose(changed.link_vector, 2.0 * body.link_vector, atol=1e-15)
    np.testing.assert_allclose(changed.com, body.com, atol=1e-15)
    np.testing.assert_allclose(changed.tensor, body.tensor, atol=1e-15)


def test_both_sides_of_a_scene_speak_of_the_same_body():
    pair = pair_up(ur5check.load("paper"), ur5check.load("appendix"))
    in_b, in_a = LinkPair.of(pair, "b"), LinkPair.of(pair, "a")
    for k in range(6):
        # what a says, seen by b, and what b says, seen by a: same masses, same distances apart
        assert in_b.truth[k].mass == in_a.bodies[k].mass
        apart_b = np.linalg.norm(in_b.truth[k].com - in_b.bodies[k].com)
        apart_a = np.linalg.norm(in_a.truth[k].com - in_a.bodies[k].com)
        assert apart_b == pytest.approx(apart_a)


@given(st.integers(0, 2), st.floats(0.01, 1.0), st.floats(0.01, 2.0), st.floats(0.1, 50.0))
def test_a_cylinder_is_found_behind_its_tensor(axis, radius, length, mass):
    made = Cylinder(axis, radius, length)
    found = fit_cylinder(mass, made.tensor(mass))
    assert found is not None
    np.testing.assert_allclose(found.tensor(mass), made.tensor(mass), rtol=1e-6)


@pytest.mark.parametrize(
    ("mass", "tensor"),
    [
        (0.0, np.eye(3)),
        (1.0, np.diag([1.0, 2.0, 2.5])),
        (1.0, np.diag([1.0, 1.0, 2.5])),  # flatter than any disc
        (1.0, np.array([[1.0, 0.5, 0], [0.5, 1.0, 0], [0, 0, 1.0]])),
    ],
)
def test_what_is_no_cylinder_is_not_called_one(mass, tensor):
    assert fit_cylinder(mass, tensor) is None


def test_the_other_rule_read_twice_is_the_first():
    arm = ur5check.load("paper")
    (other,) = read_by_the_other_rule(arm)
    (again,) = read_by_the_other_rule(other)
    q = random_states(6, 10, seed=0).q
    np.testing.assert_allclose(
        ur5check.forward_kinematics(again, q), ur5check.forward_kinematics(arm, q), atol=1e-14
    )
    np.testing.assert_allclose(again.parameters(), arm.parameters(), atol=1e-12)


def test_a_urdf_is_no_dh_table():
    assert read_by_the_other_rule(ur5check.load("appendix")) == []


def test_ids_are_unique():
    assert len({mistake.id for mistake in MISTAKES}) == len(MISTAKES)


def told(a, b):
    return summary.summarize(ur5check.explain(ur5check.diff(a, b, samples=300)))


def test_the_story_of_the_listing():
    lines = told("paper-listing", "paper")
    assert "Links 2, 3 and 5 of paper-listing: a sign of the length is lost" in lines[1]
    assert "removes 100% of the difference" in lines[1]
    assert lines[-1].startswith("Worst within limits: joint")


def test_the_story_of_an_honest_difference():
    arm = ur5check.load("appendix")
    rng = np.random.default_rng(0)
    inertias = [
        replace(link.inertia, mass=link.inertia.mass * rng.uniform(0.95, 1.05))
        for link in arm.links
    ]
    lines = told(arm, arm.with_inertias(inertias))
    assert "No single known mistake explains the difference." in lines


def test_the_worst_joint_is_named_by_its_own_name():
    lines = told("paper", "appendix")
    assert "joint 2 (shoulder)" in lines[-1]
    pendulum = planar_arm((0.7,), (2.0,))
    heavier = planar_arm((0.7,), (2.3,))
    assert "joint 1 (joint_0)" in told(pendulum, heavier)[-1]


def test_the_story_of_no_difference():
    assert "have the same dynamics" in told("appendix", "appendix")[0]
