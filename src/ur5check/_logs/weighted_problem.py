"""Residuals as every cause sees them: less what drives explain, weighted by the floor.

Friction and rotor inertia are taken out of the residual and of every column, which is the same as
fitting them at the same time (Frisch & Waugh, Econometrica 1(4), 1933).  A cause is rated by how
much it lowers the sum of squares, less what its coefficients and the number of alternatives would
lower by chance (Bayes' information criterion, Schwarz, Annals of Statistics 6(2), 1978).  Errors of
neighbouring samples are alike: the criterion counts independent samples, estimated from the scatter
between blocks of time.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .._dynamics.regressor import torque_regressor
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .cause import Cause, CauseId
from .joint_residuals import model_torque, thinned
from .least_squares import UNEXCITED, Fit, blocks_of, fit
from .normal_equations import NormalEquations
from .signals import Signals

__all__ = ["WeightedProblem"]

#: Samples that many causes are tried on first.
_FIRST_SAMPLES = 800


@dataclass(frozen=True, eq=False)
class WeightedProblem:
    """The residual of one arm and one recording.

    signals : thinned, N of them
    model : the model's torque, shape (N, n) [N m]
    Q : for each joint an orthonormal basis of its drive's columns
    sizes : weights, shape (n,)
    blocks : of every weighted row, shape (N n,)
    Y : regressor, weighted, shape (N n, 10 n)
    residual : measured − model, weighted, shape (N n,)
    normal : of both
    """

    arm: SerialArm
    signals: Signals
    model: Array
    Q: tuple[Array, ...]
    sizes: Array
    blocks: NDArray[np.int64]
    Y: Array
    residual: Array
    normal: NormalEquations

    @classmethod
    def of(cls, arm: SerialArm, signals: Signals, sizes: Array) -> WeightedProblem:
        signals = signals.selected(thinned(signals))
        Q = tuple(_basis(signals.drive[:, j]) for j in range(arm.n))
        blocks = np.repeat(blocks_of(signals.t, signals.segment, signals.cutoff), arm.n)
        torque = model_torque(arm, signals)
        none = np.zeros(0)
        empty = NormalEquations(none, none, 0.0, 0.0, 1.0, 0)
        problem = cls(arm, signals, torque, Q, sizes, blocks, none, none, empty)
        Y = problem.weighted(torque_regressor(arm, signals.q, signals.qd, signals.qdd))
        residual = problem.weighted(signals.tau - torque)
        G, g = Y.T @ Y, Y.T @ residual
        basis, rank = _excited(G)
        scores = basis.T @ g
        rest = residual - Y @ (basis @ scores)
        independent = _independent(Y @ basis, rest, blocks)
        normal = NormalEquations(
            G, g, float(residual @ residual), float(rest @ rest), independent, rank
        )
        return replace(problem, Y=Y, residual=residual, normal=normal)

    def coarse(self) -> WeightedProblem:
        """The same with at most `_FIRST_SAMPLES` samples, for trying many causes."""
        step = -(-self.signals.count // _FIRST_SAMPLES)
        if step == 1:
            return self
        few = self.signals.selected(slice(None, None, step))
        return WeightedProblem.of(self.arm, few, self.sizes)

    @property
    def n(self) -> int:
        """Number of joints."""
        return self.arm.n

    def weighted(self, torque: Array) -> Array:
        """Torques less what drives explain, over the floor.

        torque : shape (N, n, …); the result has shape (N n, …)
        """
        free = np.empty_like(torque)
        for j, Q in enumerate(self.Q):
            free[:, j] = (torque[:, j] - Q @ (Q.T @ torque[:, j])) / self.sizes[j]
        return np.asarray(free.reshape(-1, *torque.shape[2:]))

    def fitted(self, residual: Array, columns: list[Array]) -> Fit:
        """A residual, shape (N, n), by columns of the same shape."""
        X = np.stack([self.weighted(column) for column in columns], axis=1)
        return fit(X, self.weighted(residual), self.blocks)

    def fitted_parameters(self, change: Array, directions: Array) -> Fit:
        """The residual by directions of the inertial parameters, after a known change of them.

        change : shape (10 n,);  directions : shape (10 n, k)
        """
        return fit(self.Y @ directions, self.residual - self.Y @ change, self.blocks)

    def evidence(self, rest: float, coefficients: int, alternatives: int) -> float:
        """Of a cause that leaves a sum of squares."""
        count = max(2.0, self.normal.independent * len(self.residual))
        chance = coefficients * np.log(count) + 2.0 * np.log(max(1, alternatives))
        return float(self.normal.independent * (self.normal.base - rest) - chance)

    def cause(
        self,
        cause_id: CauseId,
        joint: int,
        labels: tuple[tuple[str, str], ...],
        residual: Array,
        value: Array,
        half_width: Array,
        *,
        alternatives: int,
        coefficients: int | None = None,
        mistake: str = "",
        how: str = "",
    ) -> Cause:
        """A cause with its rating; `residual` is weighted, shape (N n,)."""
        rest = float(residual @ residual)
        fitted = len(value) if coefficients is None else coefficients
        return Cause(
            cause_id,
            joint,
            tuple(name for name, _ in labels),
            tuple(unit for _, unit in labels),
            value,
            half_width,
            self.evidence(rest, fitted, alternatives),
            (self.normal.base - rest) / max(self.normal.base - self.normal.floor, 1e-300),
            residual.reshape(-1, self.n).std(axis=0) * self.sizes,
            mistake,
            how,
        )


def _basis(columns: Array) -> Array:
    U, s, _ = np.linalg.svd(columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300),
                            full_matrices=False)  # fmt: skip
    return np.asarray(U[:, s > 1e-9 * s[0]])


def _excited(G: Array) -> tuple[Array, int]:
    """Directions b of the parameters with bᵀ G b = 1, that are excited."""
    scale = np.sqrt(np.maximum(np.diag(G), 1e-300))
    values, vectors = np.linalg.eigh(G / np.outer(scale, scale))
    kept = values > UNEXCITED**2 * values[-1]
    return vectors[:, kept] / np.sqrt(values[kept]) / scale[:, None], int(kept.sum())


def _independent(U: Array, rest: Array, blocks: NDArray[np.int64]) -> float:
    """Independent rows over rows.

    U : orthonormal columns;  rest : of the fit by them.  Of independent errors the sums U·rest over
    blocks scatter as much as single rows do; of errors that are alike in time, more.
    """
    scores = np.zeros((int(blocks.max()) + 1, U.shape[1]))
    np.add.at(scores, blocks, U * rest[:, None])
    scatter = float((scores**2).sum(axis=0).mean())
    return min(1.0, float((rest**2).mean()) / max(scatter, 1e-300))
