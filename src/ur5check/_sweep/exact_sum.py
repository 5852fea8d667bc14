"""Sums that no order of adding can change: a float64 as a whole number.

Adding floats rounds, so that (a + b) + c is not a + (b + c), and a sum would depend on how many
threads or machines shared the work.  Every float64 is a whole number of 2⁻¹⁰⁷⁴.  Python's integers
add those without rounding, in any order, to the same digits.
"""

from __future__ import annotations

__all__ = ["exact", "mean"]

_SMALLEST = 1074  # 2⁻¹⁰⁷⁴ is the smallest positive float64 [IEEE 754]


def exact(x: float) -> int:
    """x as a number of 2⁻¹⁰⁷⁴, nothing rounded."""
    numerator, denominator = x.as_integer_ratio()
    return numerator << (_SMALLEST - (denominator.bit_length() - 1))


def mean(total: int, count: int) -> float:
    """The mean of `count` values whose exact sum is `total`; rounded once."""
    return total / (count << _SMALLEST)
