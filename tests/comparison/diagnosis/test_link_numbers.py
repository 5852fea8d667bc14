"""A link's numbers as its file gives them, and put back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from ur5check import strategies
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.diagnosis.link_numbers import LinkPair, body_of, with_body


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


def test_both_sides_of_a_link_pair_are_the_same_bodies():
    pair = pair_up(ur5check.load("paper"), ur5check.load("appendix"))
    in_b, in_a = LinkPair.of(pair, "b"), LinkPair.of(pair, "a")
    for k in range(6):
        # what a says, seen by b, and what b says, seen by a: same masses, same distances apart
        assert in_b.truth[k].mass == in_a.bodies[k].mass
        apart_b = np.linalg.norm(in_b.truth[k].com - in_b.bodies[k].com)
        apart_a = np.linalg.norm(in_a.truth[k].com - in_a.bodies[k].com)
        assert apart_b == pytest.approx(apart_a)
