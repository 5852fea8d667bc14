"""The logarithmic histogram: every size in its bin, and quantiles no further off than promised."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ur5check._sweep.magnitude_histogram import (
    BINS,
    RELATIVE_ERROR,
    bin_edges,
    count_sizes,
    quantile,
)


def bin_of(size: float) -> int:
    return int(count_sizes(np.array([size])).argmax())


@given(st.floats(min_value=0.0, allow_nan=False, allow_infinity=False))
def test_a_size_lies_between_the_edges_of_its_bin(size):
    lower, upper = bin_edges()[bin_of(size) :][:2]
    assert lower <= size < upper


@pytest.mark.parametrize("edge", [2.0**-40, 2.0**-3, 1.0, 1.0 + 2**-7, 2.0**20])
def test_an_edge_belongs_to_the_bin_above(edge):
    assert bin_edges()[bin_of(edge)] == edge
    assert bin_of(float(np.nextafter(edge, 0.0))) == bin_of(edge) - 1


def test_the_ends_take_what_is_beyond():
    assert bin_of(0.0) == bin_of(1e-300) == 0
    assert bin_of(1e300) == BINS - 1


def test_edges_rise_and_no_bin_is_wider_than_promised():
    edges = bin_edges()
    assert len(edges) == BINS + 1
    assert (np.diff(edges) > 0).all()
    inner = edges[1:-1]
    assert (np.diff(inner) / inner[:-1]).max() <= 2 * RELATIVE_ERROR


@pytest.mark.parametrize("share", [0.001, 0.07, 0.5, 0.9, 0.999, 1.0])
@pytest.mark.parametrize("spread", [0.1, 3.0])
def test_a_quantile_is_as_good_as_promised(share, spread):
    sizes = np.exp(np.random.default_rng(3).normal(0.0, spread, 5001))
    true = float(np.quantile(sizes, share, method="inverted_cdf"))
    found = quantile(count_sizes(sizes), share)
    assert abs(found - true) <= RELATIVE_ERROR * true


def test_seven_hundredths_of_a_hundred_is_seven():
    """0.07 · 100 is 7.000000000000001 in floats, which would ask for the eighth."""
    sizes = np.array([1.0] * 7 + [2.0] * 93)
    assert quantile(count_sizes(sizes), 0.07) == pytest.approx(1.0, rel=RELATIVE_ERROR)


def test_a_coarser_histogram_would_be_seen_to_fail():
    """The promise is tight: half of it is broken by some size."""
    sizes = np.linspace(1.0, 2.0, 1000)
    errors = [abs(quantile(count_sizes(np.array([x])), 1.0) - x) / x for x in sizes]
    assert RELATIVE_ERROR / 2 < max(errors) <= RELATIVE_ERROR
