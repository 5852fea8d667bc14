"""Single causes of a residual, each tested alone: gains, a payload, gravity, a zero, a sign.

A cause predicts a pattern of torque over all joints.  Friction and rotor inertia are allowed for
at the same time, joints are weighted by the floor, and a cause is rated by how much it lowers the
sum of squares, less what its coefficients and the number of alternatives would lower by chance
(Bayes' information criterion, Schwarz, Annals of Statistics 6(2), 1978).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from .._dynamics.recursion import rnea
from .._dynamics.regressor import torque_regressor
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .friction import FrictionModel
from .joint_residuals import Floor, drive_columns, model_torque, thinned
from .least_squares import Fit, blocks_of, fit
from .signals import Signals

__all__ = ["Cause", "CauseId", "causes_of"]

CauseId = Literal[
    "gain-of-all", "gain-of-joint", "payload", "gravity-direction", "joint-zero", "joint-sign"
]

_STEP = 1e-20  # of a complex derivative: any size that underflows in the square
_ROUNDS = 5  # of linearisation; each gains the digits of a Newton step


@dataclass(frozen=True, eq=False)
class Cause:
    """One cause, with the values that explain the recording best.

    id : its name;  joint : from 1, 0 where it concerns the whole arm
    names, units : of the values
    value, half_width : 95 % interval value ± half_width, shape (k,)
    evidence : by how much the weighted sum of squares falls, over what chance would take; above 0
        the cause is likelier than none
    sizes : of each joint's residual with this cause [N m], shape (n,)
    """

    id: CauseId
    joint: int
    names: tuple[str, ...]
    units: tuple[str, ...]
    value: Array
    half_width: Array
    evidence: float
    sizes: Array


def causes_of(
    arm: SerialArm, signals: Signals, friction: FrictionModel, floor: Floor
) -> tuple[Cause, ...]:
    """All causes, the likeliest first."""
    problem = _Problem.of(arm, signals, friction, floor)
    found = [
        _gain_of_all(problem),
        *(_gain_of_joint(problem, j) for j in range(problem.n)),
        _payload(problem),
        _gravity(problem),
        *(_zero(problem, j) for j in range(problem.n)),
        *(_sign(problem, j) for j in range(problem.n)),
    ]
    return tuple(sorted(found, key=lambda cause: -cause.evidence))


@dataclass(frozen=True, eq=False)
class _Problem:
    """Residuals with friction and rotor inertia taken out of them and of every column.

    tau, model : shape (N, n);  Q : for each joint an orthonormal basis of its drive's columns
    sizes : weights, shape (n,);  independent : independent samples over samples
    base : weighted sum of squares without any cause
    """

    arm: SerialArm
    signals: Signals
    tau: Array
    model: Array
    Q: tuple[Array, ...]
    sizes: Array
    blocks: NDArray[np.int64]
    independent: float
    base: float

    @classmethod
    def of(
        cls, arm: SerialArm, signals: Signals, friction: FrictionModel, floor: Floor
    ) -> _Problem:
        part = thinned(signals)
        share = signals.independent / signals.count
        signals = replace(
            signals,
            **{
                name: getattr(signals, name)[part]
                for name in ("t", "q", "qd", "qdd", "tau", "segment")
            },
            model_tau=None,
        )
        Q = tuple(_basis(columns) for columns in drive_columns(signals, friction))
        problem = cls(
            arm, signals, signals.tau, model_torque(arm, signals), Q, floor.sizes,
            np.repeat(blocks_of(signals.t, signals.segment, signals.cutoff), arm.n),
            min(1.0, share * (part.step or 1)), 0.0,
        )  # fmt: skip
        return replace(
            problem, base=float((problem.weighted(problem.tau - problem.model) ** 2).sum())
        )

    @property
    def n(self) -> int:
        return self.arm.n

    def weighted(self, torque: Array) -> Array:
        """Torques less what drives explain, over the floor, shape (N n,)."""
        free = np.stack(
            [torque[:, j] - Q @ (Q.T @ torque[:, j]) for j, Q in enumerate(self.Q)], axis=1
        )
        return np.asarray((free / self.sizes).reshape(-1))

    def fitted(self, residual: Array, columns: list[Array]) -> Fit:
        """A residual, shape (N, n), by columns of the same shape."""
        X = np.stack([self.weighted(column) for column in columns], axis=1)
        return fit(X, self.weighted(residual), self.blocks)

    def cause(
        self,
        cause_id: CauseId,
        joint: int,
        labels: tuple[tuple[str, str], ...],
        found: Fit,
        value: Array,
        *,
        alternatives: int,
        coefficients: int | None = None,
        half_width: Array | None = None,
    ) -> Cause:
        lowered = self.base - float((found.residual**2).sum())
        count = max(2.0, self.independent * len(found.residual))
        fitted = len(value) if coefficients is None else coefficients
        chance = fitted * np.log(count) + 2.0 * np.log(alternatives)
        return Cause(
            cause_id,
            joint,
            tuple(name for name, _ in labels),
            tuple(unit for _, unit in labels),
            value,
            found.half_width[: len(value)] if half_width is None else half_width,
            self.independent * lowered - float(chance),
            found.residual.reshape(-1, self.n).std(axis=0) * self.sizes,
        )


def _basis(columns: Array) -> Array:
    U, s, _ = np.linalg.svd(columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300),
                            full_matrices=False)  # fmt: skip
    return np.asarray(U[:, s > 1e-9 * s[0]])


def _gain_of_all(problem: _Problem) -> Cause:
    found = problem.fitted(problem.tau - problem.model, [problem.model])
    return problem.cause(
        "gain-of-all", 0, (("gain", ""),), found, 1.0 + found.value, alternatives=1
    )


def _gain_of_joint(problem: _Problem, j: int) -> Cause:
    found = problem.fitted(problem.tau - problem.model, [_only(problem.model, j)])
    return problem.cause(
        "gain-of-joint", j + 1, (("gain", ""),), found, 1.0 + found.value, alternatives=problem.n
    )


def _payload(problem: _Problem) -> Cause:
    """A point mass at the tool, in the tip frame: its tensor m (c·c 1 − c cᵀ) by iteration."""
    s = problem.signals
    Y = torque_regressor(problem.arm, s.q, s.qd, s.qdd)[:, :, -10:]
    residual = problem.tau - problem.model
    tensor = np.zeros(6)
    for _ in range(_ROUNDS):
        found = problem.fitted(residual - Y[:, :, 4:] @ tensor, [Y[:, :, k] for k in range(4)])
        mass, moment = found.value[0], found.value[1:]
        if abs(mass) < 1e-9:
            break
        c = moment / mass
        full = mass * (c @ c * np.eye(3) - np.outer(c, c))
        tensor = np.array([full[0, 0], full[0, 1], full[1, 1], full[0, 2], full[1, 2], full[2, 2]])
    c = found.value[1:] / mass if abs(mass) > 1e-9 else np.zeros(3)
    # c = (m c) / m: its variance by the derivative of the quotient.
    J = np.column_stack([-c, np.eye(3)]) / mass if abs(mass) > 1e-9 else np.zeros((3, 4))
    ratio = found.half_width[0] / np.sqrt(found.covariance[0, 0]) if found.covariance[0, 0] else 0.0
    spread = ratio * np.sqrt(np.diag(J @ found.covariance @ J.T))
    labels = (("mass", "kg"), ("centre x", "m"), ("centre y", "m"), ("centre z", "m"))
    return problem.cause(
        "payload", 0, labels, found, np.array([mass, *c]), alternatives=1,
        half_width=np.array([found.half_width[0], *spread]),
    )  # fmt: skip


def _gravity(problem: _Problem) -> Cause:
    """Gravity tilted: two directions across it, in the base frame."""
    s, g = problem.signals, problem.arm.gravity
    size = float(np.linalg.norm(g))
    if size == 0.0:
        across = [np.eye(3)[0], np.eye(3)[1]]
    else:
        first = np.cross(g, np.eye(3)[int(np.abs(g).argmin())])
        first /= np.linalg.norm(first)
        across = [first, np.cross(g / size, first)]
    zero = np.zeros_like(s.q)
    columns = [np.asarray(rnea(problem.arm, s.q, zero, zero, gravity=d)) for d in across]
    found = problem.fitted(problem.tau - problem.model, columns)
    change = sum(value * d for value, d in zip(found.value, across, strict=True))
    tilt = np.degrees(np.arctan2(np.linalg.norm(change), size))
    labels = (("gravity x", "m/s²"), ("gravity y", "m/s²"), ("gravity z", "m/s²"), ("tilt", "°"))
    spread = np.sqrt(sum((w * d) ** 2 for w, d in zip(found.half_width, across, strict=True)))
    width = np.degrees(np.linalg.norm(found.half_width) / max(size, 1e-9))
    return problem.cause(
        "gravity-direction", 0, labels, found, np.array([*(g + change), tilt]), alternatives=1,
        coefficients=2, half_width=np.array([*spread, width]),
    )  # fmt: skip


def _zero(problem: _Problem, j: int) -> Cause:
    """The joint counts from another zero: small by iteration, quarter turns by trial."""
    best: tuple[float, Fit, float] | None = None
    kind = problem.arm.joints[j].kind
    for start in (0.0,) if kind == "prismatic" else (0.0, np.pi / 2, np.pi, -np.pi / 2):
        shift = start
        for _ in range(_ROUNDS):
            torque, slope = _shifted(problem, j, shift)
            found = problem.fitted(problem.tau - torque, [slope])
            step = float(found.value[0])
            if not np.isfinite(step) or abs(step) > 0.5:
                break
            shift += step
        rest = float((found.residual**2).sum())
        if best is None or rest < best[0]:
            best = rest, found, shift
    assert best is not None  # noqa: S101 - there is a start
    _, found, shift = best
    return problem.cause(
        "joint-zero", j + 1, (("zero", "m" if kind == "prismatic" else "rad"),), found,
        np.array([shift]), alternatives=4 * problem.n,
    )  # fmt: skip


def _shifted(problem: _Problem, j: int, shift: float) -> tuple[Array, Array]:
    """The model's torque with joint j's zero moved, and its derivative."""
    s = problem.signals
    bare = problem.arm.with_armature(np.zeros(problem.n))
    q = s.q.astype(complex)
    q[:, j] += shift + 1j * _STEP
    torque = rnea(bare, q, s.qd, s.qdd)
    return torque.real, torque.imag / _STEP


def _sign(problem: _Problem, j: int) -> Cause:
    """The joint's positive direction is the other one in the recording."""
    s = problem.signals
    sign = np.ones(problem.n)
    sign[j] = -1.0
    bare = problem.arm.with_armature(np.zeros(problem.n))
    torque = np.asarray(rnea(bare, s.q * sign, s.qd * sign, s.qdd * sign)) * sign
    found = problem.fitted(problem.tau - torque, [np.zeros_like(torque)])
    return problem.cause(
        "joint-sign", j + 1, (("sign", ""),), found, np.array([-1.0]), alternatives=problem.n,
        coefficients=1, half_width=np.zeros(1),
    )  # fmt: skip


def _only(torque: Array, j: int) -> Array:
    column = np.zeros_like(torque)
    column[:, j] = torque[:, j]
    return column
