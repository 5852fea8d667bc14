"""A fine logarithmic histogram of |Δτ|, from which quantiles are computed.

The exponent of a float64 and the first bits of its mantissa, read as one integer, number the bins
of a histogram with 128 bins per octave: no logarithm is computed, and no bin edge is rounded.  Two
histograms are merged by adding integers.

    bin 0         below 2⁻⁴⁰ = 9.1e-13 (and zero itself)
    bins 1 …      128 per octave up to 2²⁰ = 1.0e6
    the last bin  2²⁰ and beyond

A quantile is the middle of its bin, with a relative error of at most RELATIVE_ERROR.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from .._robot.transforms import Array

__all__ = [
    "BINS",
    "FIRST",
    "HIGHEST",
    "LOWEST",
    "RELATIVE_ERROR",
    "SHIFT",
    "Counts",
    "bin_edges",
    "count_sizes",
    "quantile",
]

Counts = NDArray[np.int64]

_MANTISSA = 7  # bits of it in the number of a bin
SHIFT = 52 - _MANTISSA
LOWEST, HIGHEST = 2.0**-40, 2.0**20  # [N m]
_BELOW = float(np.nextafter(LOWEST, 0.0))  # its bits are one bin below the first
FIRST = int(np.float64(_BELOW).view(np.int64)) >> SHIFT

BINS = (int(np.float64(HIGHEST).view(np.int64)) >> SHIFT) - FIRST + 1

#: Half the width of a bin, relative to its lower edge.
RELATIVE_ERROR = 2.0 ** -(_MANTISSA + 1)


def count_sizes(sizes: Array) -> Counts:
    """The histogram of sizes, shape (N,), not negative: counts of shape (BINS,)."""
    bins = np.clip(sizes, _BELOW, HIGHEST).view(np.int64)
    bins >>= SHIFT
    bins -= FIRST
    return np.bincount(bins, minlength=BINS)


def bin_edges() -> Array:
    """Lower edges of all bins and the upper edge of the last, shape (BINS + 1,): 0 … ∞."""
    edges = ((FIRST + np.arange(BINS + 1)) << SHIFT).view(np.float64)
    edges[0], edges[-1] = 0.0, np.inf
    return edges


def quantile(counts: Counts, share: float) -> float:
    """The size that `share` of the states do not exceed, from one histogram of shape (BINS,).

    The middle of a bin; of the last, the lower edge.
    """
    below = np.cumsum(counts)
    rank = math.ceil(Fraction(str(share)) * int(below[-1]))  # 0.07 means seven hundredths
    found = int(np.searchsorted(below, max(rank, 1)))
    lower, upper = bin_edges()[found : found + 2]
    return float(lower if np.isinf(upper) else 0.5 * (lower + upper))
