"""Regrouping changes the numbers and not the torques; wishes are granted to the last digit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from references import states
from speed.random_chain import chain

import ur5check
from examples import random_arm
from ur5check import strategies
from ur5check._dynamics.symbolic import parameter_regrouping as regroup
from ur5check._dynamics.symbolic import target_values as target_values
from ur5check._dynamics.symbolic.parameter_regrouping import regroupings, slid
from ur5check._dynamics.symbolic.target_values import TargetValue, Unseen
from ur5check._dynamics.symbolic.trace import trace
from ur5check._robot import Transform

ARMS = ("paper", "appendix", "erd-ur5", "random")


def arm_of(name):
    return random_arm(6, seed=2) if name == "random" else ur5check.load(name)


def largest_change(arm, pi):
    """Of any torque, as a part of the largest, when π changes to these parameters."""
    at = states(arm, 100)
    Y = ur5check.torque_regressor(arm, at.q, at.qd, at.qdd)
    return np.abs(Y @ (pi - arm.parameters())).max() / np.abs(Y @ arm.parameters()).max()


@pytest.mark.parametrize("name", ARMS)
def test_torques_stay_and_wishes_are_granted(name):
    arm = arm_of(name)
    unseen = Unseen(arm)
    target_values = [
        TargetValue(i, *names) for i in range(6) for names in (("m",), ("Iyy", "Izz"), ("mz",))
    ]
    pi = unseen.parameters(target_values)
    assert largest_change(arm, pi) < 1e-13
    feasible = unseen.feasible(target_values)
    assert feasible
    for target_value in feasible:
        values = pi[list(target_value.places)]
        assert values[0] == (values[1] if target_value.equal_to else 0.0)


WISHES = [("m",), ("mx",), ("my",), ("mz",), ("Ixx",), ("Iyy",), ("Iyy", "Izz"), ("Ixy",)]


@settings(max_examples=15)
@given(arm_and_states=strategies.arms_and_states())
def test_torques_stay_whatever_the_arm(arm_and_states):
    arm, _ = arm_and_states
    target_values = [TargetValue(i, *names) for i in range(arm.n) for names in WISHES]
    pi = Unseen(arm).parameters(target_values)
    np.testing.assert_allclose(
        *(np.linalg.norm(Unseen(arm).triangle @ p) for p in (pi, arm.parameters())), rtol=1e-12
    )
    assert largest_change(arm, pi) < 1e-12


@pytest.mark.parametrize("n", [8, 9, 12])
def test_wishes_that_all_but_depend_on_each_other_do_not_add_up(n):
    """Along a chain their remainders multiply: here by 1e14, though each is above a thousandth."""
    arm = chain(n, seed=0)
    at = states(arm, 20)
    tau = ur5check.rnea(arm, at.q, at.qd, at.qdd)
    found = trace(arm, "tau", tries=0).evaluate(at.q, at.qd, at.qdd)
    assert np.abs(found - tau).max() < 1e-12 * np.abs(tau).max()


def test_a_regrouping_that_changes_torques_is_refused(monkeypatch):
    monkeypatch.setattr(target_values, "_AMPLIFIED", 1e20)
    monkeypatch.setattr(regroup, "_CANCELLATION", 1e20)
    arm = slid(chain(9, seed=0))
    every = [
        TargetValue(link, *names) for link in reversed(range(9)) for names in regroup._TARGET_VALUES
    ]
    assert largest_change(arm, Unseen(arm).parameters(every)) > 1e-6
    prices = iter((2, 1))  # the arm's own chain, and one that would be cheaper
    assert len(regroupings(arm, lambda chain: next(prices), tries=0)) == 1


def test_as_many_numbers_go_as_no_torque_sees():
    unseen = Unseen(ur5check.load("paper"))
    every = [
        TargetValue(i, name)
        for i in range(6)
        for name in ("Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")
    ]
    every += [TargetValue(i, name) for i in range(6) for name in ("mx", "my", "mz", "m")]
    assert unseen.null_space.shape == (60, 24)
    assert len(unseen.feasible(every)) == 24


def test_a_number_that_torque_sees_may_not_go():
    arm = ur5check.load("paper")
    pi = arm.parameters()
    pi[11] = 0.0  # the first moment of link 2
    assert largest_change(arm, pi) > 1e-3


@pytest.mark.parametrize("name", ARMS)
def test_sliding_origins_moves_no_axis(name):
    arm = arm_of(name)
    other = slid(arm)
    at = states(arm, 20)
    for of in (
        lambda a: ur5check.rnea(a, at.q, at.qd, at.qdd),
        lambda a: a.links[-1].link_tip_frame.R,
    ):
        np.testing.assert_allclose(of(other), of(arm), rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(
        ur5check.forward_kinematics(other, at.q), ur5check.forward_kinematics(arm, at.q), atol=1e-13
    )


def test_no_origin_goes_a_mile_along_axes_that_are_all_but_parallel():
    arm = random_arm(5, seed=2)
    feet = [link.link_tip_frame.p for link in slid(arm).links]
    reach = sum(np.linalg.norm(link.link_tip_frame.p) for link in arm.links)
    assert max(np.linalg.norm(foot) for foot in feet) < reach
    at = states(arm, 40)
    tau = ur5check.rnea(arm, at.q, at.qd, at.qdd)
    found = trace(arm, "tau", tries=0).evaluate(at.q, at.qd, at.qdd)
    assert np.abs(found - tau).max() < 1e-12 * np.abs(tau).max()  # was 8e-10


def test_offsets_that_cancel_are_gone():
    """The appendix goes out by 0.13585 m and back by 0.1197 m along one axis direction."""
    arm = slid(ur5check.load("appendix"))
    reaches = np.array([link.link_tip_frame.R.T @ link.link_tip_frame.p for link in arm.links])
    assert (np.abs(reaches) > 1e-12).sum(axis=1).max() == 1
    # And not by chance: an origin that was pushed along its axis comes back.
    links = list(arm.links)
    push = Transform.translation(arm.joints[3].axis * 0.3)
    links[2] = replace(
        links[2],
        link_tip_frame=links[2].link_tip_frame @ push,
        inertia=links[2].inertia.expressed_in(push.inverse()),
    )
    links[3] = replace(links[3], link_tip_frame=push.inverse() @ links[3].link_tip_frame)
    back = slid(replace(arm, links=tuple(links)))
    np.testing.assert_allclose(
        back.links[2].link_tip_frame.p, arm.links[2].link_tip_frame.p, atol=1e-12
    )
