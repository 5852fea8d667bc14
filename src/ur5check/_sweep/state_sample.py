"""The states of a sweep in blocks, each of which is computed without the others.

Block k holds the states BLOCK·k … BLOCK·(k + 1) − 1.  The states depend on BLOCK, so no option
changes it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .._comparison.worst_case.state_box import StateBox
from .._robot.states import States
from .._robot.transforms import Array
from .random_states import drawn, placed

__all__ = ["BLOCK", "GridSample", "RandomSample", "Sample", "blocks_of", "box_value", "in_box"]

BLOCK = 16_384  # with 18 numbers per state 2.4 MB, about the cache of a core


class Sample(Protocol):
    """The states of a sweep."""

    @property
    def count(self) -> int:
        """Number of states."""
        ...

    def block(self, k: int) -> States:
        """The states of block k; the last may be shorter."""
        ...

    def description(self) -> dict[str, Any]:
        """Everything the states depend on, as plain values for JSON."""
        ...


def blocks_of(sample: Sample) -> int:
    """Number of blocks."""
    return -(-sample.count // BLOCK)


@dataclass(frozen=True, eq=False)
class RandomSample:
    """Uniform in a box, by Philox of seed, block and a counter (`philox`); the 32-bit words place a
    state on a raster of 2⁻³² of the box.
    """

    box: StateBox
    count: int
    seed: int

    def block(self, k: int) -> States:
        length = _length(self, k)  # a short last block is the beginning of a whole one
        return _states(drawn(self.seed, k, *_cells(self.box, 2.0**-32), length))

    def description(self) -> dict[str, Any]:
        return {"kind": "random", "seed": self.seed, "box": box_value(self.box)}


@dataclass(frozen=True, eq=False)
class GridSample:
    """Positions at rest, `levels` of each joint, in the middles of equal parts of its range.

    A grid of q, q̇ and q̈ together would have two levels per axis at a billion states; a grid of
    positions shows the torques of gravity in the whole workspace.
    """

    box: StateBox
    levels: int

    @property
    def count(self) -> int:
        return int(self.levels ** len(self.box.lower))

    def block(self, k: int) -> States:
        n = len(self.box.lower)
        index = np.arange(BLOCK * k, BLOCK * k + _length(self, k))
        level = np.stack([index // self.levels**i % self.levels for i in range(n)])
        width = (self.box.upper - self.box.lower) / self.levels
        q = (self.box.lower + width / 2)[:, None] + width[:, None] * level
        rest = np.zeros_like(q)
        return States(q.T, rest.T, rest.T)

    def description(self) -> dict[str, Any]:
        box = box_value(self.box)
        box["rate"] = box["acceleration"] = [0.0] * len(self.box.lower)
        return {"kind": "grid", "levels": self.levels, "box": box}


def in_box(box: StateBox, words: NDArray[Any], *, raster: float) -> States:
    """States from whole numbers 0 … 1/raster − 1, shape (3 n, N)."""
    return _states(placed(words, *_cells(box, raster)))


def _cells(box: StateBox, raster: float) -> tuple[Array, Array]:
    """Width of a cell of the raster and the middle of the first, for each of 3 n rows."""
    lower = np.concatenate([box.lower, -box.rate, -box.acceleration])
    width = np.concatenate([box.upper - box.lower, 2.0 * box.rate, 2.0 * box.acceleration]) * raster
    return width, lower + 0.5 * width


def _states(values: Array) -> States:
    q, qd, qdd = np.split(values, 3)
    return States(q.T, qd.T, qdd.T)


def box_value(box: StateBox) -> dict[str, Any]:
    """The box as plain numbers."""
    return {
        "lower": box.lower.tolist(),
        "upper": box.upper.tolist(),
        "rate": box.rate.tolist(),
        "acceleration": box.acceleration.tolist(),
    }


def _length(sample: Sample, k: int) -> int:
    return min(BLOCK, sample.count - BLOCK * k)
