"""Identifiability: ranks, combinations and null spaces of arms that are known by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from examples import UR5S, random_arm
from ur5check import strategies
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.difference import SAME_TORQUE
from ur5check._comparison.identifiability.equivalence import TOLERANCE, equivalence, split
from ur5check._comparison.identifiability.identifiability import CERTAIN_GAP, WEAKEST, identify
from ur5check._dynamics.recursion import rnea
from ur5check._dynamics.regressor import torque_regressor
from ur5check._errors import ModelError
from ur5check._reports.explanation_summary import equivalence_in_words
from ur5check._robot import DHRow, Inertia, Joint, Link, SerialArm, Transform, arm_from_dh
from ur5check._robot.states import random_states

BODY = Inertia(2.0, np.array([0.1, 0.02, 0.03]), np.diag([0.1, 0.2, 0.25]))
L1, L2 = 0.5, 0.3


def planar(convention):
    """Two links that turn about horizontal axes z; gravity along −y."""
    lengths = (L1, L2) if convention == "standard" else (0.0, L1)
    rows = [DHRow(f"link {i}", 0.0, a, 0.0, BODY, f"joint {i}") for i, a in enumerate(lengths, 1)]
    return arm_from_dh("2R", rows, convention=convention, gravity=(0.0, -9.81, 0.0))


@pytest.mark.parametrize("name", UR5S)
def test_rank_of_the_ur5_is_36_of_60(name):
    found = identify(ur5check.load(name))
    assert (found.rank, found.columns) == (36, 60)
    assert found.certain
    assert found.gap > 1e10


def test_planar_arm_in_joint_frames_is_the_textbooks():
    # Khalil & Dombre 2002, ch. 9: ZZR1 = ZZ1 + d² m2, MXR1 = MX1 + d m2, and MY1, ZZ2, MX2, MY2.
    found = identify(planar("modified"), frame="source")
    assert set(found.combinations()) == {
        "Izz1 + 0.25·m2", "mx1 + 0.5·m2", "my1", "Izz2", "mx2", "my2"
    }  # fmt: skip


def test_planar_arm_in_frames_at_the_far_ends():
    # The same six by parallel axes: mx at the joint is mx + l m, Izz there Izz + 2 l mx + l² m.
    found = identify(planar("standard"))
    assert set(found.combinations()) == {
        "Izz1 − 0.25·m1 − 0.25·m2", "mx1 + 0.5·m1 + 0.5·m2", "my1",
        "Izz2 − 0.09·m2", "mx2 + 0.3·m2", "my2",
    }  # fmt: skip


def test_without_gravity_a_planar_arm_hides_its_first_centre_of_mass():
    found = identify(planar("modified"), gravity=(0, 0, 0), frame="source")
    assert set(found.combinations()) == {"Izz1 + 0.25·m2", "Izz2", "mx2", "my2"}
    assert {"mx1", "my1"} <= set(found.names_of("invisible"))


@pytest.mark.parametrize("n", range(1, 7))
def test_chain_in_general_position_has_the_known_rank(n):
    # Seven for each revolute link, three for the first (Mayeda et al. 1990, Gautier & Khalil 1990).
    arm = random_arm(n, seed=n, prismatic=False)
    assert identify(arm).rank == 7 * n - 4
    # About a vertical first axis gravity does not act: two less.
    upright = arm.with_gravity(9.81 * (arm.base.R @ arm.joints[0].axis))
    assert identify(upright).rank == 7 * n - 6


def test_a_sliding_joint_sees_mass_alone():
    joint = Joint("slide", np.array([1.0, 0.0, 0.0]), "prismatic")
    arm = SerialArm("slide", (joint,), (Link("link", Transform.identity(), BODY),))
    found = identify(arm)
    assert found.combinations() == ("m1",)
    assert found.names_of("identifiable") == ("m1",)
    assert len(found.names_of("invisible")) == 9


def test_labels_of_the_ur5():
    found = identify(ur5check.load("paper"))
    invisible = {"m1", "mx1", "my1", "mz1", "Ixx1", "Ixy1", "Ixz1", "Iyz1", "Izz1"}
    assert set(found.names_of("invisible")) == invisible  # axis 1 is vertical, along y of frame 1
    labels = dict(zip(found.names, found.labels, strict=True))
    assert labels["Izz6"] == labels["mx6"] == labels["my2"] == "identifiable"
    assert labels["m2"] == labels["m6"] == labels["Iyy1"] == "in combination"
    assert "Ixx6 − Iyy6" in found.combinations()


def test_seed_changes_nothing():
    arm = ur5check.load("appendix")
    first, second = identify(arm, seed=0), identify(arm, seed=99)
    assert first.base == second.base
    assert first.labels == second.labels
    assert first.combinations() == second.combinations()
    np.testing.assert_allclose(first.beta, second.beta, atol=1e-9)


@given(strategies.arms(max_joints=4))
def test_rank_does_not_depend_on_the_seed(arm):
    ranks = {found.rank for seed in range(3) if (found := identify(arm, seed=seed)).certain}
    assert len(ranks) <= 1


def tilted(angle):
    """The planar arm with its second axis tilted by `angle` [rad]."""
    arm = planar("standard")
    bent = Transform.rotation((1, 0, 0), angle) @ arm.links[0].link_tip_frame
    return replace(arm, links=(replace(arm.links[0], link_tip_frame=bent), arm.links[1]))


@pytest.mark.parametrize("tilt", [1e-5, 1e-6])
def test_an_all_but_special_axis_makes_the_rank_uncertain(tilt):
    found = identify(tilted(tilt))
    assert not found.certain
    assert found.gap <= CERTAIN_GAP or found.weakest <= WEAKEST


def test_an_axis_tilted_by_a_late_digit_is_not_tilted():
    found = identify(tilted(1e-9))
    assert found.certain
    assert found.rank == identify(planar("standard")).rank == 6
    assert identify(tilted(0.1)).rank > 6


def torque_along(Y, direction):
    """Largest torque of a parameter change, as a part of what its entries make one by one."""
    return np.abs(Y @ direction).max() / (np.abs(Y) @ np.abs(direction)).max()


@given(st.data())
def test_moving_along_the_null_space_changes_no_torque_and_off_it_does(data):
    arm = data.draw(strategies.arms(max_joints=5))
    found = identify(arm)
    if not found.certain:
        return
    states = random_states(arm.n, 20, seed=5)
    Y = torque_regressor(arm, states.q, states.qd, states.qdd)
    for place, column in zip(found.dependent, found.null_space.T, strict=True):
        if found.labels[place] == "invisible":  # no torque to measure it by
            assert np.abs(Y[..., place]).max() <= 1e-5 * np.abs(Y).max()
            continue
        assert torque_along(Y, column) <= 1e-6
        off = column.copy()
        off[place] *= 1.01
        assert np.abs(Y @ off).max() > 100 * np.abs(Y @ column).max()


@pytest.mark.parametrize("arm", [ur5check.load("paper"), random_arm(5, seed=3)], ids=str)
def test_bodies_moved_along_the_null_space_make_the_same_arm(arm):
    found, rng = identify(arm), np.random.default_rng(0)
    direction = found.null_space @ rng.normal(size=found.null_space.shape[1])
    pi = arm.parameters()
    step = 0.5 * pi[::10].min() / np.abs(direction[::10]).max()  # every mass keeps half

    def with_parameters(parameters):
        return arm.with_inertias([Inertia.from_parameters(p) for p in parameters.reshape(-1, 10)])

    other, states = with_parameters(pi + step * direction), random_states(arm.n, 200, seed=1)
    at = (states.q, states.qd, states.qdd)
    tau = rnea(arm, *at)
    np.testing.assert_allclose(rnea(other, *at), tau, atol=1e-10 * np.abs(tau).max())
    judged = equivalence(pair_up(arm, other), states)
    assert judged.dynamically_equivalent
    assert equivalence_in_words(judged).startswith("Different numbers, same dynamics")

    off = step * direction
    off[found.base[3]] += 1e-3
    judged = equivalence(pair_up(arm, with_parameters(pi + off)), states)
    assert not judged.dynamically_equivalent
    assert equivalence_in_words(judged).startswith("The inertias are not dynamically equivalent")


@given(st.data())
def test_a_split_sums_to_the_difference_and_its_visible_part_makes_the_torque(data):
    arm, states = data.draw(strategies.arms_and_states(max_joints=4))
    found = identify(arm)
    dpi = np.random.default_rng(7).normal(size=found.columns)
    parts = split(found, dpi)
    size = np.abs(dpi).max() + np.abs(parts.visible).max()
    np.testing.assert_allclose(parts.visible + parts.invisible, dpi, rtol=0, atol=1e-15 * size)
    assert not parts.visible[list(found.dependent)].any()
    np.testing.assert_array_equal(parts.visible[list(found.base)], parts.base)
    if found.certain:
        Y = torque_regressor(arm, states.q, states.qd, states.qdd)
        whole = (np.abs(Y) @ (np.abs(dpi) + np.abs(parts.visible))).max()
        assert np.abs(Y @ parts.invisible).max() <= 1e-6 * whole + 1e-12


def test_splitting_with_the_wrong_arm_is_noticed():
    a, b = ur5check.load("paper"), random_arm(6, seed=2)
    dpi, states = np.random.default_rng(0).normal(size=60), random_states(6, 50, seed=0)
    Y = torque_regressor(a, states.q, states.qd, states.qdd)
    assert np.abs(Y @ split(identify(a), dpi).invisible).max() < 1e-11
    assert np.abs(Y @ split(identify(b), dpi).invisible).max() > 1.0


def test_equivalence_tells_geometry_from_inertia():
    states = random_states(6, 100, seed=0)
    listing, paper, appendix = (ur5check.load(n) for n in ("paper-listing", "paper", "appendix"))
    judged = equivalence(pair_up(listing, paper), states)
    assert not judged.dynamically_equivalent
    assert "geometry or gravity is not" in equivalence_in_words(judged)
    assert not equivalence(pair_up(paper, appendix), states).dynamically_equivalent
    same = equivalence(pair_up(paper, paper), states)
    assert same.dynamically_equivalent
    assert equivalence_in_words(same).startswith("Same numbers")


def test_tolerance_is_the_one_of_diff():
    assert TOLERANCE == SAME_TORQUE


def test_wrong_length_is_refused():
    with pytest.raises(ModelError, match=r"shape \(20,\)"):
        split(identify(planar("standard")), np.zeros(10))
