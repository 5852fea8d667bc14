"""Scrambled Sobol points in a box, computed block by block.

Point i is the exclusive or of the direction numbers v_b over the bits b of i's Gray code, i ^ i/2,
and of a shift.  BLOCK is a power of two, so that the bits of BLOCK·k and of a point's index within
block k are disjoint: block k is block 0 with the direction numbers of BLOCK·k's Gray code
exclusive-or'ed into every point.  SciPy's own `fast_forward` (1.17) goes there step by step, with
no more than 32 bits.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._comparison.worst_case.state_box import StateBox
from .._robot.states import States
from .state_sample import BLOCK, box_value, in_box

__all__ = ["SobolSample"]

_BITS = 52  # of a coordinate; a float64 of SciPy holds them exactly

Words = NDArray[np.uint64]


@dataclass(frozen=True, eq=False)
class SobolSample:
    """The first `count` points of one Sobol sequence in 3 n dimensions, scrambled from `seed`."""

    box: StateBox
    count: int
    seed: int

    def block(self, k: int) -> States:
        first, directions = _net(3 * len(self.box.lower), self.seed)
        start = BLOCK * k
        gray = start ^ (start >> 1)
        chosen = [b for b in range(_BITS) if gray >> b & 1]
        jump = np.bitwise_xor.reduce(directions[:, chosen], axis=1)
        length = min(BLOCK, self.count - start)
        return in_box(self.box, first[:, :length] ^ jump[:, None], raster=2.0**-_BITS)

    def description(self) -> dict[str, Any]:
        return {"kind": "sobol", "seed": self.seed, "box": box_value(self.box)}


@lru_cache(maxsize=4)
def _net(dimensions: int, seed: int) -> tuple[Words, Words]:
    """Block 0, shape (dimensions, BLOCK), and direction numbers, shape (dimensions, bits)."""
    from scipy.stats.qmc import Sobol

    sobol = Sobol(dimensions, scramble=True, bits=_BITS, rng=np.random.default_rng(seed))
    points = sobol.random(BLOCK).T
    # Direction numbers are private in SciPy; a test compares our jumps with its sequence.
    return np.ascontiguousarray(points * 2.0**_BITS).astype(np.uint64), sobol._sv.copy()
