from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given

from ur5check import strategies
from ur5check._errors import ModelError
from ur5check._robot import Transform
from ur5check._robot.transforms import cos_sin, skew


@given(strategies.transforms(), strategies.transforms())
def test_composition_is_the_product_of_matrices(T_ab, T_bc):
    np.testing.assert_allclose((T_ab @ T_bc).matrix(), T_ab.matrix() @ T_bc.matrix(), atol=1e-15)


@given(strategies.transforms())
def test_a_transform_undone_is_the_identity(T):
    np.testing.assert_allclose((T @ T.inverse()).matrix(), np.eye(4), atol=1e-15)


@given(strategies.transforms())
def test_rotations_are_rotations(T):
    np.testing.assert_allclose(T.R.T @ T.R, np.eye(3), atol=1e-15)
    assert np.linalg.det(T.R) == pytest.approx(1.0)


@pytest.mark.parametrize("quarters", range(-9, 10))
def test_multiples_of_a_right_angle_are_exact(quarters):
    c, s = cos_sin(quarters * math.pi / 2)
    assert (c, s) == [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters % 4]


def test_angles_that_only_look_like_right_angles_are_not():
    assert cos_sin(1.570796327)[0] == math.cos(1.570796327) != 0.0
    assert cos_sin(1e-300) == (1.0, 1e-300)


def test_rpy_turns_about_fixed_axes_roll_first():
    # A quarter roll takes y to z; the quarter yaw that follows leaves z alone.
    T = Transform.from_rpy((1, 2, 3), (math.pi / 2, 0, math.pi / 2))
    np.testing.assert_array_equal(T.R @ [0, 1, 0], [0, 0, 1])
    np.testing.assert_array_equal(T.p, [1, 2, 3])


@pytest.mark.parametrize("angle", [0.0, 1e-9, 0.5, math.pi - 1e-9, math.pi])
def test_the_angle_of_a_rotation_is_recovered(angle):
    assert Transform.rotation((0, 0.6, 0.8), angle).angle() == pytest.approx(angle, abs=1e-15)


def test_skew_is_the_cross_product():
    u, v = np.array([1.0, -2.0, 3.0]), np.array([0.5, 4.0, -1.0])
    np.testing.assert_array_equal(skew(u) @ v, np.cross(u, v))


def test_a_transform_cannot_be_changed():
    with pytest.raises(ValueError, match="read-only"):
        Transform.identity().R[0, 0] = 2.0


@pytest.mark.parametrize("p", [(1, 2), (1, 2, math.nan)])
def test_a_transform_of_no_numbers_is_refused(p):
    with pytest.raises(ModelError, match=r"^p "):
        Transform(np.eye(3), np.array(p))
