"""Weighted least squares whose intervals know that neighbouring samples err alike.

Residuals of filtered signals, and of a model that is not quite right, are correlated in time: the
formula for independent errors gives intervals several times too narrow.  Here the recording is cut
into blocks of time, longer than the correlation, and the covariance is estimated from the scatter
between them (the "sandwich" of Liang & Zeger, Biometrika 73(1), 1986):

    Σ = (XᵀX)⁻¹ (Σ_b X_bᵀ e_b e_bᵀ X_b) (XᵀX)⁻¹ · (B − 1) / B

with Student's quantile of B − 1 degrees of freedom.  A fit bends towards every block; so e_b is
what the block leaves of a fit to all the others, e_b = (1 − H_bb)⁻¹ (y − X β)_b with the hat matrix
H = X (XᵀX)⁻¹ Xᵀ (the jackknife: Bell & McCaffrey, Survey Methodology 28(2), 2002).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._robot.transforms import Array

__all__ = ["UNEXCITED", "Fit", "blocks_of", "fit"]

#: Blocks of a recording, at most: more would be shorter than the correlation of residuals.
_MOST_BLOCKS = 40

#: A block lasts at least this many periods of the cut-off.
_PERIODS = 4.0

#: Singular values below this part of the largest, of columns scaled to one length, are directions
#: that the recording does not excite: noise would be divided by them.
UNEXCITED = 1e-6


@dataclass(frozen=True, eq=False)
class Fit:
    """Coefficients of k columns.

    value, half_width : shape (k,); value ± half_width is nominally a 95 % interval.  It knows
        what differs between blocks of time, not what is wrong alike in all of them: with dry
        friction it held the truth in 50 to 83 % of simulated runs (docs/recordings-benchmark.md)
    covariance : shape (k, k)
    residual : as y
    rank : number of excited directions
    quantile : Student's, that half widths are standard deviations times
    """

    value: Array
    half_width: Array
    covariance: Array
    residual: Array
    rank: int
    quantile: float


def blocks_of(t: Array, segment: NDArray[np.int64], cutoff: float) -> NDArray[np.int64]:
    """The block of each sample: numbers from 0, shape (N,).  No block spans a gap."""
    step = float(np.median(np.diff(t)))
    duration = step * len(t)
    length = max(duration / _MOST_BLOCKS, _PERIODS / cutoff)
    # Time with the gaps taken out, so that blocks are equally long.
    number = np.floor(step * np.arange(len(t)) / length).astype(int)
    number = np.minimum(number, max(0, int(duration / length) - 1))
    _, blocks = np.unique(number + (number.max() + 1) * segment, return_inverse=True)
    return np.asarray(blocks)


def fit(X: Array, y: Array, blocks: NDArray[np.int64]) -> Fit:
    """Least squares of y, shape (rows,), by X, shape (rows, k); `blocks` of the rows."""
    from scipy.stats import t as student

    scale = np.linalg.norm(X, axis=0)
    scale[scale == 0.0] = 1.0
    U, s, Vt = np.linalg.svd(X / scale, full_matrices=False)
    rank = int((s > UNEXCITED * s[0]).sum()) if s[0] > 0.0 else 0
    U, s, Vt = U[:, :rank], s[:rank], Vt[:rank]
    value = (Vt.T @ ((U.T @ y) / s)) / scale
    residual = y - X @ value
    count = int(blocks.max()) + 1
    scatter = _scores(U, residual, blocks, count)
    inner = scatter.T @ scatter * max(1, count - 1) / count
    half = (Vt.T / s) / scale[:, None]
    covariance = half @ inner @ half.T
    quantile = float(student.ppf(0.975, max(1, count - 1)))
    return Fit(value, quantile * np.sqrt(np.diag(covariance)), covariance, residual, rank, quantile)


def _scores(U: Array, residual: Array, blocks: NDArray[np.int64], count: int) -> Array:
    """U_bᵀ (1 − H_bb)⁻¹ e_b of each block, as (1 − U_bᵀ U_b)⁻¹ U_bᵀ e_b, shape (count, rank)."""
    order = np.argsort(blocks, kind="stable")
    ends = np.searchsorted(blocks[order], np.arange(count + 1))
    scores = np.zeros((count, U.shape[1]))
    for b in range(count):
        rows = order[ends[b] : ends[b + 1]]
        values, vectors = np.linalg.eigh(U[rows].T @ U[rows])
        # A direction that one block alone determines has no other block to be judged by.
        free = np.maximum(1.0 - values, 0.01)
        scores[b] = vectors @ ((vectors.T @ (U[rows].T @ residual[rows])) / free)
    return scores
