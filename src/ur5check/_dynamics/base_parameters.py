"""Linear algebra of base parameters: the rank of a regressor, and which columns carry it.

Y over many states has fewer independent columns than columns.  With the singular value
decomposition Y = U S Vᵀ and V = [V1 V2], V2 spanning the null space, choose the dependent rows D of
V2 so that V2[D] is regular; the others are the base B, and

    Y π = Y[B] π_B,     π_B = π[B] + β π[D],     β = −V2[B] V2[D]⁻¹.

This is the second method of M. Gautier, "Numerical calculation of the base inertial parameters of
robots", Journal of Robotic Systems 8(4), 1991, pp. 485–506; the first, a QR decomposition, picks
the same columns.  Which columns may be base is a matter of choice.  We walk from the least wanted
one upwards and call a column dependent whenever that still leaves V2[D] regular, so the base
holds the most wanted ones: the rule of a greedy basis, seen from the null space.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .._robot.transforms import Array

__all__ = ["SAME_DIRECTION", "Decomposition", "decompose"]

#: What is smaller than this is a rounded digit of the geometry, not a direction of its own: the
#: microradian and the micrometre of `alignment`.
SAME_DIRECTION = 1e-6

_ZERO_TOLERANCE = (
    1e-12  # of a coefficient that is zero: rounding of V, some hundred times amplified
)


@dataclass(frozen=True, eq=False)
class Decomposition:
    """What a matrix with c columns of rank r can tell.

    singular_values : of the scaled columns, descending, shape (c,)
    gap : smallest kept over largest dropped singular value, the latter at least rounding
    base, dependent : column numbers, ascending, shapes (r,) and (c − r,)
    beta : shape (r, c − r)
    seen, unseen : for each column, how much of its unit vector lies in the row space and how much
        in the null space; shape (c,), seen² + unseen² = 1
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

    scale : size of each column's unit, shape (c,), so that columns of different units compare
    preference : all column numbers, the one most wanted as a base parameter first

    The rank is where the singular values fall most steeply.
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
    """As many rows of V2, independent of each other, as it has columns: the least wanted ones."""
    rest = V2.copy()  # of each row, what the chosen ones do not span
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
    while len(chosen) < V2.shape[1]:  # only near-dependent rows are left: the largest of them
        choose(int(np.linalg.norm(rest, axis=1).argmax()))
    return tuple(sorted(chosen))
