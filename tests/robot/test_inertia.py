from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given

from ur5check import strategies
from ur5check._errors import ModelError
from ur5check._robot import Inertia, parameter_map


def same(a: Inertia, b: Inertia) -> None:
    np.testing.assert_allclose(a.parameters(), b.parameters(), atol=1e-12)


@given(strategies.inertias())
def test_parameters_are_those_of_pinocchio(inertia):
    theirs = pin.Inertia(inertia.mass, inertia.com, inertia.tensor).toDynamicParameters()
    np.testing.assert_allclose(inertia.parameters(), theirs, atol=1e-13)


@given(strategies.inertias())
def test_parameters_and_back_is_the_same_body(inertia):
    same(Inertia.from_parameters(inertia.parameters()), inertia)


def test_parallel_axes_that_all_but_cancel_leave_a_symmetric_tensor():
    far = Inertia(3700.0, np.array([12.3, -4.56, 7.89]), np.diag([1e-9, 2e-9, 3e-9]))
    tensor = Inertia.from_parameters(far.parameters()).tensor
    np.testing.assert_array_equal(tensor, tensor.T)


@given(strategies.inertias(), strategies.transforms())
def test_a_frame_change_is_that_of_pinocchio(inertia, T):
    body = pin.Inertia(inertia.mass, inertia.com, inertia.tensor)
    theirs = pin.SE3(T.R, T.p).act(body).toDynamicParameters()
    np.testing.assert_allclose(inertia.expressed_in(T).parameters(), theirs, atol=1e-12)


@given(strategies.inertias(), strategies.transforms())
def test_the_parameter_map_is_the_same_frame_change(inertia, T):
    np.testing.assert_allclose(
        parameter_map(T) @ inertia.parameters(), inertia.expressed_in(T).parameters(), atol=1e-12
    )


@given(strategies.inertias(), strategies.inertias())
def test_welding_adds_parameters(a, b):
    np.testing.assert_allclose((a + b).parameters(), a.parameters() + b.parameters(), atol=1e-12)


@given(strategies.inertias())
def test_a_body_with_mass_everywhere_keeps_the_triangle_inequality(inertia):
    assert inertia.triangle_margin() > 0.0


def test_a_body_that_cannot_be_shows_a_negative_margin():
    assert Inertia(1.0, np.zeros(3), np.diag([0.1, 0.1, 0.3])).triangle_margin() < 0.0


def test_nothing_welded_to_nothing_is_nothing():
    same(Inertia.zero() + Inertia.zero(), Inertia.zero())


@pytest.mark.parametrize(
    ("mass", "com", "tensor", "words"),
    [
        (np.nan, np.zeros(3), np.eye(3), "finite"),
        (1.0, np.zeros(2), np.eye(3), "shape"),
        (1.0, np.zeros(3), np.triu(np.ones((3, 3))), "symmetric"),
    ],
)
def test_an_inertia_of_no_numbers_is_refused(mass, com, tensor, words):
    with pytest.raises(ModelError, match=words):
        Inertia(mass, com, tensor)


def test_parameters_without_mass_are_refused():
    with pytest.raises(ModelError, match="without mass"):
        Inertia.from_parameters([0, 1, 0, 0, 0, 0, 0, 0, 0, 0])
