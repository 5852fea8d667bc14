"""Stability of an arm that constant torques hold: how fast a small deviation grows.

Around a posture that the torques hold exactly, M ë + (∂g/∂q) e = 0.  With a direction in which
gravity destabilises (∂g/∂q has a negative eigenvalue relative to M), e grows as exp(λ t).  Such an
equilibrium is unstable, like an inverted pendulum.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._dynamics.equations import gravity_torque, mass_matrix
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["gravity_stiffness", "growth_rate"]

_STEP = 1e-20  # of the complex step, which has no cancellation
#: Eigenvalues of a 6 × 6 pencil are known to some hundred ε of the largest.
_ROUNDING = 1e3 * float(np.finfo(np.float64).eps)


def gravity_stiffness(arm: SerialArm, q: ArrayLike) -> Array:
    """∂g/∂q, shape (n, n) [N m/rad], of a posture of shape (n,) [rad]; by complex steps.

    Source of the method: Martins, Sturdza & Alonso 2003.
    """
    steps = np.asarray(q, dtype=np.float64) + 1j * _STEP * np.eye(arm.n)
    return np.asarray(gravity_torque(arm, steps).imag.T / _STEP)


def growth_rate(arm: SerialArm, q: ArrayLike) -> float:
    """λ [1/s]: a small deviation grows as exp(λ t) under constant torques; 0 if it oscillates."""
    from scipy.linalg import eigh

    # ∂g/∂q is the Hessian of the potential: symmetric, so that every λ² is real.
    G = gravity_stiffness(arm, q)
    squares = eigh(-0.5 * (G + G.T), mass_matrix(arm, q), eigvals_only=True)
    fastest, size = float(squares.max()), float(np.abs(squares).max())
    return float(np.sqrt(fastest)) if fastest > _ROUNDING * size else 0.0
