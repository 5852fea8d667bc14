"""Causes outside the links: gains, a payload, gravity, a joint's zero or sign."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from .._dynamics.recursion import rnea
from .._robot.transforms import Array
from .cause import Cause
from .least_squares import Fit
from .point_mass import point_mass
from .weighted_problem import WeightedProblem

__all__ = ["arm_causes"]

_STEP = 1e-20  # of a complex derivative: any size that underflows in the square
_ROUNDS = 5  # of linearisation; each gains the digits of a Newton step


def arm_causes(problem: WeightedProblem, judged: Iterable[int]) -> Iterator[Cause]:
    """Each cause, alone.

    judged : joints (from 0) whose model torque stands out.  A gain of another would be a ratio to
        next to nothing.
    """
    judged = tuple(judged)
    yield _gain_of_all(problem)
    yield _payload(problem)
    yield _gravity(problem)
    for j in judged:
        yield _gain_of_joint(problem, j)
    coarse = problem.coarse()
    for j in range(problem.n):
        yield _zero(problem, coarse, j)
        yield _sign(problem, j)


def _gain_of_all(problem: WeightedProblem) -> Cause:
    found = problem.fitted(problem.signals.tau - problem.model, [problem.model])
    return problem.cause(
        "gain-of-all", 0, (("gain", ""),), found.residual, 1.0 + found.value, found.half_width,
        alternatives=1,
    )  # fmt: skip


def _gain_of_joint(problem: WeightedProblem, j: int) -> Cause:
    column = np.zeros_like(problem.model)
    column[:, j] = problem.model[:, j]
    found = problem.fitted(problem.signals.tau - problem.model, [column])
    return problem.cause(
        "gain-of-joint", j + 1, (("gain", ""),), found.residual, 1.0 + found.value,
        found.half_width, alternatives=problem.n,
    )  # fmt: skip


def _payload(problem: WeightedProblem) -> Cause:
    load = point_mass(problem.Y[:, -10:], problem.residual, problem.blocks)
    labels = (("mass", "kg"), ("centre x", "m"), ("centre y", "m"), ("centre z", "m"))
    return problem.cause(
        "payload", 0, labels, load.residual, load.value, load.half_width, alternatives=1
    )


def _gravity(problem: WeightedProblem) -> Cause:
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
    found = problem.fitted(s.tau - problem.model, columns)
    change = sum(value * d for value, d in zip(found.value, across, strict=True))
    tilt = np.degrees(np.arctan2(np.linalg.norm(change), size))
    labels = (("gravity x", "m/s²"), ("gravity y", "m/s²"), ("gravity z", "m/s²"), ("tilt", "°"))
    spread = np.sqrt(sum((w * d) ** 2 for w, d in zip(found.half_width, across, strict=True)))
    width = np.degrees(np.linalg.norm(found.half_width) / max(size, 1e-9))
    return problem.cause(
        "gravity-direction", 0, labels, found.residual, np.array([*(g + change), tilt]),
        np.array([*spread, width]), alternatives=1, coefficients=2,
    )  # fmt: skip


def _zero(problem: WeightedProblem, coarse: WeightedProblem, j: int) -> Cause:
    """The joint counts from another zero: small by iteration, quarter turns by trial."""
    kind = problem.arm.joints[j].kind
    starts = (0.0,) if kind == "prismatic" else (0.0, np.pi / 2, np.pi, -np.pi / 2)
    found = [_nearest_zero(coarse, j, start, _ROUNDS) for start in starts]
    shift, _ = min(found, key=lambda zero: float((zero[1].residual ** 2).sum()))
    shift, fitted = _nearest_zero(problem, j, shift, 2)
    return problem.cause(
        "joint-zero", j + 1, (("zero", "m" if kind == "prismatic" else "rad"),), fitted.residual,
        np.array([shift]), fitted.half_width, alternatives=4 * problem.n,
    )  # fmt: skip


def _nearest_zero(problem: WeightedProblem, j: int, shift: float, rounds: int) -> tuple[float, Fit]:
    """By Newton's steps from a start, as long as they are short."""
    for _ in range(rounds):
        torque, slope = _shifted(problem, j, shift)
        found = problem.fitted(problem.signals.tau - torque, [slope])
        step = float(found.value[0])
        if not np.isfinite(step) or abs(step) > 0.5:
            break
        shift += step
    return shift, found


def _shifted(problem: WeightedProblem, j: int, shift: float) -> tuple[Array, Array]:
    """The model's torque with joint j's zero moved, and its derivative."""
    s = problem.signals
    bare = problem.arm.with_armature(np.zeros(problem.n))
    q = s.q.astype(complex)
    q[:, j] += shift + 1j * _STEP
    torque = rnea(bare, q, s.qd, s.qdd)
    return torque.real, torque.imag / _STEP


def _sign(problem: WeightedProblem, j: int) -> Cause:
    """The joint's positive direction is the other one in the recording."""
    s = problem.signals
    sign = np.ones(problem.n)
    sign[j] = -1.0
    bare = problem.arm.with_armature(np.zeros(problem.n))
    torque = np.asarray(rnea(bare, s.q * sign, s.qd * sign, s.qdd * sign)) * sign
    return problem.cause(
        "joint-sign", j + 1, (("sign", ""),), problem.weighted(s.tau - torque), np.array([-1.0]),
        np.zeros(1), alternatives=problem.n, coefficients=0,
    )  # fmt: skip
