"""Stability of the loop: with an exact model the error obeys a linear equation, which has poles.

With model and plant the same, M(θ) (K − θ̈) = 0 (paper, eqs 18–20), so θ̈ = K and

    ë + σ (K_d ė + K_p e + K_i ∫e) = 0, or = θ̈_d where eq. (28) omits it

with σ = +1 for feedback that reduces an error and −1 as printed in eqs (22) and (23).  As a
first-order system in x = (∫e, e, ė) this is ẋ = A x with the block companion matrix

        ⎡    0       1       0   ⎤
    A = ⎢    0       0       1   ⎥
        ⎣ −σ K_i  −σ K_p  −σ K_d ⎦

and every error decays exactly if all eigenvalues of A have negative real parts (Siciliano et al.
2009, ch. 8 and app. C).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..._arguments import instance
from ..._robot.transforms import Array
from .feedback_law import FeedbackLaw
from .gains import Gains

__all__ = ["companion_matrix", "poles"]


def companion_matrix(gains: Gains, law: FeedbackLaw = FeedbackLaw.RIGHT) -> Array:
    """A, shape (3 n, 3 n), of the state (∫e, e, ė); without a K_i, shape (2 n, 2 n) of (e, ė).

    Without K_i the integral is not part of the loop, and its zero eigenvalues are meaningless.
    """
    n, one, zero = gains.n, np.eye(gains.n), np.zeros((gains.n, gains.n))
    ki, kp, kd = (-law.sign * gain for gain in (gains.ki, gains.kp, gains.kd))
    if not gains.ki.any():
        return np.block([[zero, one], [kp, kd]])
    return np.block([[zero, one, np.zeros((n, n))], [zero, zero, one], [ki, kp, kd]])


def poles(gains: Gains, law: FeedbackLaw = FeedbackLaw.RIGHT) -> NDArray[np.complex128]:
    """Poles of the error dynamics, where model and plant are the same.

    Parameters
    ----------
    gains : Gains
    law : FeedbackLaw

    Returns
    -------
    ndarray of complex, shape (3 n,)
        Eigenvalues [1/s], the least damped first; shape (2 n,) without K_i.

    Raises
    ------
    UsageError
        For other types.

    References
    ----------
    Siciliano et al. 2009, ch. 8 and app. C.

    Examples
    --------
    >>> import ur5check
    >>> gains = ur5check.Gains.placed(1, (-8.0, -10.0, -12.0))
    >>> ur5check.poles(gains).real.round(6).tolist()
    [-8.0, -10.0, -12.0]
    """
    instance("gains", gains, Gains, "see ur5check.Gains")
    instance("law", law, FeedbackLaw, "see ur5check.FeedbackLaw")
    values = np.linalg.eigvals(companion_matrix(gains, law)).astype(np.complex128)
    return values[np.argsort(-values.real, kind="stable")]
