"""One case computed for one model: the torques, the expected torques, and the fitted sine."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .._robot.transforms import Array
from .cases import SWEEP, Case
from .harmonic import Harmonic, fit_harmonic
from .paper_models import Model
from .statics import holding_torque

__all__ = ["Run", "run_case"]

#: Two curves that differ by less of their peak cannot be told apart in a printed plot.
_SEEN_IN_A_PLOT = 0.01

#: Rounding error of a torque: a few roundings of the largest torque at each of n joints. 16 n ε of
#: the largest torque exceeds all errors observed and is far below any claim.
_ROUNDINGS = 16.0

#: The coarsest angle that a URDF or a controller writes for π/2 is 1.570796327: half a unit of its
#: last digit moves a share of that size from one joint's torque to another's.
_ANGLE_DIGITS = 5e-10


@dataclass(frozen=True, eq=False)
class Run:
    """All torques of a case, computed with one model.

    q : shape (N, n) [rad], N = 361 or, in case 9, 1
    torque : of every joint, shape (N, n) [N m]
    expected : the weights' moment on the UR5's own geometry, shape (N, n) [N m]
    scale : of all these torques, the largest [N m]
    harmonic : the watched torque as a sine; None in case 9
    """

    case: Case
    model: Model
    q: Array
    torque: Array
    expected: Array
    scale: float = field(init=False)
    harmonic: Harmonic | None = field(init=False)

    def __post_init__(self) -> None:
        scale = max(float(np.abs(self.torque).max()), float(np.abs(self.expected).max()))
        object.__setattr__(self, "scale", scale)
        swept = self.case.swept is not None
        fit = fit_harmonic(SWEEP, self.watched, self.rounding) if swept else None
        object.__setattr__(self, "harmonic", fit)

    @property
    def rounding(self) -> float:
        """Bound of the rounding error of a torque [N m]."""
        n = len(self.case.posture)
        return _ROUNDINGS * n * float(np.finfo(np.float64).eps) * self.scale

    @property
    def digits(self) -> float:
        """Bound of a torque error due to the digits of the angles in a file [N m]."""
        return _ANGLE_DIGITS * self.scale

    @property
    def watched(self) -> Array:
        """The torque that the case examines, shape (N,) [N m]; of all joints, (n,), in case 9."""
        return self._seen(self.torque)

    @property
    def expected_watched(self) -> Array:
        """The expected value of it, same shape [N m]."""
        return self._seen(self.expected)

    @property
    def peak(self) -> float:
        """Largest size of the watched torque [N m]; 0 where it is only rounding."""
        peak = float(np.abs(self.watched).max())
        return peak if peak > self.rounding else 0.0

    @property
    def expected_peak(self) -> float:
        """Largest size of the expected torque [N m]; 0 where it is only digits."""
        peak = float(np.abs(self.expected_watched).max())
        return peak if peak > self.digits else 0.0

    @property
    def error(self) -> float:
        """Largest deviation from the expected torque [N m]."""
        return float(np.abs(self.watched - self.expected_watched).max())

    @property
    def tolerance(self) -> float:
        """Largest deviation that counts as expected [N m]."""
        return _SEEN_IN_A_PLOT * self.expected_peak + self.digits

    @property
    def as_expected(self) -> bool:
        """Whether the torque balances the weights."""
        return self.error <= self.tolerance

    @property
    def opposed(self) -> bool:
        """Whether it has the opposite sign, over the case as a whole."""
        return float(self.watched @ self.expected_watched) < 0.0

    def _seen(self, tau: Array) -> Array:
        return tau[0] if self.case.watched is None else tau[:, self.case.watched - 1]


def run_case(case: Case, model: Model) -> Run:
    """Compute all torques of the case with the model."""
    q = case.joint_angles()
    return Run(case, model, q, np.asarray(model.torque(q)), holding_torque(model.true_arm, q))
