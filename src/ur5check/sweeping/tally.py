"""What is kept of a block of states, and how two such records become one.

Sums are whole numbers, counts are integers, of maxima the larger stays and of equal ones that of
the earlier state.  So merging is associative and commutative to the last digit: threads, batches
and machines may bring their blocks in any grouping and order.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from ..arm.states import States
from ..arm.transforms import Array
from ..errors import StateError
from .exact import exact
from .magnitudes import Counts, count_sizes

__all__ = ["Tally", "merged", "tally_of"]


@dataclass(frozen=True, eq=False)
class Tally:
    """Δτ of `count` states, n joints.

    squares : sum of Δτ² per joint, exact (see `exact`)
    maximum : largest |Δτ|, shape (n,) [N m];  worst : index of its state, shape (n,)
    worst_states : those states, q, q̇, q̈ each, shape (n, 3, n)
    bins : logarithmic histograms of |Δτ|, shape (n, BINS) (see `magnitudes`)
    over : states with |Δτ| above the limit that was asked for, shape (n,)
    visits : states on the reach map, per cell;  reach : largest |Δτ| there, shape (n, cells)
    """

    count: int
    squares: tuple[int, ...]
    maximum: Array
    worst: NDArray[np.int64]
    worst_states: Array
    bins: Counts
    over: Counts
    visits: Counts
    reach: Array

    def merge(self, other: Tally) -> Tally:
        """Both together."""
        theirs = (other.maximum > self.maximum) | (
            (other.maximum == self.maximum) & (other.worst < self.worst)
        )
        return Tally(
            self.count + other.count,
            tuple(ours + more for ours, more in zip(self.squares, other.squares, strict=True)),
            np.where(theirs, other.maximum, self.maximum),
            np.where(theirs, other.worst, self.worst),
            np.where(theirs[:, None, None], other.worst_states, self.worst_states),
            self.bins + other.bins,
            self.over + other.over,
            self.visits + other.visits,
            np.maximum(self.reach, other.reach),
        )


def merged(tallies: Iterable[Tally]) -> Tally:
    """All of them together; at least one."""
    return reduce(Tally.merge, tallies)


def tally_of(
    delta: Array,
    states: States,
    first: int,
    *,
    over: Array | None,
    cell: NDArray[np.intp],
    cells: int,
    every: int,
) -> Tally:
    """The record of one block: few passes over rows that stay in the cache.

    delta : Δτ, shape (N, n) [N m];  first : index of the block's first state
    over : the limit per joint, shape (n,) [N m]; None if none was asked for
    cell : where the tool of every `every`-th state is, on a map of `cells` cells

    Raises StateError for a difference that is no finite number.
    """
    rows = np.ascontiguousarray(delta.T)  # one row a joint
    n, count = rows.shape
    sizes = np.abs(rows)
    where = sizes.argmax(axis=1)  # the first of equal ones, and of those that are no number
    squares = np.square(rows).sum(axis=1)
    if not np.isfinite(squares).all():
        j = int(np.flatnonzero(~np.isfinite(squares))[0])
        raise StateError(
            f"state {first + int(where[j])}: the torque difference of joint {j + 1} is "
            f"{rows[j, where[j]]} N m, beyond all computing; look at this state's numbers"
        )
    reach = np.zeros((n, cells))
    for found, size in zip(reach, sizes[:, ::every], strict=True):
        np.maximum.at(found, cell, size)
    return Tally(
        count,
        tuple(exact(float(total)) for total in squares),
        sizes[np.arange(n), where],
        first + where.astype(np.int64),
        np.stack([part[where] for part in (states.q, states.qd, states.qdd)], axis=1),
        count_sizes(sizes),
        np.zeros(n, np.int64) if over is None else (sizes > over[:, None]).sum(axis=1),
        np.bincount(cell, minlength=cells),
        reach,
    )
