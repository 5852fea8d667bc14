"""Quarter turns that were written with few decimals are found, and only those."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from ur5check._comparison.rounded_constants.rounded_angles import rounded_angles, with_exact_angles
from ur5check._robot import Transform


def test_the_listings_angles_are_those_it_prints():
    found = rounded_angles(ur5check.load("paper-listing"))
    assert [(angle.where, angle.constant, angle.writing.text) for angle in found] == [
        ("P1", "π/2", "1.5707"),
        ("P4", "π/2", "1.5707"),
        ("P5", "π/2", "1.5707"),
    ]


def test_exact_angles_leave_nothing_to_find_and_all_lengths():
    arm = ur5check.load("paper-listing")
    exact = with_exact_angles(arm, rounded_angles(arm))
    assert rounded_angles(exact) == ()
    for before, after in zip(arm.links, exact.links, strict=True):
        written = [link.link_tip_frame.R.T @ link.link_tip_frame.p for link in (before, after)]
        np.testing.assert_allclose(written[1], written[0], atol=1e-15)


@pytest.mark.parametrize(
    ("rpy", "meant", "constant", "text"),
    [
        ((1.5708, 0.0, 0.3), (np.pi / 2, 0.0, 0.3), "π/2", "1.5708"),
        ((-1.5707, 0.2, 0.3), (-np.pi / 2, 0.2, 0.3), "π/2", "1.5707"),
        ((0.1, 0.0, -3.14159), (0.1, 0.0, -np.pi), "π", "3.14159"),
        ((0.0, 0.0, 0.7854), (0.0, 0.0, np.pi / 4), "π/4", "0.7854"),
        ((1.5708, 0.0, -2.0944), (np.pi / 2, 0.0, -2 * np.pi / 3), "π/2", "1.5708"),
    ],
)
def test_a_rounded_angle_beside_another_is_found(rpy, meant, constant, text):
    tip = Transform.from_rpy((0.1, 0.2, 0.3), rpy)
    arm = ur5check.load("paper")
    arm = replace(arm, links=(replace(arm.links[0], link_tip_frame=tip), *arm.links[1:]))
    (found,) = rounded_angles(arm)
    assert (found.where, found.constant, found.writing.text) == ("P1", constant, text)
    np.testing.assert_allclose(
        found.exact, Transform.from_rpy(np.zeros(3), meant).R, atol=1e-14, rtol=0
    )


@pytest.mark.parametrize("angle", [0.3, 0.785, 0.78541, np.pi / 2 + 3.3e-5, np.pi / 2])
def test_a_calibrated_angle_is_no_rounding(angle):
    arm = ur5check.load("paper")
    tip = Transform(Transform.rotation((1, 0, 0), angle).R, arm.links[0].link_tip_frame.p)
    links = (replace(arm.links[0], link_tip_frame=tip), *arm.links[1:])
    assert rounded_angles(replace(arm, links=links)) == ()
