"""Upper bounds of |Δg_j| over all positions within the limits.

A gravity torque is of degree 1 in every joint: a + b cos q_k + c sin q_k in an angle, a + b q_k in
a displacement.  So are differences of two.  Its 3^n (2 for a displacement) coefficients therefore
follow from as many evaluations, and three facts bound it:

- in a displacement it is linear, so that it is largest at an end of the range;
- over one angle, max |a + b cos q + c sin q| = |a| + √(b² + c²), exactly;
- a trigonometric polynomial of degree 1 in one angle is at most 1 / cos(π / N) times its largest
  value on N equidistant points of the circle (Ehlich & Zeller 1964), angle by angle.

The sum of the amplitudes of its harmonics exp(i Σ m_k q_k), m_k ∈ {−1, 0, 1}, is another bound,
which a planar arm reaches.  The smaller of the two counts.  Limits of angles are not used.
"""

from __future__ import annotations

import numpy as np

from ..._robot.transforms import Array
from ..arm_pair import Pair
from .coordinate_ascent import TorqueGap
from .state_box import StateBox

__all__ = ["gravity_bounds"]

#: Evaluations; 3^13 is about it.
_MOST_SAMPLES = 2_000_000
_MOST_POINTS = 2**19
_MOST_PER_ANGLE = 64
#: Coefficients below this part of the largest torque are rounding; they count with their size.
_ROUNDING = 1e-12

_THIRDS = 2.0 * np.pi * np.arange(3) / 3.0
#: From the values at three angles: a, b and c of a + b cos q + c sin q.
_FIT = np.linalg.inv(np.stack([np.ones(3), np.cos(_THIRDS), np.sin(_THIRDS)], axis=1))
#: From (a, b, c) to the coefficients of exp(−i q), 1, exp(i q).
_HARMONICS = np.array([[0.0, 0.5, 0.5j], [1.0, 0.0, 0.0], [0.0, 0.5, -0.5j]])


def gravity_bounds(pair: Pair, box: StateBox) -> Array | None:
    """At most this much is |Δg_j|, shape (n,) [N m]; None where n is too large for it."""
    n, joints = pair.a.n, pair.a.joints
    sliding = [joint.kind == "prismatic" for joint in joints]
    points = [
        np.array([low, high]) if slides else _THIRDS
        for slides, low, high in zip(sliding, box.lower, box.upper, strict=True)
    ]
    if np.prod([float(len(each)) for each in points]) > _MOST_SAMPLES:
        return None
    q = np.stack(np.meshgrid(*points, indexing="ij"), axis=-1)
    still = np.zeros_like(q)
    delta = TorqueGap(pair, static=True)(q, still, still)
    scale = float(np.abs(delta).max())
    for k in range(n):
        if not sliding[k]:
            delta = np.moveaxis(np.tensordot(_FIT, delta, axes=(1, k)), 0, k)
    angles = tuple(k for k in range(n) if not sliding[k])
    # Ends of displacements first, then one axis of (a, b, c) for each angle.
    ordered = np.moveaxis(delta, angles, range(n - len(angles), n))
    ends = ordered.reshape(-1, *([3] * len(angles)), n)
    bounds = [
        max((_bound(coefficients[..., j], scale) for coefficients in ends), default=0.0)
        for j in range(n)
    ]
    return np.array(bounds)


def _bound(coefficients: Array, scale: float) -> float:
    """Of a polynomial of degree 1 in each of its angles, an axis of (a, b, c) for each."""
    amplitudes = coefficients.astype(np.complex128)
    for k in range(coefficients.ndim):
        amplitudes = np.moveaxis(np.tensordot(_HARMONICS, amplitudes, axes=(1, k)), 0, k)
    harmonics = float(np.abs(amplitudes).sum())
    # Angles on which nothing depends need no grid; what rounding leaves of them is added.
    left_out = 0.0
    kept = coefficients
    for k in reversed(range(coefficients.ndim)):
        waves = np.delete(kept, 0, axis=k)
        if np.abs(waves).max(initial=0.0) <= _ROUNDING * scale:
            left_out += float(np.abs(waves).sum())
            kept = np.take(kept, 0, axis=k)
    return min(harmonics, _grid_bound(kept) + left_out) + _ROUNDING * scale


def _grid_bound(coefficients: Array) -> float:
    """One angle is eliminated, the others are on a grid."""
    gridded = coefficients.ndim - 1
    if gridded < 0:
        return float(abs(coefficients))
    count = int(min(_MOST_PER_ANGLE, _MOST_POINTS ** (1.0 / max(gridded, 1))))
    circle = 2.0 * np.pi * np.arange(count) / count
    basis = np.stack([np.ones(count), np.cos(circle), np.sin(circle)], axis=1)
    values = coefficients
    for _ in range(gridded):
        values = np.tensordot(values, basis, axes=(0, 1))
    constant, cosine, sine = values
    largest = float((np.abs(constant) + np.hypot(cosine, sine)).max())
    return largest / float(np.cos(np.pi / count)) ** gridded
