"""`ur5check.diff` tells the stories it should."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._comparison.difference_summary import base_in_words, summarize
from ur5check._robot import Transform


def told(a, b, **options):
    return summarize(ur5check.diff(a, b, samples=500, **options))


def test_paper_against_appendix():
    verdict, geometry, contributions, account = told("paper", "appendix")
    assert "different torques" in verdict
    assert "turned by 180° about z" in geometry
    assert "joint angles as they stand" in geometry
    assert contributions.startswith("Whose it is: link 2, centre of mass")
    assert "Every newton metre has an owner" in account


def test_the_listing_against_the_paper():
    sentences = told("paper-listing", "paper")
    assert (
        "links 2 (0.425 m), 3 (0.3922 m) and 5 (0.09465 m) reach the opposite way" in sentences[1]
    )
    assert "9.806 against 9.81" in sentences[2]
    assert "geometry 100%" in sentences[3]


def test_the_librarys_ur5_against_the_appendix():
    sentences = told("erd-ur5", "appendix")
    assert "link 5, tensor" in sentences[2]
    assert "principal moments of link 6 are 256 times apart" in sentences[3]


def test_an_arm_agrees_with_itself():
    difference = ur5check.diff("appendix", "appendix", samples=100)
    assert difference.agrees
    assert "have the same dynamics" in summarize(difference)[0]


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


@pytest.mark.parametrize(
    ("T", "words"),
    [
        (Transform.identity(), "the same"),
        (Transform.rotation((0, 0, 1), np.pi), "turned by 180° about z"),
        (Transform.rotation((0, 0, 1), -np.pi / 2), "turned by 90° about −z"),
        (Transform.rotation((0.6, 0, 0.8), 1.0), "turned by 57.3° about (0.6, 0, 0.8)"),
        (Transform.translation((0, 0, 0.1)), "shifted by (0, 0, 100) mm"),
    ],
)
def test_base_transforms_in_words(T, words):
    assert base_in_words(T) == words
