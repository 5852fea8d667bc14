"""What is kept of a block of states, and how two such records become one.

Sums are whole numbers, counts are integers, of maxima the larger stays and of equal ones that of
the earlier state.  So merging is associative and commutative to the last digit: threads, batches
and machines may bring their blocks in any grouping and order.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .._errors import StateError
from .._robot.states import States
from .._robot.transforms import Array
from .exact_sum import exact
from .loop_choice import row_statistics
from .magnitude_histogram import BINS, Counts

__all__ = ["Statistics", "merged", "statistics_of"]


@dataclass(frozen=True, eq=False)
class Statistics:
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
    tolerance: Counts
    visits: Counts
    reach: Array

    def merge(self, other: Statistics, *, spend: bool = False) -> Statistics:
        """Both together.

        spend : write into this one's large arrays, so that it is no more; fresh memory for every
            block would cost as much as the counting
        """
        theirs = (other.maximum > self.maximum) | (
            (other.maximum == self.maximum) & (other.worst < self.worst)
        )
        return Statistics(
            self.count + other.count,
            tuple(ours + more for ours, more in zip(self.squares, other.squares, strict=True)),
            np.where(theirs, other.maximum, self.maximum),
            np.where(theirs, other.worst, self.worst),
            np.where(theirs[:, None, None], other.worst_states, self.worst_states),
            np.add(self.bins, other.bins, out=self.bins if spend else None),
            self.tolerance + other.tolerance,
            self.visits + other.visits,
            np.maximum(self.reach, other.reach),
        )

    def on_map(self, cell: NDArray[np.intp], sizes: Array, cells: int) -> Statistics:
        """The same with a map of so many cells.

        cell : where the tool is, shape (N,);  sizes : |Δτ| there, shape (N, n)
        """
        reach = np.zeros((sizes.shape[1], cells))
        for row, column in zip(reach, sizes.T, strict=True):
            np.maximum.at(row, cell, column)
        return replace(self, visits=np.bincount(cell, minlength=cells), reach=reach)


def merged(parts: Iterable[Statistics]) -> Statistics:
    """All of them together; at least one.  None of them is changed."""
    rest = iter(parts)
    total, ours = next(rest), False
    for statistics in rest:
        total, ours = total.merge(statistics, spend=ours), True
    return total


def statistics_of(
    delta: Array,
    states: States,
    first: int,
    *,
    tolerance: Array | None,
) -> Statistics:
    """The record of one block without a map, a joint at a time: a row stays in the cache.

    delta : Δτ, shape (N, n) [N m];  first : index of the block's first state
    over : the limit per joint, shape (n,) [N m]; None if none was asked for

    Raises StateError for a difference that is no finite number.
    """
    count, n = delta.shape
    squares = []
    where, passed = np.zeros(n, np.int64), np.zeros(n, np.int64)
    maximum, bins = np.zeros(n), np.zeros((n, BINS), np.int64)
    for j in range(n):
        row = np.ascontiguousarray(delta[:, j])
        sizes, where[j], square, bins[j], passed[j] = row_statistics(
            row, np.inf if tolerance is None else tolerance[j]
        )
        maximum[j] = sizes[where[j]]
        if not math.isfinite(square):
            raise StateError(
                f"state {first + int(where[j])}: the torque difference of joint {j + 1} is "
                f"{delta[where[j], j]} N m, beyond all computing; look at this state's numbers"
            )
        squares.append(exact(square))
    worst_states = np.stack([part[where] for part in (states.q, states.qd, states.qdd)], axis=1)
    no_map = np.zeros(0, np.int64), np.zeros((n, 0))
    return Statistics(
        count, tuple(squares), maximum, first + where, worst_states, bins, passed, *no_map
    )
