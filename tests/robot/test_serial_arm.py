from __future__ import annotations

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._errors import ModelError, UsageError
from ur5check._robot import Joint, SerialArm
from ur5check._robot.states import random_states


def test_an_axis_is_made_a_unit_vector_and_a_unit_vector_is_left_alone():
    np.testing.assert_allclose(Joint("j", [0, 3, 4]).axis, [0, 0.6, 0.8])
    np.testing.assert_array_equal(Joint("j", [0, -1, 0]).axis, [0, -1, 0])


def test_a_zero_axis_is_refused():
    with pytest.raises(ModelError, match="axis is zero"):
        Joint("j", [0, 0, 0])


def test_an_arm_needs_a_joint_and_as_many_links():
    with pytest.raises(ModelError, match="0 joints"):
        SerialArm("a", (), ())
    with pytest.raises(ModelError, match="1 joints and 0 links"):
        SerialArm("a", (Joint("j", [0, 0, 1]),), ())


def test_parameters_are_ten_a_link():
    assert random_arm(3, seed=0).parameters().shape == (30,)


def test_states_come_from_their_seed():
    one, again, other = (random_states(3, 5, seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.q, again.q)
    assert not np.array_equal(one.q, other.q)
    assert np.abs(one.q).max() <= np.pi


@pytest.mark.parametrize(("count", "seed"), [(0, 0), (-1, 0), (5, -1)])
def test_no_states_and_no_seed_are_refused(count, seed):
    with pytest.raises(UsageError):
        random_states(3, count, seed)


def test_an_arm_with_other_numbers_is_no_longer_its_file():
    arm = ur5check.load("appendix")
    assert arm.source.urdf is not None
    for changed in (
        arm.with_inertias([link.inertia for link in arm.links]),
        arm.with_armature([0.1] * 6),
    ):
        assert changed.source.urdf is None
        assert changed.source.inputs == arm.source.inputs
    assert arm.with_gravity((0, 0, -1.62)).source.urdf == arm.source.urdf


@pytest.mark.parametrize("size", [1e200, 1e-200, 1e308, 5e-324])
def test_an_axis_whose_square_is_no_double_is_made_a_unit_vector(size):
    np.testing.assert_array_equal(Joint("j", [0, -size, 0]).axis, [0, -1, 0])
