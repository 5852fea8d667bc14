"""An explained difference in a few sentences."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import ur5check
from examples import planar_arm
from ur5check._reports.explanation_summary import summarize


def lines_of(a, b):
    return summarize(ur5check.explain(ur5check.diff(a, b, samples=300)))


def test_the_listing_has_lost_three_signs():
    lines = lines_of("paper-listing", "paper")
    assert "Links 2, 3 and 5 of paper-listing: a sign of the length is lost" in lines[1]
    assert "removes 100% of the difference" in lines[1]
    assert any(line.startswith("Worst state within limits: ") for line in lines)


def test_two_measurements_have_no_known_mistake():
    arm = ur5check.load("appendix")
    rng = np.random.default_rng(0)
    inertias = [
        replace(link.inertia, mass=link.inertia.mass * rng.uniform(0.95, 1.05))
        for link in arm.links
    ]
    lines = lines_of(arm, arm.with_inertias(inertias))
    assert "No single known mistake explains the difference." in lines


def test_the_worst_joint_is_named_as_in_its_own_model():
    lines = lines_of("paper", "appendix")
    assert any("Worst state" in line and "joint 2 (shoulder)" in line for line in lines)
    pendulum = planar_arm((0.7,), (2.0,))
    heavier = planar_arm((0.7,), (2.3,))
    found = lines_of(pendulum, heavier)
    assert any("Worst state" in line and "joint 1 (joint_0)" in line for line in found)


def test_no_difference_has_no_mistake():
    assert "have the same dynamics" in lines_of("appendix", "appendix")[0]
