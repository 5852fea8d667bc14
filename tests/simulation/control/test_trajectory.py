"""A quintic starts and ends at rest; its velocities and accelerations are its derivatives."""

from __future__ import annotations

import numpy as np
import pytest

from ur5check._errors import UsageError
from ur5check._simulation.control.trajectory import Quintic

QUINTIC = Quintic(np.array([0.0, 1.0, -1.0]), np.array([1.0, -1.0, -1.0]), 2.0)


def assert_derivatives(trajectory, *, margin=1e-3, slope=1e-5):
    """Central differences of q are q̇, of q̇ are q̈."""
    h, t = 1e-5, np.linspace(margin, trajectory.duration - margin, 57)
    ahead, here, behind = (trajectory.at(t + step) for step in (h, 0.0, -h))
    np.testing.assert_allclose((ahead.q - behind.q) / (2 * h), here.qd, atol=slope)
    np.testing.assert_allclose((ahead.qd - behind.qd) / (2 * h), here.qdd, atol=slope)


def test_a_quintic_goes_from_rest_to_rest():
    ends = QUINTIC.at([0.0, 2.0])
    np.testing.assert_allclose(ends.q, [QUINTIC.start, QUINTIC.goal])
    assert not np.any(ends.qd)
    assert not np.any(ends.qdd)
    assert_derivatives(QUINTIC)


def test_a_quintic_rests_before_and_after():
    for t, q in ((-1.0, QUINTIC.start), (5.0, QUINTIC.goal)):
        np.testing.assert_array_equal(QUINTIC.at(t).q, q)
        assert not np.any(QUINTIC.at(t).qdd)


@pytest.mark.parametrize(
    ("ends", "message"),
    [
        ((np.zeros(2), np.zeros(3), 1.0), r"shape \(2,\) and goal \(3,\)"),
        ((np.zeros(2), np.array([0.0, np.inf]), 1.0), "finite"),
        ((np.zeros(2), np.zeros(2), 0.0), "duration must be a positive"),
    ],
)
def test_bad_arguments_of_a_quintic_are_refused(ends, message):
    with pytest.raises(UsageError, match=message):
        Quintic(*ends)
