"""Sine and cosine by sums and products: as good as rounding allows, up to a given angle."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import chebyfit, cos, mp, mpf, pi, sin, sqrt

from ur5check._dynamics.compiled.sincos import COS, FAR, PI, SIN, turned

EPS = np.finfo(float).eps


@pytest.mark.parametrize("bound", [1.0, np.pi, 100.0, FAR])
def test_error_is_below_two_ulp_of_one(bound):
    x = np.random.default_rng(1).uniform(-bound, bound, 100_000)
    cosine, sine = turned(x)
    assert np.abs(cosine - np.cos(x)).max() <= 2 * EPS
    assert np.abs(sine - np.sin(x)).max() <= 2 * EPS


def test_quarter_turns_and_zero():
    x = np.arange(-8, 9) * (np.pi / 2)
    cosine, sine = turned(x)
    assert np.abs(cosine - np.cos(x)).max() <= EPS
    assert np.abs(sine - np.sin(x)).max() <= EPS
    assert turned(np.array([0.0])) == (1.0, 0.0)


def test_beyond_the_bound_it_is_not_to_be_used():
    x = np.array([1e15 + 0.3])
    _, sine = turned(x)
    assert abs(sine - np.sin(x)) > 1e-6


def test_coefficients_are_those_of_the_fit():
    with mp.workdps(40):
        top = (pi / 2) ** 2
        fits = (
            (SIN, lambda t: sin(sqrt(t)) / sqrt(t) if t > 0 else mpf(1)),
            (COS, lambda t: cos(sqrt(t))),
        )
        for coefficients, function in fits:
            fit, error = chebyfit(function, [0, top], len(coefficients), error=True)
            assert [float(c) for c in reversed(fit)] == list(coefficients)
            assert error < 5e-18


def test_the_parts_of_pi():
    with mp.workdps(60):
        assert abs(sum(map(mpf, PI)) - pi) < mpf(2) ** -110
    for part in PI[:2]:
        mantissa, _ = np.frexp(part)
        assert float(mantissa * 2**33).is_integer()  # times a 16-bit number it is exact
