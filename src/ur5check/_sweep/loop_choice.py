"""Which inner loops a sweep runs: Numba's where it is installed, else NumPy's."""

from __future__ import annotations

from importlib.util import find_spec

from .._robot.transforms import Array
from . import numpy_loops as rows
from .numpy_loops import RowStatistics

__all__ = ["drawn", "row_statistics"]

_NUMBA = find_spec("numba") is not None


def drawn(seed: int, block: int, width: Array, lower: Array, length: int) -> Array:
    """Random numbers of a block, shape (rows, length): to the bit the same whoever draws them.

    width, lower : of each row, shape (rows,); a word w of 32 bits becomes w · width + lower
    """
    if _NUMBA:
        from . import compiled_loops as fused

        return fused.drawn(seed, block, width, lower, length)
    return rows.drawn(seed, block, width, lower, length)


def row_statistics(row: Array, tolerance: float) -> RowStatistics:
    """What is counted of one joint's Δτ, shape (N,), contiguous [N m]."""
    if _NUMBA:
        from . import compiled_loops as fused

        return fused.row_statistics(row, tolerance)
    return rows.row_statistics(row, tolerance)
