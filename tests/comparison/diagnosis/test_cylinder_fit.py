"""The cylinder behind a tensor, and none where there is none."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from ur5check._comparison.diagnosis.cylinder_fit import Cylinder, fit_cylinder


@given(st.integers(0, 2), st.floats(0.01, 1.0), st.floats(0.01, 2.0), st.floats(0.1, 50.0))
def test_a_cylinder_is_found_behind_its_tensor(axis, radius, length, mass):
    made = Cylinder(axis, radius, length)
    found = fit_cylinder(mass, made.tensor(mass))
    assert found is not None
    np.testing.assert_allclose(found.tensor(mass), made.tensor(mass), rtol=1e-6)


@pytest.mark.parametrize(
    ("mass", "tensor"),
    [
        (0.0, np.eye(3)),
        (1.0, np.diag([1.0, 2.0, 2.5])),
        (1.0, np.diag([1.0, 1.0, 2.5])),  # flatter than any disc
        (1.0, np.array([[1.0, 0.5, 0], [0.5, 1.0, 0], [0, 0, 1.0]])),
    ],
)
def test_what_is_no_cylinder_is_not_called_one(mass, tensor):
    assert fit_cylinder(mass, tensor) is None


def test_the_printed_axial_moments_are_those_of_cylinders():
    # FACTS: every printed I_zz equals ½ m r²; r = 0.06 m but for the last link.
    for link, radius in zip(
        ur5check.load("appendix").links, (0.06, 0.06, 0.06, 0.06, 0.06, 0.0375), strict=True
    ):
        inertia = link.inertia.expressed_in(link.source_frame.inverse())
        fitted = fit_cylinder(inertia.mass, inertia.tensor)
        assert fitted is not None
        assert fitted.radius == pytest.approx(radius, rel=1e-6)
