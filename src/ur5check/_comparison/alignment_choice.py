"""The choice among alignments that all make the axes coincide: the smallest torque difference.

Geometry cannot choose: a spherical wrist carries the same axes with joints 4 and 6 half a turn
further and joint 5 reversed, but then the bodies of links 4 and 5 lie elsewhere.  With equal axes
Δτ = Y (π_a − π_b), where only b's parameters in a's link frames depend on the alignment; the
regressor is computed once.

The same difference determines a zero that no axis shows, the last joint's above all: Δτ is a
trigonometric polynomial of degree two in it (of degree two in a slide), and its least square is
found exactly.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from .._dynamics.recursion import rnea
from .._dynamics.regressor import torque_regressor
from .._robot.inertia import parameters_from_pseudo_inertia, pseudo_inertia
from .._robot.serial_arm import SerialArm
from .._robot.states import random_states
from .._robot.transforms import Array, Transform
from .alignment_paths import Undetermined
from .joint_axes import (
    SAME_ANGLE,
    across,
    angle_about,
    joint_starts,
    signed_angle,
    smallest_rotation,
)

__all__ = ["AxisFit", "OpenZero", "TorqueDifference", "gravity_kept"]

#: Torque differences are compared at 20 random states, each with five angles of the last joint a
#: fifth of a turn apart.  Over those, any product of two torques averages as over a whole turn, so
#: that an error in another number does not move the zero of the last joint.
_STATES, _FIFTHS, _SEED = 20, 5, 0

#: Relative torque differences below this are rounding.
_NOTHING = 1e-9

#: Of many ways to put two arms' bodies side by side, one always fits a little better: by chance,
#: where the numbers differ all over.  One that changes more must leave less than half.
FAR_BETTER = 0.5


@dataclass(frozen=True, eq=False)
class OpenZero:
    """A zero that the axes leave open.

    joint : from 0, the joint whose link moves
    offsets : change of each joint's offset for one radian or metre, shape (n,)
    shift : of the base for one metre, shape (3,)
    sliding : whether it is a length
    """

    joint: int
    offsets: Array
    shift: Array
    sliding: bool


@dataclass(frozen=True, eq=False)
class AxisFit:
    """One way to make b's axes those of a: q_b = signs ∘ q_a + offsets, base at T_ab."""

    T_ab: Transform
    signs: Array
    offsets: Array
    unknown: tuple[Undetermined, ...]
    open_zeros: tuple[OpenZero, ...] = ()

    def moved(self, zero: OpenZero, by: float) -> AxisFit:
        """This fit with an open zero moved."""
        T = Transform(self.T_ab.R, self.T_ab.p + by * zero.shift)
        return replace(self, T_ab=T, offsets=self.offsets + by * zero.offsets)


def link_poses(arm: SerialArm, fit: AxisFit | None = None) -> Array:
    """The pose of each link's frame i at q_a = 0 in a's base frame, shape (n, 4, 4)."""
    offsets = np.zeros(arm.n) if fit is None else fit.offsets
    T = arm.base.matrix() if fit is None else fit.T_ab.matrix() @ arm.base.matrix()
    poses = []
    for joint, link, offset in zip(arm.joints, arm.links, offsets, strict=True):
        if offset:
            T = T @ joint.motion(float(offset)).matrix()
        T = T @ link.link_tip_frame.matrix()
        poses.append(T)
    return np.array(poses)


