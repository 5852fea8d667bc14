"""`ur5check.diff`: when two arms agree, and in which frames their numbers are shown."""

from __future__ import annotations

import numpy as np

import ur5check
from examples import random_arm


def test_an_arm_agrees_with_itself():
    difference = ur5check.diff("appendix", "appendix", samples=100)
    assert difference.agrees


def test_digits_are_no_difference_and_a_gram_is():
    arm = random_arm(3, seed=0)
    inertias = [link.inertia for link in arm.links]

    def heavier(by):
        last = inertias[-1]
        return arm.with_inertias(
            [*inertias[:-1], type(last)(last.mass + by, last.com, last.tensor)]
        )

    assert ur5check.diff(arm, heavier(1e-9), samples=100).agrees
    assert not ur5check.diff(arm, heavier(1e-3), samples=100).agrees


def test_parameters_are_shown_in_the_frames_of_the_first_file():
    difference = ur5check.diff("appendix", "paper", samples=10)
    upper_arm = difference.parameters[1]
    np.testing.assert_allclose(upper_arm.a.com, [0, 0, 0.28], atol=1e-15)  # as the xacro has it
    # the paper's (0.2125, 0, 0.11336), seen from the shoulder along the URDF's axes
    np.testing.assert_allclose(upper_arm.b.com, [0, -0.02249, 0.2125], atol=1e-12)


def test_gravity_can_be_set_for_both():
    difference = ur5check.diff("paper-listing", "paper", samples=10, gravity=(0, 0, -1.62))
    np.testing.assert_array_equal(difference.pair.a.gravity, difference.pair.b.gravity)
