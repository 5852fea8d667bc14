"""Feedback gains, as full matrices (paper, eqs 24–26)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._arguments import number_array
from ..._errors import UsageError
from ..._robot.transforms import Array, frozen

__all__ = ["Gains"]


@dataclass(frozen=True, eq=False)
class Gains:
    """Feedback gains as full matrices: row i is joint i's acceleration (paper, eqs 24–26).

    Parameters
    ----------
    kp, ki, kd : array-like, shape (n, n)
        K_p [1/s²], K_i [1/s³] and K_d [1/s].

    Raises
    ------
    UsageError
        For matrices that are not square, not of one size, or not finite.

    Examples
    --------
    >>> import numpy as np
    >>> from ur5check import Gains
    >>> Gains(100.0 * np.eye(6), np.zeros((6, 6)), 20.0 * np.eye(6)).n
    6
    """

    kp: Array
    ki: Array
    kd: Array

    def __post_init__(self) -> None:
        kp = number_array("kp", self.kp, error=UsageError)
        n = len(kp) if kp.ndim else 0
        for name in ("kp", "ki", "kd"):
            matrix = number_array(name, getattr(self, name), error=UsageError)
            if matrix.shape != (n, n) or n == 0:
                raise UsageError(
                    f"{name} has shape {matrix.shape}; give three square matrices of one size, "
                    "one row and one column per joint"
                )
            if not np.isfinite(matrix).all():
                raise UsageError(f"{name} must hold finite numbers only")
            object.__setattr__(self, name, frozen(matrix, (n, n)))

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.kp)

    @classmethod
    def placed(cls, n: int, poles: tuple[float, float, float]) -> Gains:
        """The same three poles for every joint's error: (s − p₁)(s − p₂)(s − p₃).

        Parameters
        ----------
        n : int
            Number of joints.
        poles : tuple of float, length 3
            Negative [1/s].

        Returns
        -------
        Gains

        Raises
        ------
        UsageError
            For poles that are not negative.
        """
        if max(poles) >= 0.0:
            raise UsageError(f"poles must be negative, not {', '.join(f'{p:g}' for p in poles)}")
        _, kd, kp, ki = np.poly(poles)
        return cls(kp * np.eye(n), ki * np.eye(n), kd * np.eye(n))
