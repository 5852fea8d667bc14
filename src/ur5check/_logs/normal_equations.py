"""What a recording says about changes of the inertial parameters, in a few numbers.

Weighted residual e and regressor Y enter every least-squares fit by YᵀY, Yᵀe and eᵀe alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._robot.transforms import Array

__all__ = ["NormalEquations"]


@dataclass(frozen=True, eq=False)
class NormalEquations:
    """Of 10 n parameters, with drives taken out of both sides.

    G : YᵀY, shape (10 n, 10 n);  g : Yᵀe, shape (10 n,);  base : eᵀe
    floor : sum of squares that is left with all parameters free
    independent : independent rows over rows: sums of squares times this are as of so many
    rank : excited directions
    """

    G: Array
    g: Array
    base: float
    floor: float
    independent: float
    rank: int

    def rest(self, change: Array) -> Array:
        """Sums of squares that known changes of the parameters, shape (…, 10 n), leave."""
        return np.asarray(
            self.base
            - 2.0 * change @ self.g
            + np.einsum("...i,ij,...j->...", change, self.G, change)
        )