class TorqueDifference:
    """Δτ of arms a and b under any alignment that makes their axes coincide."""

    def __init__(self, a: SerialArm, b: SerialArm) -> None:
        self.a, self.b = a, b
        base = random_states(a.n, _STATES, _SEED)
        q = np.repeat(base.q, _FIFTHS, axis=0)
        q[:, -1] += np.tile(np.arange(_FIFTHS) * (2.0 * np.pi / _FIFTHS), _STATES)
        self._states = q, *(np.repeat(x, _FIFTHS, axis=0) for x in (base.qd, base.qdd))
        self._regressors: list[tuple[Array, Array]] = []
        self._poses = link_poses(a)
        self._inverse_poses = np.linalg.inv(self._poses)
        self._bodies = np.array([pseudo_inertia(link.inertia.parameters()) for link in b.links])
        self._torque = self._regressor(a.gravity) @ a.parameters()
        tau_b = rnea(b, *self._states)
        size = np.sqrt((self._torque.reshape(-1, a.n) ** 2 + tau_b**2).mean(axis=0) / 2.0)
        most = float(size.max()) or 1.0
        self._scale = np.tile(np.where(size > _NOTHING * most, size, most), len(q))

    def torque(self, fit: AxisFit) -> Array:
        """Δτ at the states, one after the other, shape (N n,) [N m] or [N]."""
        Y = self._regressor(fit.T_ab.R @ self.b.gravity)
        return np.asarray(self._torque - Y @ self._parameters(fit).ravel())

    def far_better(self, one: AxisFit, other: AxisFit) -> bool:
        """Whether an alignment leaves far less than another, in the links that the two place
        differently.  An error in another link says nothing about the choice.
        """
        placed = [self._parameters(fit) for fit in (one, other)]
        Ys = [self._regressor(fit.T_ab.R @ self.b.gravity) for fit in (one, other)]
        if Ys[0] is not Ys[1]:
            left = [self.relative(self.torque(fit)) for fit in (one, other)]
        else:
            apart = np.abs(placed[0] - placed[1]).max(axis=1)
            links = apart > _NOTHING * np.abs(placed[0]).max(axis=1)
            pi_a = self.a.parameters().reshape(-1, 10)
            left = [
                self.relative(Ys[0] @ np.where(links[:, None], pi_a - pi_b, 0.0).ravel())
                for pi_b in placed
            ]
        return left[0] < FAR_BETTER * left[1] - _NOTHING

    def _parameters(self, fit: AxisFit) -> Array:
        """B's inertial parameters in a's link frames, shape (n, 10)."""
        to_a = self._inverse_poses @ link_poses(self.b, fit)
        moved = to_a @ self._bodies @ np.swapaxes(to_a, -1, -2)
        return parameters_from_pseudo_inertia(moved)

    def relative(self, torque: Array) -> float:
        """RMS over joints and states, each joint's in parts of its own torque in both arms.

        So a wrist counts as much as a shoulder, and a slide as much as a turn.
        """
        return float(np.sqrt(((torque / self._scale) ** 2).mean()))

    def of_numbers(self, pi_b: Array) -> float:
        """The same for b's inertial parameters as they are taken to be in a's link frames."""
        return self.relative(self._torque - self._regressor(self.a.gravity) @ pi_b)

    def with_open_zeros_found(self, fit: AxisFit) -> AxisFit:
        """The fit with its open zeros where the torque difference is smallest.

        A zero that torques do not show either stays where it is, and unknown.
        """
        # One zero may hide behind another: a second round sees the first ones found.
        for zero in fit.open_zeros * (1 if len(fit.open_zeros) < 2 else 2):
            curve = _Curve.through(
                zero, {by: self.torque(fit.moved(zero, by)) / self._scale for by in _samples(zero)}
            )
            if curve.is_flat():
                continue
            by = curve.best(list(self._likely(fit, zero)))
            unknown = tuple(each for each in fit.unknown if each.joint != zero.joint + 1)
            fit = replace(fit.moved(zero, by), unknown=unknown)
        return fit

    def _likely(self, fit: AxisFit, zero: OpenZero) -> Iterator[float]:
        """Moves of a zero that are tried before any other: none, to where it is as written and a
        quarter turn from there, and to where the centres of mass meet."""
        k = zero.joint
        yield 0.0
        yield -float(fit.offsets[k])
        start = joint_starts(self.a)[k]
        axis = fit.signs[k] * (start.R @ self.a.joints[k].axis)
        apart = [
            poses[k, :3, :3] @ link.inertia.com + poses[k, :3, 3] - start.p
            for poses, link in (
                (link_poses(self.b, fit), self.b.links[k]),
                (self._poses, self.a.links[k]),
            )
        ]
        if zero.sliding:
            yield float(axis @ (apart[1] - apart[0]))
        else:
            yield from (-float(fit.offsets[k]) + turn * np.pi / 2 for turn in (1, 2, 3))
            levers = [across(each, axis) for each in apart]
            if min(float(np.linalg.norm(lever)) for lever in levers) > _NOTHING:
                yield angle_about(axis, *levers)

    def _regressor(self, gravity: Array) -> Array:
        """Y under this gravity, shape (N n, 10 n)."""
        for known, Y in self._regressors:
            if np.abs(known - gravity).max() <= 1e-12 * float(np.abs(known).max(initial=0.0)):
                return Y
        Y = torque_regressor(self.a.with_gravity(gravity), *self._states)
        Y = Y.reshape(-1, Y.shape[-1])
        self._regressors.append((np.asarray(gravity), Y))
        return Y


