"""Statistics of the torque difference over a block of states, and how two are merged.

Sums are exact, counts are integers, of two maxima the larger is kept and of equal ones that of the
earlier state.  Merging is therefore associative and commutative to the last digit: threads, batches
and machines may merge their blocks in any grouping and order.
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
from .magnitude_histogram import BINS, Counts, count_sizes

__all__ = ["Statistics", "merged", "statistics_of"]


@dataclass(frozen=True, eq=False)
class Statistics:
    """Δτ of `count` states, n joints.

    squares : sum of Δτ² per joint, exact (see `exact_sum`)
    maximum : largest |Δτ|, shape (n,) [N m];  worst : index of its state, shape (n,)
    worst_states : those states, q, q̇, q̈ each, shape (n, 3, n)
    bins : logarithmic histograms of |Δτ|, shape (n, BINS) (see `magnitude_histogram`)
    above_tolerance : number of states with |Δτ| above the tolerance, shape (n,)
    visits : number of states per cell of the reach map;  reach : largest |Δτ| there, shape (n,
        cells)
    """

    count: int
    squares: tuple[int, ...]
    maximum: Array
    worst: NDArray[np.int64]
    worst_states: Array
    bins: Counts
    above_tolerance: Counts
    visits: Counts
    reach: Array

    def merge(self, other: Statistics, *, in_place: bool = False) -> Statistics:
        """The statistics of both.

        in_place : write into the histograms of this one, which is lost; new memory for every block
            would take as long as the counting
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
            np.add(self.bins, other.bins, out=self.bins if in_place else None),
            self.above_tolerance + other.above_tolerance,
            self.visits + other.visits,
            np.maximum(self.reach, other.reach),
        )

    def on_map(self, cell: NDArray[np.intp], sizes: Array, cells: int) -> Statistics:
        """The same with a reach map of so many cells.

        cell : of the tool, shape (N,);  sizes : |Δτ| there, shape (N, n)
        """
        reach = np.zeros((sizes.shape[1], cells))
        for row, column in zip(reach, sizes.T, strict=True):
            np.maximum.at(row, cell, column)
        return replace(self, visits=np.bincount(cell, minlength=cells), reach=reach)


def merged(parts: Iterable[Statistics]) -> Statistics:
    """The statistics of all, at least one; none of them is changed."""
    rest = iter(parts)
    total, ours = next(rest), False
    for statistics in rest:
        total, ours = total.merge(statistics, in_place=ours), True
    return total


def statistics_of(
    delta: Array,
    states: States,
    first: int,
    *,
    tolerance: Array | None,
) -> Statistics:
    """Statistics of one block, without a map; joint by joint, so that a row stays in the cache.

    delta : Δτ, shape (N, n) [N m];  first : index of the block's first state
    tolerance : per joint, shape (n,) [N m]; None: none

    Raises StateError for a difference that is not a finite number.
    """
    count, n = delta.shape
    squares = []
    where, above = np.zeros(n, np.int64), np.zeros(n, np.int64)
    maximum, bins = np.zeros(n), np.zeros((n, BINS), np.int64)
    for j in range(n):
        sizes = np.abs(delta[:, j])
        where[j] = sizes.argmax()
        maximum[j] = sizes[where[j]]
        with np.errstate(over="ignore"):
            square = float(np.square(sizes).sum())
        if not math.isfinite(square):
            raise StateError(
                f"state {first + int(where[j])}: the torque difference of joint {j + 1} is "
                f"{delta[where[j], j]} N m; check the numbers of this state"
            )
        squares.append(exact(square))
        bins[j] = count_sizes(sizes)
        if tolerance is not None:
            above[j] = np.count_nonzero(sizes > tolerance[j])
    worst_states = np.stack([part[where] for part in (states.q, states.qd, states.qdd)], axis=1)
    no_map = np.zeros(0, np.int64), np.zeros((n, 0))
    return Statistics(
        count, tuple(squares), maximum, first + where, worst_states, bins, above, *no_map
    )
