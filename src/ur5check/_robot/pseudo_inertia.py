"""Which inertias a body can have: one judgement, with one tolerance, for every command.

A body of positive density has a positive mass and, about its centre of mass, the second moment
Σ = ∫ x xᵀ dm = ½ tr(I) 1 − I without a negative eigenvalue (Wensing, Kim & Slotine 2018,
doi:10.1109/LRA.2017.2729659): the same as the triangle inequality of the principal moments.

Tolerance: each entry may be off by the rounding h_ij of its printed digits (`DigitBounds`).  A few
units of machine precision are added for the eigenvalue solver.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from .transforms import Array

__all__ = ["EXACT", "BodyTest", "DigitBounds", "Fault", "judge_body"]

#: eigvalsh's error on 3×3, and that of the products R I Rᵀ that brought a tensor to where it is
#: judged, of the largest moment.
_SOLVER = 16 * float(np.finfo(np.float64).eps)
#: Least radius of gyration that a tensor is taken to mean [m].
_LEAST_GYRATION = 1e-6

Fault = Literal["mass-negative", "mass-zero", "not-positive-definite", "triangle-inequality"]


@dataclass(frozen=True)
class DigitBounds:
    """How far the printed digits of a tensor may have moved what is judged [kg m²].

    moments : any principal moment;  margin : the smallest of I_a + I_b − I_c

    Neither depends on the axes.  Those of a body made of parts are the sums of theirs.
    """

    moments: float = 0.0
    margin: float = 0.0

    @classmethod
    def of(cls, H: Array) -> DigitBounds:
        """Of entries that may each be off by H_ij, shape (3, 3) [kg m²].

        A symmetric E with |E_ij| ≤ H_ij moves no eigenvalue by more than its spectral norm, and
        that is at most H's.
        """
        # Σ's entries move by at most G: half the trace's rounding on the diagonal, h_ij beside it.
        G = H - np.diag(np.diag(H)) + np.trace(H) / 2 * np.eye(3)
        return cls(float(np.linalg.norm(H, 2)), 2.0 * float(np.linalg.norm(G, 2)))

    def __add__(self, other: DigitBounds) -> DigitBounds:
        return DigitBounds(self.moments + other.moments, self.margin + other.margin)


EXACT = DigitBounds()


@dataclass(frozen=True, eq=False)
class BodyTest:
    """What a mass and a tensor about the centre of mass are.

    mass : [kg];  moments : principal moments, ascending, shape (3,) [kg m²]
    margin : I_a + I_b − I_c of the largest, twice Σ's least eigenvalue [kg m²]
    moment_tolerance, margin_tolerance : how far below zero printed digits may bring them [kg m²]
    """

    mass: float
    moments: Array
    margin: float
    moment_tolerance: float
    margin_tolerance: float

    @cached_property
    def largest(self) -> float:
        """The largest principal moment, without its sign [kg m²]."""
        return float(np.abs(self.moments).max())

    @property
    def has_tensor(self) -> bool:
        """Whether the tensor says anything of the body.

        Zeros do not, nor do numbers that stand for zeros: √(largest moment / mass) below 1 µm, less
        than any part is wide.  Exporters write 1e-20 where nothing was computed.
        """
        return self.largest > 0.0 and self.largest >= abs(self.mass) * _LEAST_GYRATION**2

    @property
    def mass_possible(self) -> bool:
        """Whether the mass can be a body's, or that of a mere frame: zero with no tensor."""
        return self.mass > 0.0 or (self.mass == 0.0 and not self.has_tensor)

    @property
    def positive(self) -> bool:
        """Whether the tensor can be positive definite."""
        return bool(self.moments[0] > -self.moment_tolerance) and bool(self.moments[2] > 0.0)

    @property
    def triangle(self) -> bool:
        """Whether the triangle inequality can hold."""
        return self.margin >= -self.margin_tolerance

    @property
    def fault(self) -> Fault | None:
        """Why no body has these numbers; None for a body, a point mass, and a mere frame."""
        if not self.mass_possible:
            return "mass-negative" if self.mass < 0.0 else "mass-zero"
        if not self.has_tensor:
            return None
        if not self.positive:
            return "not-positive-definite"
        return None if self.triangle else "triangle-inequality"


def judge_body(mass: float, tensor: Array, digits: DigitBounds = EXACT) -> BodyTest:
    """Judge a mass [kg] and a tensor about the centre of mass, symmetric, shape (3, 3) [kg m²]."""
    moments: Array = np.asarray(np.linalg.eigvalsh(tensor), dtype=np.float64)
    solver = _SOLVER * float(np.abs(moments).max())
    margin = float(np.trace(tensor)) - 2.0 * float(moments[2])
    return BodyTest(mass, moments, margin, digits.moments + solver, digits.margin + 2.0 * solver)
