"""The inner loops of a sweep as one pass each, by Numba: imported only where Numba is.

`rows` has the same in NumPy's words, and says what they do.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from .._robot.transforms import Array
from .magnitude_histogram import BINS, FIRST, HIGHEST, LOWEST, SHIFT, Counts
from .numpy_loops import RowStatistics
from .philox import KEY_STEPS, MULTIPLIERS, ROUNDS

__all__ = ["drawn", "row_statistics"]

_QUIET: dict[str, Any] = {"nogil": True, "cache": True, "error_model": "numpy"}
_M0, _M1 = map(np.uint64, MULTIPLIERS)
_W0, _W1 = map(np.uint64, KEY_STEPS)
_LOW, _HALF = np.uint64(0xFFFFFFFF), np.uint64(32)


# No fastmath: NumPy rounds the product and the sum, and so must this, for states are the same to
# the digit whatever computes the torques.  No array of words in between: memory that is asked for
# and given back for every block costs more than the words.
@njit("void(u8, u8, f8[::1], f8[::1], f8[:, ::1])", **_QUIET)
def _drawn(seed: int, block: int, width: Array, lower: Array, out: Array) -> None:
    for group in range(out.shape[0] // 4):
        a, b, c, d = 4 * group, 4 * group + 1, 4 * group + 2, 4 * group + 3
        wa, wb, wc, wd = width[a], width[b], width[c], width[d]
        la, lb, lc, ld = lower[a], lower[b], lower[c], lower[d]
        for k in range(out.shape[1]):
            c0, c1, c2, c3 = np.uint64(k), np.uint64(group), block & _LOW, block >> _HALF
            k0, k1 = seed & _LOW, seed >> _HALF
            for _ in range(ROUNDS):
                p, r = _M0 * c0, _M1 * c2
                c0, c1, c2, c3 = (r >> _HALF) ^ c1 ^ k0, r & _LOW, (p >> _HALF) ^ c3 ^ k1, p & _LOW
                k0, k1 = (k0 + _W0) & _LOW, (k1 + _W1) & _LOW
            out[a, k] = np.uint32(c0) * wa + la
            out[b, k] = np.uint32(c1) * wb + lb
            out[c, k] = np.uint32(c2) * wc + lc
            out[d, k] = np.uint32(c3) * wd + ld


@njit("f8(f8[::1], f8[::1])", fastmath={"reassoc"}, **_QUIET)
def _squares(row: Array, sizes: Array) -> float:
    total = 0.0
    for k in range(len(row)):
        sizes[k] = abs(row[k])
        total += row[k] * row[k]
    return total


@njit("i8(f8[::1], i8[::1], i8[::1], f8)", **_QUIET)
def _counted(sizes: Array, bits: Counts, bins: Counts, tolerance: float) -> int:
    passed = 0
    for k in range(len(sizes)):
        size = sizes[k]
        if size < LOWEST:
            bins[0] += 1
        elif size >= HIGHEST:
            bins[BINS - 1] += 1
        else:
            bins[(bits[k] >> SHIFT) - FIRST] += 1
        passed += size > tolerance
    return passed


def drawn(seed: int, block: int, width: Array, lower: Array, length: int) -> Array:
    """`rows.drawn`, compiled."""
    rows = len(width)
    spare = np.zeros(-rows % 4)  # four rows at a time
    out = np.empty((rows + len(spare), length))
    wide, low = (np.concatenate([values, spare]) for values in (width, lower))
    _drawn(seed, block, wide, low, out)
    return out[:rows]


def row_statistics(row: Array, tolerance: float) -> RowStatistics:
    """`rows.row_statistics`, compiled."""
    sizes, bins = np.empty(len(row)), np.zeros(BINS, np.int64)
    square = float(_squares(row, sizes))
    where = int(sizes.argmax())
    passed = _counted(sizes, sizes.view(np.int64), bins, tolerance)
    return RowStatistics(sizes, where, square, bins, int(passed))
