"""The two inner loops of a sweep, on NumPy: numbers into a box, what is counted of one joint."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._robot.transforms import Array
from .magnitude_histogram import Counts, count_sizes
from .philox import random_words

__all__ = ["RowStatistics", "drawn", "placed", "row_statistics"]


class RowStatistics(NamedTuple):
    """One joint's differences in one block.

    sizes : |Δτ|, shape (N,);  where : of the largest one, the first of equal ones
    square : Σ Δτ²;  bins : histogram, shape (BINS,);  passed : sizes above the limit
    """

    sizes: Array
    where: int
    square: float
    bins: Counts
    passed: int


def placed(words: NDArray[np.unsignedinteger[Any]], width: Array, lower: Array) -> Array:
    """words · width + lower, each rounded twice: rows of whole numbers, shape (rows, N), placed.

    width, lower : of each row, shape (rows,)
    """
    values: Array = words * width[:, None]
    values += lower[:, None]
    return values


def drawn(seed: int, block: int, width: Array, lower: Array, length: int) -> Array:
    """The random words of a block (`philox`), placed: shape (rows, length)."""
    return placed(random_words(seed, block, len(width), length), width, lower)


def row_statistics(row: Array, tolerance: float) -> RowStatistics:
    """What is counted of one joint's Δτ, shape (N,) [N m].

    over : the limit, inf if there is none
    """
    sizes = np.abs(row)
    return RowStatistics(
        sizes,
        int(sizes.argmax()),
        float(np.square(sizes).sum()),
        count_sizes(sizes),
        int(np.count_nonzero(sizes > tolerance)),
    )
