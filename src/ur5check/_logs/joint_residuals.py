"""Joint by joint: how well a model explains the measured torque, before and after its drive.

Three stages, each with less left: the model alone; with friction as a function of the filtered
velocity, the usual fit; with rotor inertia, and friction that passed the torque's low-pass (see
`signals`).  The floor is what the best inertial parameters of this geometry would leave: all base
parameters free (Gautier & Khalil, IEEE T-RA 6(3), 1990), and friction and rotor inertia too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._dynamics.recursion import rnea
from .._dynamics.regressor import torque_regressor
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .friction import FrictionModel
from .least_squares import UNEXCITED, Fit, blocks_of, fit
from .signals import Signals

__all__ = ["Floor", "JointResidual", "floor_of", "joint_residuals", "model_torque"]

#: Samples used for a fit, at most; more add nothing but time, since signals are band-limited.
_MOST_SAMPLES = 10_000


@dataclass(frozen=True, eq=False)
class JointResidual:
    """One joint.  All sizes are standard deviations over the recording [N m or N].

    measured, model : of the two torques
    alone : of measured − model
    with_friction, with_rotor : of what remains after friction, and after rotor inertia too
    floor : of what the best inertial parameters leave
    friction : the usual fit of friction, in the order of `FrictionModel.usual_names`
    drive : the fit of friction and rotor inertia, in the order of `FrictionModel.names`.  A
        negative rotor inertia is none: the model's own inertia about this axis is too large
    scale, scale_half_width : of the model's torque, that fits best; nan where the model's torque
        does not stand out
    """

    name: str
    measured: float
    model: float
    alone: float
    with_friction: float
    with_rotor: float
    floor: float
    friction: Fit
    drive: Fit
    scale: float
    scale_half_width: float

    @property
    def stands_out(self) -> bool:
        """Whether the model's torque is larger than what remains, so that it can be judged."""
        return self.model > self.with_rotor

    @property
    def above_floor(self) -> float:
        """What remains with the given model, over what the best one leaves."""
        return self.with_rotor / self.floor if self.floor > 0.0 else 1.0

    @property
    def excess(self) -> float:
        """The part of what remains that better parameters would explain [N m]."""
        return float(np.sqrt(max(0.0, self.with_rotor**2 - self.floor**2)))


@dataclass(frozen=True, eq=False)
class Floor:
    """The best fit of this geometry.

    sizes : standard deviation of each joint's residual, shape (n,)
    parameters : 10 n inertial parameters that reach it (not unique), shape (10 n,)
    drives : each joint's friction and rotor inertia that belong to them, shape (n, k)
    rank : directions of parameters and drives that this recording excites
    """

    sizes: Array
    parameters: Array
    drives: Array
    rank: int


def thinned(signals: Signals) -> slice:
    """Every k-th sample, so that a fit has at most `_MOST_SAMPLES`."""
    return slice(None, None, max(1, -(-signals.count // _MOST_SAMPLES)))


def model_torque(arm: SerialArm, signals: Signals) -> Array:
    """The model's torque at the signals, without motor inertia, shape (N, n)."""
    bare = arm.with_armature(np.zeros(arm.n))
    return np.asarray(rnea(bare, signals.q, signals.qd, signals.qdd))


def floor_of(arm: SerialArm, signals: Signals) -> Floor:
    """All inertial parameters and all drives fitted at once, joints weighted by their residuals."""
    part = thinned(signals)
    q, qd, qdd, tau = (x[part] for x in (signals.q, signals.qd, signals.qdd, signals.tau))
    drive = signals.drive[part]
    count, n = q.shape
    Y = torque_regressor(arm, q, qd, qdd)
    k = drive.shape[2]
    X = np.zeros((count, n, 10 * n + k * n))
    X[:, :, : 10 * n] = Y
    for j in range(n):
        X[:, j, 10 * n + k * j : 10 * n + k * (j + 1)] = drive[:, j]
    sizes = np.maximum(tau.std(axis=0), 1e-9)
    for _ in range(2):  # the weights need a first fit
        value, rank = _solved(X / sizes[:, None], tau / sizes)
        residual = tau - X @ value
        sizes = np.maximum(residual.std(axis=0), 1e-9 * np.maximum(tau.std(axis=0), 1e-9))
    return Floor(sizes, value[: 10 * n], value[10 * n :].reshape(n, k), rank)


def _solved(X: Array, y: Array) -> tuple[Array, int]:
    """The shortest least-squares solution, columns scaled to one length, and the rank.

    By XᵀX, ten times as fast as by singular values; its rounding hides directions below 1e-6.
    """
    X, y = X.reshape(-1, X.shape[-1]), y.reshape(-1)
    scale = np.linalg.norm(X, axis=0)
    scale[scale == 0.0] = 1.0
    values, vectors = np.linalg.eigh((X.T @ X) / np.outer(scale, scale))
    kept = values > UNEXCITED**2 * values[-1]
    V = vectors[:, kept]
    return V @ ((V.T @ (X.T @ y / scale)) / values[kept]) / scale, int(kept.sum())


def joint_residuals(
    arm: SerialArm, signals: Signals, model: Array, friction: FrictionModel, floor: Floor
) -> tuple[JointResidual, ...]:
    """Each joint's stages; `model` is the model's torque, shape (N, n)."""
    part = thinned(signals)
    blocks = blocks_of(signals.t[part], signals.segment[part], signals.cutoff)
    names = arm.joint_names
    rows = []
    for j in range(arm.n):
        D, y, m = signals.drive[part, j], signals.tau[part, j], model[part, j]
        columns = friction.columns(signals.qd[part, j], signals.qdd[part, j])
        usual = columns[:, : len(friction.usual_names)]
        with_friction = fit(usual, y - m, blocks)
        drive = fit(D, y - m, blocks)
        size = float(drive.residual.std())
        scale = scale_half_width = float("nan")
        if float(m.std()) > size:
            scaled = fit(np.column_stack([D, m]), y, blocks)
            scale, scale_half_width = float(scaled.value[-1]), float(scaled.half_width[-1])
        rows.append(
            JointResidual(
                names[j],
                float(y.std()),
                float(m.std()),
                float((y - m).std()),
                float(with_friction.residual.std()),
                size,
                min(float(floor.sizes[j]), size),
                with_friction,
                drive,
                scale,
                scale_half_width,
            )
        )
    return tuple(rows)
