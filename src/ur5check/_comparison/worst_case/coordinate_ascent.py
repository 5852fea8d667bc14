"""Ascent to states of large torque difference, each coordinate to its exact maximum in turn.

With Δτ = τ_a − τ_b = Δh(q, q̇) + ΔM(q) q̈, the objective is |w ∘ Δτ|, with a single weight other than
zero for a single joint.  The accelerations need no search: in a direction u of torques and with
|q̈_k| ≤ A_k, the largest u · Δτ at these q and q̇ is

    F = |u · Δh| + Σ_k A_k |(ΔM u)_k|        (ΔM is symmetric)

and two evaluations give it.  Along one coordinate, all others held, both parts are known from a few
samples:

    angle q_k         trigonometric polynomials of degree 2: the pseudo-inertia of the links beyond
                      joint k moves as T J Tᵀ, and Δτ is linear in it       5 samples
    displacement q_k  polynomials of degree 2, for the same reason          3 samples
    velocity q̇_k      u · Δh = u · Δg + Σ_kl V_kl q̇_k q̇_l, from 1 + n (n + 1) / 2 samples for all k

A step along a coordinate reaches its largest value wherever in the range that is, past local maxima
between.  For one joint, u is its unit vector.  For several, u = w² ∘ Δτ / |w ∘ Δτ|, renewed at each
sweep: |w ∘ Δτ| is convex in Δτ and lies above its tangent u · Δτ, so that what raises F raises it.
All starts are moved at the same time, as one array of states.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..._dynamics.equations import gravity_torque
from ..._dynamics.recursion import rnea
from ..._robot.states import States
from ..._robot.transforms import Array
from ..arm_pair import Pair
from .state_box import StateBox

__all__ = ["TorqueGap", "ascend"]

Bools = NDArray[np.bool_]

#: An ascent ends at the sweep that gains less than this part of F.
_LEAST_GAIN = 1e-7
_MOST_SWEEPS = 25
#: After the first sweep one ascent in so many goes on, after the second one in so many, but never
#: fewer than the last number: by then the highest are those that will end highest.
_ONE_IN = (2, 16)
_LEAST_KEPT = 8
#: Steps tried along the last sweep's whole move: along a ridge, sweeps take ever the same step.
_LEAPS = np.array([0.0, 1.0, 3.0, 9.0, 27.0])
#: Where F is tried along a coordinate, and then around the best of these.
_GRID = np.linspace(-1.0, 1.0, 49)
_FINER = np.linspace(-1.0, 1.0, 9)
_REFINEMENTS = 6  # each narrows the interval to a quarter
_ROUNDS = 3  # over the velocities, which take no evaluations


@dataclass(frozen=True, eq=False)
class TorqueGap:
    """Δτ = τ_a − τ_b, shape (..., n), of a pair; at rest Δg(q) alone."""

    pair: Pair
    static: bool

    def __call__(self, q: Array, qd: Array, qdd: Array) -> Array:
        a, b = self.pair.a, self.pair.b
        if self.static:
            return np.asarray(gravity_torque(a, q) - gravity_torque(b, q))
        return np.asarray(rnea(a, q, qd, qdd) - rnea(b, q, qd, qdd))

    def with_best_accelerations(self, q: Array, qd: Array, bound: Array) -> tuple[Array, Array]:
        """The largest |Δτ_j| at each of N states over |q̈| ≤ `bound`, shape (N, n), and the
        accelerations there, shape (N, n, n), by j; at rest there are none.
        """
        if self.static:
            return np.abs(self(q, qd, qd)), np.zeros((*q.shape, q.shape[1]))
        pushes = np.vstack([np.zeros(len(bound)), np.diag(bound)])
        delta = self(q[:, None, :], qd[:, None, :], pushes)
        bias, pushed = delta[:, 0], delta[:, 1:] - delta[:, :1]  # pushed: (N, k, j)
        sign = np.where(bias < 0.0, -1.0, 1.0)[:, :, None] * np.where(pushed < 0.0, -1.0, 1.0).mT
        return np.abs(bias) + np.abs(pushed).sum(axis=1), sign * bound


def ascend(
    gap: TorqueGap, box: StateBox, starts: States, weights: Array, *, results: int | None = None
) -> States:
    """The states reached from `starts`, one for each of them.

    weights : w, shape (N, n), a row for each start
    results : how many the starts are for, equally many for each, one result's after the other's;
        of each result's ascents most are given up where two sweeps have led them.  None: none is.
    """
    q, qd, qdd = starts.q.copy(), starts.qd.copy(), starts.qdd.copy()
    delta = weights * gap(q, qd, qdd)
    height = np.linalg.norm(delta, axis=1)
    rising = np.flatnonzero(height > 0.0)
    for sweep in range(_MOST_SWEEPS):
        if not len(rising):
            break
        direction = weights[rising] * delta[rising] / height[rising, None]
        ascent = _Ascent(gap, box, q[rising], qd[rising], direction)
        ascent.sweep()
        q[rising], qd[rising], qdd[rising] = ascent.q, ascent.qd, ascent.best_accelerations()
        delta[rising] = weights[rising] * gap(q[rising], qd[rising], qdd[rising])
        top = np.linalg.norm(delta[rising], axis=1)
        rose = top > height[rising] * (1.0 + _LEAST_GAIN)
        height[rising] = top
        rising = rising[rose]
        if results is not None and sweep < len(_ONE_IN):
            rising = rising[_ahead(height.reshape(results, -1), _ONE_IN[sweep])[rising]]
    return States(q, qd, qdd)


def _ahead(height: Array, one_in: int) -> Bools:
    """Which ascents are among the highest of their result, flat.  height : (results, starts)"""
    rank = (-height).argsort(axis=1, kind="stable").argsort(axis=1)
    return np.asarray(rank < max(height.shape[1] // one_in, _LEAST_KEPT)).ravel()


class _Ascent:
    """One sweep over the coordinates of N states; u : shape (N, n)."""

    def __init__(self, gap: TorqueGap, box: StateBox, q: Array, qd: Array, u: Array) -> None:
        self.gap, self.box, self.q, self.qd, self.u = gap, box, q.copy(), qd.copy(), u

    def sweep(self) -> None:
        """Every coordinate once, then a leap along the whole move."""
        q, qd = self.q.copy(), self.qd.copy()
        for k, joint in enumerate(self.gap.pair.a.joints):
            self._move_position(k, revolute=joint.kind == "revolute")
        if not self.gap.static:
            self._move_velocities()
        self._leap(q, qd)

    def best_accelerations(self) -> Array:
        """At a corner of the box, shape (N, n); at rest 0."""
        parts = self._parts(self.q, self.qd)
        sign = np.where(parts[:, :1] < 0.0, -1.0, 1.0) * np.where(parts[:, 1:] < 0.0, -1.0, 1.0)
        return np.asarray(sign * self.box.acceleration) if sign.size else np.zeros_like(self.q)

    def _parts(self, q: Array, qd: Array) -> Array:
        """u · Δh and A_k (ΔM u)_k at states of shape (N, ..., n): shape (N, ..., 1 + n).

        At rest the first of them alone: F is the sum of their sizes in either case.
        """
        u = np.broadcast_to(self.u.reshape(len(q), *[1] * (q.ndim - 2), -1), q.shape)
        if self.gap.static:
            return np.asarray((u * self.gap(q, qd, qd)).sum(axis=-1, keepdims=True))
        # In units of the accelerations, so that the difference of the two does not cancel.
        scale = self.box.acceleration.max() / np.abs(u).max(axis=-1, keepdims=True)
        bias, pushed = self.gap(q, qd, np.stack([np.zeros_like(u), scale * u]))
        along = (u * bias).sum(axis=-1, keepdims=True)
        return np.concatenate([along, (pushed - bias) * (self.box.acceleration / scale)], axis=-1)

    def _move_position(self, k: int, *, revolute: bool) -> None:
        line = (_Angle if revolute else _Segment)(self.box.lower[k], self.box.upper[k])
        q = np.repeat(self.q[:, None, :], len(line.samples), axis=1)
        q[:, :, k] = line.samples
        parts = self._parts(q, np.broadcast_to(self.qd[:, None, :], q.shape))
        self.q[:, k] = line.highest(np.matmul(line.fit, parts), self.q[:, k])

    def _move_velocities(self) -> None:
        """Each velocity to the largest |u · Δh|, the others held."""
        count, n = self.q.shape
        pairs = [(k, m) for k in range(n) for m in range(k)]
        unit = np.eye(n)
        rates = np.vstack([np.zeros(n), unit, *(unit[k] + unit[m] for k, m in pairs)])
        shape = (count, len(rates), n)
        q, qd = np.broadcast_to(self.q[:, None, :], shape), np.broadcast_to(rates, shape)
        along = (self.u[:, None, :] * self.gap(q, qd * self.box.rate, np.zeros(n))).sum(axis=-1)
        along[:, 1:] -= along[:, :1]
        V = np.zeros((count, n, n))
        V[:, range(n), range(n)] = along[:, 1 : 1 + n]
        for row, (k, m) in enumerate(pairs, 1 + n):
            V[:, k, m] = V[:, m, k] = (along[:, row] - V[:, k, k] - V[:, m, m]) / 2.0
        line = _Segment(-1.0, 1.0)
        v = self.qd / self.box.rate
        for k in list(range(n)) * _ROUNDS:
            slope = 2.0 * ((V[:, k] * v).sum(axis=1) - V[:, k, k] * v[:, k])
            here = along[:, 0] + np.einsum("ik,ikl,il->i", v, V, v)
            rest = here - v[:, k] * (slope + v[:, k] * V[:, k, k])
            coefficients = np.stack([rest, slope, V[:, k, k]], axis=1)[:, :, None]
            v[:, k] = line.highest(coefficients, v[:, k])
        self.qd = v * self.box.rate

    def _leap(self, q: Array, qd: Array) -> None:
        """To the highest state along the line from (q, qd) through the present one."""
        steps, box = _LEAPS[:, None], self.box
        tried_q = self.q[:, None] + steps * (self.q - q)[:, None]
        tried_qd = self.qd[:, None] + steps * (self.qd - qd)[:, None]
        tried_q = np.clip(tried_q, box.lower, box.upper)
        tried_qd = np.clip(tried_qd, -box.rate, box.rate)
        best = np.abs(self._parts(tried_q, tried_qd)).sum(axis=-1).argmax(axis=1)
        each = np.arange(len(best))
        self.q, self.qd = tried_q[each, best], tried_qd[each, best]


class _Line(ABC):
    """The range of one coordinate x, and the parts of F along it: Σ_p basis_p(x) c_p."""

    def __init__(self, lower: float, upper: float, samples: Array) -> None:
        self.middle, self.half = (lower + upper) / 2.0, (upper - lower) / 2.0
        self.samples = samples
        self.fit = np.linalg.inv(self.basis(samples))
        self.grid = self.middle + self.half * _GRID
        self.on_grid = self.basis(self.grid)

    @abstractmethod
    def basis(self, x: Array) -> Array:
        """Of degree 2, shape (..., p)."""

    def highest(self, coefficients: Array, present: Array) -> Array:
        """Where F is largest, shape (N,); the present x where no other is higher.

        coefficients : c, shape (N, p, parts)
        """
        each = np.arange(len(coefficients))
        heights = np.abs(np.matmul(self.on_grid, coefficients)).sum(axis=-1)
        x = self.grid[heights.argmax(axis=1)]
        step = self.half * (_GRID[1] - _GRID[0])
        for _ in range(_REFINEMENTS):
            around = np.clip(
                x[:, None] + step * _FINER, self.middle - self.half, self.middle + self.half
            )
            heights = np.abs(np.matmul(self.basis(around), coefficients)).sum(axis=-1)
            best = heights.argmax(axis=1)
            x, top = around[each, best], heights[each, best]
            step /= 4.0
        now = np.abs(np.matmul(self.basis(present[:, None]), coefficients)).sum(axis=(-2, -1))
        return np.asarray(np.where(top > now, x, present))


class _Angle(_Line):
    """An angle; of a range of more than a turn, the turn in its middle."""

    def __init__(self, lower: float, upper: float) -> None:
        spare = max(upper - lower - 2.0 * np.pi, 0.0) / 2.0
        samples = np.linspace(0.0, 2.0 * np.pi, 5, endpoint=False)
        super().__init__(lower + spare, upper - spare, samples)

    def basis(self, x: Array) -> Array:
        angles = x[..., None] * np.array([1.0, 2.0])
        return np.concatenate([np.ones_like(x)[..., None], np.cos(angles), np.sin(angles)], axis=-1)


class _Segment(_Line):
    """A displacement, or a velocity as a part of its bound."""

    def __init__(self, lower: float, upper: float) -> None:
        middle, half = (lower + upper) / 2.0, (upper - lower) / 2.0 or 1.0
        super().__init__(lower, upper, np.array([middle - half, middle, middle + half]))

    def basis(self, x: Array) -> Array:
        return np.asarray(x[..., None] ** np.arange(3))
