"""Sine and cosine by sums and products alone, for vector instructions.

The functions of libm use tables and branches, which cannot be vectorised.  Here the angle is
reduced to r in [−π/2, π/2] by a multiple m of π, subtracted in three parts (Cody & Waite 1980), and

    sin x = (−1)^m sin r,   cos x = (−1)^m cos r,

where sin r / r and cos r are polynomials in r² (`SIN`, `COS`: Chebyshev fits on the interval, whose
errors 2e-19 and 4e-18 are far below rounding).  Adding and subtracting 1.5 · 2⁵² rounds to an
integer.

Up to `FAR` radians a value is within 2 ulp of 1 of the true one; beyond, a kernel calls libm.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

__all__ = ["COS", "FAR", "PI", "SIN", "turned"]

#: Largest angle for which m · PI[0] and m · PI[1] are exact [rad]: m < 2¹⁶, 33 bits each.
FAR = 1e5

#: π in three parts of which the first two have 33 bits.
PI = (3.1415926534682512, 1.2154201012607932e-10, 4.044532497591901e-21)

#: sin √t / √t and cos √t as polynomials in t on [0, (π/2)²], constant term first.
SIN = (
    1.0,
    -0.16666666666666666,
    0.008333333333333186,
    -0.00019841269841208676,
    2.7557319211229606e-06,
    -2.505210689056952e-08,
    1.605894087848656e-10,
    -7.643026557971632e-13,
    2.7215749422983443e-15,
)
COS = (
    1.0,
    -0.4999999999999997,
    0.04166666666666388,
    -0.001388888888877299,
    2.4801587277414926e-05,
    -2.755731639102575e-07,
    2.0876561839933163e-09,
    -1.1462901901757276e-11,
    4.608977003001797e-14,
)

_ROUND = 6755399441055744.0  # 1.5 · 2⁵²


def turned(x: Any) -> tuple[Any, Any]:
    """cos x and sin x of anything that adds and multiplies as float64 does [rad].

    For example arrays of NumPy, and `llvm_values.Values`.
    """
    m = (x * (1.0 / math.pi) + _ROUND) - _ROUND
    r = ((x - m * PI[0]) - m * PI[1]) - m * PI[2]
    odd = m - 2.0 * ((m * 0.5 + _ROUND) - _ROUND)
    sign = 1.0 - 2.0 * odd * odd
    t = r * r
    return sign * _polynomial(COS, t), sign * r * _polynomial(SIN, t)


def _polynomial(coefficients: Sequence[float], t: Any) -> Any:
    *rest, value = coefficients
    for coefficient in reversed(rest):
        value = value * t + coefficient
    return value
