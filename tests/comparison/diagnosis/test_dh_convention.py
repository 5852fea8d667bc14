"""A DH table read by the other convention."""

from __future__ import annotations

import numpy as np

import ur5check
from ur5check._comparison.diagnosis.dh_convention import read_by_the_other_rule
from ur5check._robot.states import random_states


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
