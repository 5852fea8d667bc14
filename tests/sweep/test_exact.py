"""Exact sums: nothing rounded, whatever the order."""

from __future__ import annotations

import math
from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from ur5check._sweep.exact_sum import exact, mean

FINITE = st.floats(allow_nan=False, allow_infinity=False)


@given(FINITE)
def test_a_float_is_kept_whole(x):
    assert Fraction(exact(x), 2**1074) == Fraction(x)


@given(st.lists(st.floats(-1e300, 1e300), min_size=1, max_size=20), st.randoms())
def test_no_order_changes_the_sum(values, random):
    shuffled = random.sample(values, len(values))
    total = sum(map(exact, values))
    assert sum(map(exact, shuffled)) == total
    assert mean(total, 1) == math.fsum(values)


def test_floats_alone_would_not_do():
    values = [1e16, 1.0, -1e16]
    assert sum(values) != sum([1e16, -1e16, 1.0])
    assert mean(sum(map(exact, values)), 1) == 1.0


def test_the_mean_is_rounded_once():
    assert mean(sum(map(exact, [0.1, 0.2, 0.3])), 3) == float(
        (Fraction(0.1) + Fraction(0.2) + Fraction(0.3)) / 3
    )
