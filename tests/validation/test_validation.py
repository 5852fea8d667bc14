"""`ur5check.validate` as people call it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._errors import UsageError
from ur5check._reports import validate_summary as summary
from ur5check._robot.states import random_states
from ur5check._validation.validation import validate_arm


def test_the_paper_against_its_appendix_by_default():
    lines = []
    result = ur5check.validate(samples=100, progress=lines.append)
    assert [model.arm.name for model in result.models] == ["paper", "appendix"]
    assert result.passed
    assert not result.pairs[0].difference.agrees  # a finding, not a failure
    assert any("100 states" in line for line in lines)
    assert summary.summarize(result)[0].startswith("The algorithm is right")


def test_one_model_alone_has_no_difference():
    result = ur5check.validate("erd-ur5", samples=100)
    assert result.passed
    assert result.pairs == ()


def test_the_appendix_is_refereed_through_its_own_text():
    result = ur5check.validate(samples=10)
    assert [model.route for model in result.models] == ["SerialArm", "URDF text, own parser"]


def test_a_wrong_algorithm_is_told_apart_from_different_numbers():
    arm, states = random_arm(4, seed=0), random_states(4, 50, seed=0)
    lighter = arm.with_inertias([replace(link.inertia, mass=0.4) for link in arm.links])
    model = validate_arm(arm, PinocchioEngine(lighter), states)
    result = replace(ur5check.validate(arm, samples=10), models=(model,))
    assert not result.algorithm_right
    assert result.bodies_possible
    assert result.explained
    assert not result.passed
    assert "WRONG" in summary.summarize(result)[0]


def test_gravity_reaches_both_sides():
    moon = ur5check.validate("paper", "appendix", samples=50, gravity=(0, 0, -1.62))
    assert moon.passed
    np.testing.assert_array_equal(moon.models[0].arm.gravity, [0, 0, -1.62])


def test_the_same_seed_gives_the_same_report():
    one, again = (ur5check.validate(samples=50, seed=3) for _ in range(2))
    assert [o.value for o in one.outcomes] == [o.value for o in again.outcomes]


def test_arms_of_different_joints_cannot_be_compared():
    with pytest.raises(UsageError, match="has 6 joints and 'chain_3' has 3"):
        ur5check.validate("paper", random_arm(3, seed=0), samples=10)
