"""Alignment is found again after any change of coordinates, and never invented."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from arms_in_disguise import in_other_coordinates, with_tool
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from examples import UR5S, planar_arm, random_arm
from ur5check import strategies
from ur5check._comparison.alignment import (
    SAME_LENGTH,
    align,
    align_as_written,
    arm_in_coordinates_of,
)
from ur5check._comparison.alignment_paths import Undetermined
from ur5check._errors import UsageError
from ur5check._robot import Joint, Limits, Transform
from ur5check._robot.states import random_states


def tools_apart(a, b, alignment):
    moved = arm_in_coordinates_of(a, b, alignment)
    q = random_states(a.n, 20, seed=0).q
    apart = ur5check.forward_kinematics(a, q) - ur5check.forward_kinematics(moved, q)
    return np.abs(apart).max()


@st.composite
def disguises(draw, arm):
    """A base transform, a sign and an offset for each joint."""
    signs = draw(st.lists(st.sampled_from([1.0, -1.0]), min_size=arm.n, max_size=arm.n))
    offsets = draw(
        st.lists(st.floats(-3.0, 3.0, allow_subnormal=False), min_size=arm.n, max_size=arm.n)
    )
    return draw(strategies.transforms(2.0)), signs, offsets


@given(st.data())
def test_any_arm_is_found_again(data):
    arm = data.draw(strategies.arms())
    other = in_other_coordinates(arm, *data.draw(disguises(arm)))
    found = align(arm, other)
    assert found.exact
    assert max(found.axis_distance.max(), found.axis_angle.max()) <= SAME_LENGTH
    if not found.unknown:  # what the axes cannot tell is said; see the tests below
        assert tools_apart(arm, other, found) <= 1e-5


@pytest.mark.parametrize("name", UR5S)
@pytest.mark.parametrize("seed", range(5))
def test_every_ur5_is_found_again(name, seed):
    arm, rng = ur5check.load(name), np.random.default_rng(seed)
    T = Transform.from_rpy(rng.normal(size=3), rng.uniform(-3, 3, 3))
    signs, offsets = rng.choice([1.0, -1.0], 6), rng.uniform(-3, 3, 6)
    other = in_other_coordinates(arm, T, signs, offsets)
    found = align(arm, other)
    assert found.exact
    assert not found.unknown
    assert tools_apart(arm, other, found) < 1e-9


@pytest.mark.parametrize("n", [1, 2, 3, 6, 12, 30])
@pytest.mark.parametrize("prismatic", [False, True])
def test_random_chains_are_found_again_tool_and_all(n, prismatic):
    arm, rng = random_arm(n, seed=n, prismatic=prismatic), np.random.default_rng(n)
    T = Transform.from_rpy(rng.normal(size=3), rng.uniform(-3, 3, 3))
    other = in_other_coordinates(arm, T, rng.choice([1.0, -1.0], n), rng.uniform(-1, 1, n))
    found = align(arm, other)
    assert found.exact
    assert not found.unknown
    assert tools_apart(arm, other, found) < 1e-9


def test_the_base_of_the_appendix_is_found_turned_by_half_a_turn():
    found = align(ur5check.load("paper"), ur5check.load("appendix"))
    np.testing.assert_allclose(found.T_ab.R, np.diag([-1.0, -1.0, 1.0]), atol=1e-15)
    np.testing.assert_allclose(found.T_ab.p, 0.0, atol=1e-15)
    np.testing.assert_array_equal(found.signs, np.ones(6))
    np.testing.assert_array_equal(found.offsets, np.zeros(6))
    assert np.abs(found.tool.matrix() - np.eye(4)).max() < 1e-11


def test_an_arm_and_itself_need_no_change():
    for name in UR5S:
        arm = ur5check.load(name)
        found = align(arm, arm)
        assert found.exact
        np.testing.assert_array_equal(found.signs, np.ones(6))
        np.testing.assert_array_equal(found.offsets, np.zeros(6))
        assert found.T_ab.angle() < 1e-12


def test_a_shifted_zero_of_a_joint_that_tilts_in_gravity_stays_with_the_joint():
    arm = planar_arm((0.5, 0.3), (2.0, 1.0))
    other = replace(
        in_other_coordinates(arm, Transform.identity(), [1, 1], [0.4, 0.0]), gravity=arm.gravity
    )
    found = align(arm, other)
    np.testing.assert_allclose(found.offsets, [0.4, 0.0], atol=1e-12)
    assert found.T_ab.angle() < 1e-12


def test_without_a_common_tool_the_last_zero_is_said_to_be_unknown():
    arm = ur5check.load("appendix")  # whose last link is round: torques do not show it either
    other = with_tool(arm, Transform.from_rpy((0, 0.1, 0), (0.3, 0.2, 0.1)))
    found = align(arm, other)
    assert found.exact
    assert found.offsets[-1] == 0.0
    assert found.unknown == (Undetermined(6, "tool"),)


def test_joints_on_one_axis_are_said_to_show_their_sum_only():
    # A point mass on both axes: torques do not show how the first link is turned.
    arm = planar_arm((0.0, 0.5, 0.3), (1.0, 2.0, 1.0))
    found = align(arm, arm)
    assert found.exact
    assert found.unknown == (Undetermined(1, "same line"),)


def test_different_geometry_is_not_made_to_fit():
    paper, listing = ur5check.load("paper"), ur5check.load("paper-listing")
    found = align(listing, paper)
    assert not found.exact
    np.testing.assert_array_equal(found.signs, np.ones(6))
    np.testing.assert_array_equal(found.offsets, np.zeros(6))
    assert found.axis_distance[2] == pytest.approx(0.85, abs=1e-3)  # 2 × 0.425 m
    # Other readings of the angles make the axes coincide, with other bodies: that is said.
    assert (found.others[0].signs < 0).any()
    assert all(other.exact and other.torque_difference > 1.0 for other in found.others)


def test_the_nearest_alignment_of_arms_that_do_not_align_is_named():
    arm = ur5check.load("paper")
    second = arm.links[1]
    longer = replace(second.link_tip_frame, p=second.link_tip_frame.p + [1e-4, 0, 0])
    other = replace(
        arm, links=(arm.links[0], replace(second, link_tip_frame=longer), *arm.links[2:])
    )
    other = in_other_coordinates(other, Transform.identity(), [1, 1, -1, 1, 1, 1], np.zeros(6))
    found = align(arm, other)
    assert not found.exact
    assert found.nearest is not None
    np.testing.assert_array_equal(found.nearest.signs, [1, 1, -1, 1, 1, 1])
    assert found.nearest.axis_distance.max() == pytest.approx(1e-4)


def test_a_millimetre_is_a_difference():
    arm = ur5check.load("paper")
    second = arm.links[1]
    longer = replace(second.link_tip_frame, p=second.link_tip_frame.p + [1e-3, 0, 0])
    other = replace(
        arm, links=(arm.links[0], replace(second, link_tip_frame=longer), *arm.links[2:])
    )
    found = align(arm, other)
    assert not found.exact
    assert found.axis_distance[2] == pytest.approx(1e-3)


def test_limits_turn_with_the_joint():
    arm = planar_arm((0.5, 0.3), (2.0, 1.0))
    limited = replace(arm.joints[1], limits=Limits(-1.0, 2.0, 3.0, 4.0))
    arm = replace(arm, joints=(arm.joints[0], limited))
    other = in_other_coordinates(arm, Transform.identity(), [1, -1], [0.0, 0.5])
    other = replace(
        other,
        joints=(other.joints[0], replace(other.joints[1], limits=Limits(-1.5, 1.5, 3.0, 4.0))),
    )
    found = align(arm, other)
    moved = arm_in_coordinates_of(arm, other, found)
    limits = moved.joints[1].limits
    # q_b = −q_a + 0.5, so q_b in [−1.5, 1.5] is q_a in [−1, 2].
    assert (limits.lower, limits.upper) == (pytest.approx(-1.0), pytest.approx(2.0))


def test_arms_with_other_joints_are_refused():
    with pytest.raises(UsageError, match="has 2 joints and 'paper' has 6"):
        align(planar_arm((0.5, 0.3), (1.0, 1.0)), ur5check.load("paper"))
    slide = replace(random_arm(2, seed=0), joints=(Joint("a", [0, 0, 1], "prismatic"),) * 2)
    with pytest.raises(UsageError, match=r"revolute in .* but prismatic in"):
        align(planar_arm((0.5, 0.3), (1.0, 1.0)), slide)


def test_as_written_a_lost_offset_and_a_zero_of_two_degrees_are_differences():
    arm = ur5check.load("paper")
    for offset in (np.pi / 2, np.radians(2.0)):
        offsets = [0.0, 0.0, offset, 0.0, 0.0, 0.0]
        other = in_other_coordinates(arm, Transform.identity(), np.ones(6), offsets)
        np.testing.assert_allclose(align(arm, other).offsets, offsets, atol=1e-12)
        written = align_as_written(arm, other)
        assert not written.exact
        np.testing.assert_array_equal(written.offsets, np.zeros(6))
        assert ur5check.diff(arm, other, samples=50).agrees
        assert not ur5check.diff(arm, other, samples=50, as_written=True).agrees
