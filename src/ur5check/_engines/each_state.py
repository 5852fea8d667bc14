"""Arrays of states for engines whose functions take one state."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .._robot.transforms import Array

__all__ = ["each_state"]


def each_state(one: Callable[..., Array], n: int, shape: tuple[int, ...], *arrays: Array) -> Array:
    """The function `one` at every state, in a Python loop.

    arrays : joint arrays, shape (..., n), whose leading axes broadcast
    one : takes a row of each, shape (n,); returns `shape`

    Returns shape (..., *shape).
    """
    lead = np.broadcast_shapes(*(np.shape(array)[:-1] for array in arrays))
    rows = [np.broadcast_to(array, (*lead, n)).reshape(-1, n) for array in arrays]
    results = np.empty((len(rows[0]), *shape))
    for k, state in enumerate(zip(*rows, strict=True)):
        results[k] = one(*state)
    return results.reshape(*lead, *shape)
