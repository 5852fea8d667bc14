"""Linear algebra of base parameters: the rank of a regressor, and which columns carry it.

Y over many states has fewer independent columns than columns.  With the singular value
decomposition Y = U S Vᵀ and V = [V1 V2], V2 spanning the null space, choose the dependent rows D of
V2 so that V2[D] is regular; the others are the base B, and

    Y π = Y[B] π_B,     π_B = π[B] + β π[D],     β = −V2[B] V2[D]⁻¹.

This is the second method of M. Gautier, "Numerical calculation of the base inertial parameters of
robots", Journal of Robotic Systems 8(4), 1991, pp. 485–506; the first, a QR decomposition, selects
the same columns.  The choice of base columns is not unique.  Columns are tried from the least to
the most preferred, and one is dependent if V2[D] stays regular with it: a greedy basis that holds
the most preferred columns.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .._robot.transforms import Array

__all__ = ["SAME_DIRECTION", "Decomposition", "decompose"]

#: Directions smaller than this are rounding of the geometry's digits: the microradian and the
#: micrometre of `alignment`.
SAME_DIRECTION = 1e-6

#: Largest coefficient that is taken as zero: rounding of V, amplified some hundred times.
_ZERO_TOLERANCE = 1e-12


@dataclass(frozen=True, eq=False)
class Decomposition:
    """Rank, base and null space of a matrix with c columns and rank r.

    singular_values : of the scaled columns, descending, shape (c,)
    gap : smallest kept over largest dropped singular value, the latter at least rounding
    base, dependent : column numbers, ascending, shapes (r,) and (c − r,)
    beta : shape (r, c − r)
    seen, unseen : norms of each column's unit vector projected on the row space and on the null
        space, shape (c,); seen² + unseen² = 1
    """

    rank: int
    gap: float
    singular_values: Array
    base: tuple[int, ...]
    dependent: tuple[int, ...]
    beta: Array
    seen: Array
    unseen: Array


def decompose(Y: Array, scale: Array, preference: Sequence[int]) -> Decomposition:
    """Rank and base of Y, shape (rows, c), with at least as many rows as columns.

    scale : size of one unit of each column, shape (c,), which makes different units comparable
    preference : all column numbers, the most preferred base parameter first

    The rank is where the ratio of successive singular values is largest.
    """
    columns = Y.shape[1]
    _, s, Vt = np.linalg.svd(np.linalg.qr(Y / scale, mode="r"))
    floor = np.finfo(np.float64).eps * len(Y) * s[0]
    falls = np.maximum(s, floor) / np.maximum([*s[1:], 0.0], floor)
    rank = int(falls.argmax()) + 1
    V2 = Vt[rank:].T
    dependent = _dependent(V2, preference)
    base = tuple(k for k in range(columns) if k not in dependent)
    beta = np.zeros((rank, 0))
    if dependent:
        beta = -np.linalg.solve(V2[list(dependent)].T, V2[list(base)].T).T
        beta[np.abs(beta) < _ZERO_TOLERANCE] = 0.0
        beta = beta * scale[list(dependent)] / scale[list(base)][:, None]
    seen, unseen = (np.linalg.norm(rows, axis=0) for rows in (Vt[:rank], Vt[rank:]))
    return Decomposition(rank, float(falls[rank - 1]), s, base, dependent, beta, seen, unseen)


def _dependent(V2: Array, preference: Sequence[int]) -> tuple[int, ...]:
    """Independent rows of V2, as many as it has columns: the least preferred ones."""
    rest = V2.copy()  # of each row, the part outside the span of the chosen ones
    chosen: list[int] = []

    def choose(row: int) -> None:
        nonlocal rest
        direction = rest[row] / np.linalg.norm(rest[row])
        chosen.append(row)
        for _ in range(2):  # twice is enough (Kahan, Parlett) to stay orthogonal to rounding
            rest = rest - np.outer(rest @ direction, direction)

    for row in reversed(preference):
        if len(chosen) < V2.shape[1] and np.linalg.norm(rest[row]) > SAME_DIRECTION:
            choose(row)
    while len(chosen) < V2.shape[1]:  # only nearly dependent rows remain: take the largest
        choose(int(np.linalg.norm(rest, axis=1).argmax()))
    return tuple(sorted(chosen))
