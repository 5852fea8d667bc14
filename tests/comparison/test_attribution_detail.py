"""A torque difference split by parameter and by term closes, and blames the right one."""

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
from ur5check._comparison.attribution import PARAMETER_CONTRIBUTIONS, Contribution, attribute
from ur5check._comparison.attribution_detail import by_parameter, by_term
from ur5check._robot import PARAMETERS, Inertia, Joint, Link, SerialArm, Transform
from ur5check._robot.states import random_states

ARM = random_arm(4, seed=8)
STATES = random_states(4, 30, seed=9)
PAIRS = [("paper", "appendix"), ("paper-listing", "paper"), ("erd-ur5", "appendix")]


def test_owners_are_the_ten_parameters():
    assert PARAMETER_CONTRIBUTIONS == PARAMETERS


@given(st.data())
def test_parts_sum_to_the_difference(data):
    arm, states = data.draw(strategies.arms_and_states(max_joints=4))
    inertias = [data.draw(strategies.inertias()) for _ in range(arm.n)]
    other = replace(arm.with_inertias(inertias), gravity=data.draw(strategies.arms()).gravity)
    pair = pair_up(arm, other)
    fine, terms = by_parameter(pair, states), by_term(pair, states)
    size = max(1.0, np.abs(fine.torque).max() + np.abs(fine.delta).max())
    assert fine.torque.shape[0] == 10 * arm.n + 3
    assert np.abs(fine.remainder).max() <= 1e-11 * size
    parts = (terms.gravity, terms.coriolis, terms.inertial)
    assert np.abs(sum(term.delta for term in parts) - fine.delta).max() <= 1e-11 * size
    for term in parts:
        assert np.abs(term.remainder).max() <= 1e-11 * size


@pytest.mark.parametrize("names", PAIRS, ids="-".join)
def test_finer_parts_add_up_to_the_coarse_ones(names):
    pair, states = pair_up(*(ur5check.load(name) for name in names)), random_states(6, 40, seed=1)
    coarse, fine, terms = attribute(pair, states), by_parameter(pair, states), by_term(pair, states)
    scale = 1e-12 * max(1.0, np.abs(coarse.torque).max())
    per_link = coarse.torque[3:].reshape(6, 3, 40, 6).sum(axis=1)
    np.testing.assert_allclose(
        fine.torque[3:].reshape(6, 10, 40, 6).sum(axis=1), per_link, atol=scale
    )
    summed = terms.gravity.torque + terms.coriolis.torque + terms.inertial.torque
    np.testing.assert_allclose(summed, coarse.torque, atol=scale)


def test_terms_are_what_their_names_say():
    pair = pair_up(ARM, ARM.with_gravity([1.0, 2.0, 3.0]))
    terms = by_term(pair, STATES)
    assert np.abs(terms.gravity.delta).max() > 1.0
    assert not terms.coriolis.delta.any()
    assert not terms.inertial.delta.any()
    slow = replace(STATES, qd=2.0 * STATES.qd)
    heavier = pair_up(ARM, changed(3, "m", 1.0))
    once, twice = by_term(heavier, STATES), by_term(heavier, slow)
    np.testing.assert_allclose(twice.coriolis.delta, 4.0 * once.coriolis.delta, atol=1e-10)
    np.testing.assert_array_equal(twice.inertial.delta, once.inertial.delta)


def changed(link, parameter, by):
    """ARM with one of a link's ten parameters changed."""
    inertias = [each.inertia for each in ARM.links]
    pi = inertias[link - 1].parameters()
    pi[PARAMETERS.index(parameter)] += by
    inertias[link - 1] = Inertia.from_parameters(pi)
    return ARM.with_inertias(inertias)


@pytest.mark.parametrize("parameter", PARAMETERS)
def test_a_changed_parameter_is_blamed_alone(parameter):
    found = by_parameter(pair_up(ARM, changed(3, parameter, 0.2)), STATES)
    weight = found.weight()
    assert found.contributions[int(weight.argmax())] == Contribution(parameter, 3)
    assert weight.max() == pytest.approx(1.0, abs=1e-9)
    assert not found.cancels


def test_swapping_the_arms_flips_every_parameter():
    states = random_states(6, 30, seed=0)
    a, b = ur5check.load("paper-listing"), ur5check.load("paper").with_gravity([0, 1, -9])
    forth, back = by_parameter(pair_up(a, b), states), by_parameter(pair_up(b, a), states)
    np.testing.assert_allclose(forth.torque, -back.torque, atol=1e-11)


def test_weights_rank_owners_that_cancel_and_shares_do_not():
    # A mass twice as large whose centre lies half as far: gravity sees only the product, so two
    # large parts leave a small difference.
    body = Inertia(2.0, np.array([0.4, 0.0, 0.0]), 0.01 * np.eye(3))
    other = Inertia(4.0, body.com * 0.502, body.tensor)
    joint = Joint("hinge", np.array([0.0, 1.0, 0.0]))
    arm = SerialArm("hanging", (joint,), (Link("link", Transform.identity(), body),))
    drawn = random_states(1, 50, seed=0)
    still = replace(drawn, qd=0.0 * drawn.qd, qdd=0.0 * drawn.qdd)
    found = attribute(pair_up(arm, arm.with_inertias([other])), still)
    assert found.cancels
    assert np.abs(found.share()).max() > 50.0
    assert found.weight().sum() == pytest.approx(1.0)
    assert sorted(found.weight())[-2:] == pytest.approx([0.5, 0.5], abs=0.01)


def test_no_difference_has_no_weight():
    found = attribute(pair_up(ARM, ARM), STATES)
    assert not found.weight().any()
    assert not found.cancels


def test_weights_are_shares_of_size():
    found = attribute(
        pair_up(ur5check.load("paper"), ur5check.load("appendix")), random_states(6, 50, seed=0)
    )
    assert found.weight().sum() == pytest.approx(1.0)
    assert (found.weight() >= 0.0).all()
    assert not found.cancels
