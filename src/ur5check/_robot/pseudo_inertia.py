"""Which inertias a body can have: one judgement, with one tolerance, for every command.

A body of positive density has a positive mass and, about its centre of mass, the second moment
Σ = ∫ x xᵀ dm = ½ tr(I) 1 − I without a negative eigenvalue (Wensing, Kim & Slotine 2018,
doi:10.1109/LRA.2017.2729659): the same as the triangle inequality of the principal moments.

Tolerance: each entry may be off by the rounding h_ij of its printed digits.  A symmetric E with
|E_ij| ≤ H_ij moves no eigenvalue by more than its spectral norm, and that is at most H's.  A few
units of machine precision are added for the eigenvalue solver.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .transforms import Array

__all__ = ["TensorTest", "judge_tensor"]

_SOLVER = 16 * float(np.finfo(np.float64).eps)  # of the largest moment: eigvalsh's error on 3×3


@dataclass(frozen=True, eq=False)
class TensorTest:
    """What a tensor about the centre of mass is.

    moments : principal moments, ascending, shape (3,) [kg m²]
    margin : I_a + I_b − I_c of the largest, twice Σ's least eigenvalue [kg m²]
    moment_tolerance, margin_tolerance : how far below zero printed digits may bring them [kg m²]
    """

    moments: Array
    margin: float
    moment_tolerance: float
    margin_tolerance: float

    @property
    def positive(self) -> bool:
        """Whether it can be positive definite."""
        return bool(self.moments[0] > -self.moment_tolerance) and bool(self.moments[2] > 0.0)

    @property
    def triangle(self) -> bool:
        """Whether the triangle inequality can hold."""
        return self.margin >= -self.margin_tolerance


def judge_tensor(tensor: Array, rounding: Array | float = 0.0) -> TensorTest:
    """Judge a tensor about the centre of mass.

    tensor : symmetric, shape (3, 3) [kg m²];  rounding : of its entries, (3, 3) or one number
    """
    moments: Array = np.asarray(np.linalg.eigvalsh(tensor), dtype=np.float64)
    solver = _SOLVER * float(np.abs(moments).max())
    H = np.broadcast_to(np.asarray(rounding, dtype=np.float64), (3, 3))
    # Σ's entries move by at most G: half the trace's rounding on the diagonal, h_ij beside it.
    G = H - np.diag(np.diag(H)) + np.trace(H) / 2 * np.eye(3)
    margin = float(np.trace(tensor)) - 2.0 * float(moments[2])
    return TensorTest(
        moments,
        margin,
        float(np.linalg.norm(H, 2)) + solver,
        2.0 * (float(np.linalg.norm(G, 2)) + solver),
    )
