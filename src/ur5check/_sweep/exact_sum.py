"""Sums that do not depend on the order of addition: a float64 as a whole number.

Adding floats rounds, so that (a + b) + c differs from a + (b + c), and a sum would depend on the
number of threads or machines.  Every float64 is an integer multiple of 2⁻¹⁰⁷⁴; Python's integers
add those exactly.
"""

from __future__ import annotations

__all__ = ["exact", "mean"]

_SMALLEST = 1074  # 2⁻¹⁰⁷⁴ is the smallest positive float64 [IEEE 754]


def exact(x: float) -> int:
    """x as a multiple of 2⁻¹⁰⁷⁴, exactly."""
    numerator, denominator = x.as_integer_ratio()
    return numerator << (_SMALLEST - (denominator.bit_length() - 1))


def mean(total: int, count: int) -> float:
    """The mean of `count` values whose exact sum is `total`; rounded once."""
    return total / (count << _SMALLEST)