@dataclass(frozen=True, eq=False)
class _Curve:
    """|Δτ|² over an open zero x: f(x) = h(x)ᵀ G h(x), h the harmonics (or powers) up to two."""

    sliding: bool
    G: Array

    @classmethod
    def through(cls, zero: OpenZero, torques: dict[float, Array]) -> _Curve:
        basis = np.array([_harmonics(x, zero.sliding)[0] for x in torques])
        coefficients = np.linalg.solve(basis, np.array(list(torques.values())))
        return cls(zero.sliding, coefficients @ coefficients.T / coefficients.shape[1])

    def is_flat(self) -> bool:
        """Whether torque does not depend on the zero."""
        return bool(np.sqrt(np.abs(np.diag(self.G)[1:]).max()) < _NOTHING)

    def best(self, likely: list[float]) -> float:
        """The likely value with the smallest difference, unless the least of all is far better."""
        least = self._least()
        found = likely[0]
        for x in likely[1:]:
            if self._rms(x) < self._rms(found) * (1.0 - 1e-6) - _NOTHING:
                found = x
        return least if self._rms(least) < FAR_BETTER * self._rms(found) - _NOTHING else found

    def _least(self) -> float:
        if self.sliding:  # f′ is a cubic
            c0, c1, c2 = self.G  # rows
            cubic = [4 * c2[2], 6 * c1[2], 2 * (c1[1] + 2 * c0[2]), 2 * c0[1]]
            starts = [0.0, *(float(root.real) for root in np.roots(cubic))]
        else:  # of degree four, and far smoother than five degrees
            starts = [k * np.pi / 36 for k in range(72)]
        h = np.array([_harmonics(start, self.sliding)[0] for start in starts])
        x = starts[int(((h @ self.G) * h).sum(axis=1).argmin())]
        for _ in range(20):  # Newton's method on f′
            value, d, dd = _harmonics(x, self.sliding)
            slope, bend = d @ self.G @ value, d @ self.G @ d + value @ self.G @ dd
            if not bend > 0.0:
                break
            x -= float(slope / bend)
        return x

    def _rms(self, x: float) -> float:
        h, *_ = _harmonics(x, self.sliding)
        return float(np.sqrt(max(0.0, float(h @ self.G @ h))))


def _samples(zero: OpenZero) -> list[float]:
    return [-1.0, 0.0, 1.0] if zero.sliding else [2.0 * np.pi * k / 5 for k in range(5)]


def _harmonics(x: float, sliding: bool) -> tuple[Array, Array, Array]:
    """(1, cos x, sin x, cos 2x, sin 2x) or (1, x, x²), and both derivatives."""
    if sliding:
        return np.array([1.0, x, x * x]), np.array([0.0, 1.0, 2.0 * x]), np.array([0.0, 0.0, 2.0])
    c, s, c2, s2 = np.cos(x), np.sin(x), np.cos(2.0 * x), np.sin(2.0 * x)
    return (
        np.array([1.0, c, s, c2, s2]),
        np.array([0.0, -s, c, -2.0 * s2, 2.0 * c2]),
        np.array([0.0, -c, -s, -4.0 * c2, -4.0 * s2]),
    )


def gravity_kept(a: SerialArm, b: SerialArm, fit: AxisFit) -> AxisFit:
    """The fit with the turn about the first axis shared so that gravity is the same in both arms.

    The zero of the first turning joint and a turn of the base about its axis are one freedom, as
    long as only slides along that axis come before it.  The base takes it all if that keeps
    gravity, or the joint if that does; else it is shared so that gravity is kept.  Where no share
    keeps gravity, the base takes it.
    """
    r = next((i for i, joint in enumerate(b.joints) if joint.kind == "revolute"), None)
    if r is None or b.n == 1:
        return fit
    before, slides = fit.T_ab @ b.base, []
    for joint, link, offset in zip(b.joints[:r], b.links[:r], fit.offsets[:r], strict=True):
        slides.append(before.R @ joint.axis)
        before = before @ joint.motion(float(offset)) @ link.link_tip_frame
    axis = before.R @ b.joints[r].axis
    if any(np.linalg.norm(np.cross(slide, axis)) > _NOTHING for slide in slides):
        return fit
    tilt = smallest_rotation(fit.T_ab.R.T @ axis, axis)
    down_a, down_b = across(a.gravity, axis), across(fit.T_ab.R @ b.gravity, axis)
    turns = [
        float(fit.offsets[r]),
        -signed_angle(fit.T_ab.R @ tilt.R.T, axis),
        angle_about(axis, down_b, down_a),
    ]

    def turned(by: float) -> AxisFit:
        offsets = fit.offsets.copy()
        offsets[r] -= by
        undo = before @ b.joints[r].motion(by) @ before.inverse()
        return replace(fit, T_ab=undo @ fit.T_ab, offsets=offsets)

    def keeps(each: AxisFit) -> bool:
        down_a, down_b = a.gravity, each.T_ab.R @ b.gravity
        sizes = float(np.linalg.norm(down_a) * np.linalg.norm(down_b))
        return bool(down_a @ down_b >= 0.0) and (
            float(np.linalg.norm(np.cross(down_a, down_b))) <= SAME_ANGLE * sizes
        )

    fits = [turned(by) for by in turns]
    return next((each for each in fits if keeps(each)), fits[0])
