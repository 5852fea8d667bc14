"""A torque difference is split exactly, fairly, and to the right owner."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from examples import random_arm
from ur5check import strategies
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.attribution import Contribution, attribute
from ur5check._comparison.shapley import shares
from ur5check._robot import Transform
from ur5check._robot.states import random_states


@given(st.data())
def test_the_parts_sum_to_the_difference(data):
    arm, states = data.draw(strategies.arms_and_states(max_joints=5))
    inertias = [data.draw(strategies.inertias()) for _ in range(arm.n)]
    other = replace(arm.with_inertias(inertias), gravity=data.draw(strategies.arms()).gravity)
    found = attribute(pair_up(arm, other), states)
    size = np.abs(found.torque).max() + np.abs(found.delta).max()
    assert np.abs(found.remainder).max() <= 1e-11 * max(1.0, size)


def test_swapping_the_arms_flips_every_part():
    states = random_states(6, 50, seed=0)
    a, b = ur5check.load("paper"), ur5check.load("appendix")
    forth, back = attribute(pair_up(a, b), states), attribute(pair_up(b, a), states)
    np.testing.assert_allclose(forth.torque, -back.torque, atol=1e-11)


def test_swapping_arms_of_different_geometry_flips_every_part():
    states = random_states(6, 50, seed=0)
    a, b = ur5check.load("paper-listing"), ur5check.load("paper")
    forth, back = attribute(pair_up(a, b), states), attribute(pair_up(b, a), states)
    np.testing.assert_allclose(forth.torque, -back.torque, atol=1e-11)


ARM = random_arm(4, seed=8)
STATES = random_states(4, 30, seed=9)


def owner_of(changed):
    found = attribute(pair_up(ARM, changed), STATES)
    largest = np.abs(found.torque).max(axis=(1, 2))
    guilty = int(largest.argmax())
    others = np.delete(largest, guilty).max()
    assert largest[guilty] > 1e-3
    assert others < 1e-9 * largest[guilty]
    return found.contributions[guilty]


def with_link_3(**change):
    inertias = [link.inertia for link in ARM.links]
    return ARM.with_inertias([*inertias[:2], replace(inertias[2], **change), inertias[3]])


@pytest.mark.parametrize(
    ("changed", "contribution"),
    [
        (with_link_3(mass=9.0), Contribution("mass", 3)),
        (with_link_3(com=np.array([0.3, 0.1, 0.2])), Contribution("centre of mass", 3)),
        (with_link_3(tensor=np.diag([0.4, 0.5, 0.6])), Contribution("tensor", 3)),
        (ARM.with_gravity([1.0, 2.0, 3.0]), Contribution("gravity")),
        (ARM.with_armature([0.0, 0.5, 0.0, 0.0]), Contribution("motor inertia")),
        (
            replace(
                ARM,
                links=(
                    *ARM.links[:2],
                    replace(
                        ARM.links[2],
                        link_tip_frame=Transform.translation((0.05, 0, 0))
                        @ ARM.links[2].link_tip_frame,
                    ),
                    ARM.links[3],
                ),
            ),
            Contribution("geometry"),
        ),
    ],
    ids=["mass", "centre", "tensor", "gravity", "motor", "geometry"],
)
def test_a_single_change_is_given_to_its_owner(changed, contribution):
    assert owner_of(changed) == contribution


def test_shares_sum_to_one_and_no_difference_has_none():
    found = attribute(
        pair_up(ur5check.load("paper"), ur5check.load("appendix")), random_states(6, 50, seed=0)
    )
    assert found.share().sum() == pytest.approx(1.0)
    same = attribute(pair_up(ARM, ARM), STATES)
    assert not same.share().any()


def test_shares_are_averaged_over_orders():
    # f = x y: from (0, 0) to (2, 3) both factors did half of the work.
    def value(choice):
        x, y = (2.0 if choice[0] else 0.0), (3.0 if choice[1] else 0.0)
        return np.array(x * y)

    assert shares(value, 2) == [3.0, 3.0]
