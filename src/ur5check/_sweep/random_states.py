"""Uniform random states: Philox words placed in intervals, by machine code or NumPy."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._robot.transforms import Array
from .philox import random_words

__all__ = ["drawn", "placed"]

_LLVM = find_spec("llvmlite") is not None


def drawn(seed: int, block: int, width: Array, lower: Array, length: int) -> Array:
    """Random numbers of a block, shape (rows, length): the same to the bit on either path.

    width, lower : of each row, shape (rows,); a word w of 32 bits becomes w · width + lower
    """
    if _LLVM:
        from . import philox_llvm

        return philox_llvm.drawn(seed, block, width, lower, length)
    return placed(random_words(seed, block, len(width), length), width, lower)


def placed(words: NDArray[np.unsignedinteger[Any]], width: Array, lower: Array) -> Array:
    """words · width + lower, each rounded twice, for rows of whole numbers, shape (rows, N).

    width, lower : of each row, shape (rows,)
    """
    values: Array = words * width[:, None]
    values += lower[:, None]
    return values
