"""Rigid transforms between frames.

`T_ab` takes coordinates in frame b to coordinates in frame a: x_a = T_ab · x_b, and
T_ac = T_ab @ T_bc, so that neighbouring letters cancel.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Transform", "cos_sin", "frozen", "skew"]

Array = NDArray[np.float64]

# A double cannot hold π/2; cos of the nearest one is 6e-17.  An angle within two units in the last
# place of a multiple of π/2 *is* that multiple: 2 ulp covers `3 * pi / 2`, computed in any order.
_ULPS = 2


def frozen(values: ArrayLike, shape: tuple[int, ...]) -> Array:
    """A read-only float64 copy of `values`, which must have this shape and be finite."""
    # In one memory order: products of transposed and of plain arrays round differently.
    array = np.array(values, dtype=np.float64, order="C")
    if array.shape != shape:
        raise ValueError(f"expected shape {shape}, got {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"expected finite numbers, got {array.tolist()}")
    array.flags.writeable = False
    return array


def cos_sin(angle: float) -> tuple[float, float]:
    """Cosine and sine of `angle` [rad], exact at the doubles that stand for multiples of π/2."""
    quarter_turns = round(angle / (math.pi / 2))
    nearest = quarter_turns * (math.pi / 2)
    if abs(angle - nearest) <= _ULPS * math.ulp(nearest):
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[quarter_turns % 4]
    return math.cos(angle), math.sin(angle)


def skew(v: ArrayLike) -> Array:
    """The matrix S(v), shape (3, 3), with S(v) x = v × x."""
    x, y, z = np.asarray(v, dtype=np.float64)
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


@dataclass(frozen=True, eq=False)
class Transform:
    """A rigid transform T_ab: rotation `R` (3, 3) and translation `p` (3,) [m].

    The columns of R are b's axes in a; p is b's origin in a.
    """

    R: Array
    p: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "R", frozen(self.R, (3, 3)))
        object.__setattr__(self, "p", frozen(self.p, (3,)))

    @classmethod
    def identity(cls) -> Transform:
        return cls(np.eye(3), np.zeros(3))

    @classmethod
    def translation(cls, xyz: ArrayLike) -> Transform:
        return cls(np.eye(3), np.asarray(xyz, dtype=np.float64))

    @classmethod
    def rotation(cls, axis: ArrayLike, angle: float) -> Transform:
        """Turn by `angle` [rad] about the unit vector `axis` (Rodrigues' formula)."""
        u = np.asarray(axis, dtype=np.float64)
        c, s = cos_sin(angle)
        return cls(c * np.eye(3) + s * skew(u) + (1.0 - c) * np.outer(u, u), np.zeros(3))

    @classmethod
    def from_rpy(cls, xyz: ArrayLike, rpy: Sequence[float]) -> Transform:
        """URDF's `<origin xyz rpy>`: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll), fixed axes."""
        roll, pitch, yaw = rpy
        R = (
            cls.rotation((0, 0, 1), yaw)
            @ cls.rotation((0, 1, 0), pitch)
            @ cls.rotation((1, 0, 0), roll)
        )
        return cls(R.R, np.asarray(xyz, dtype=np.float64))

    @classmethod
    def from_quaternion(cls, xyz: ArrayLike, wxyz: ArrayLike) -> Transform:
        """From a quaternion, scalar first, of any length but zero.

        Dividing by the squared length makes a rotation of any four numbers: quarter turns come out
        exact although no double holds √½.
        """
        w, *v = (float(x) for x in np.asarray(wxyz, dtype=np.float64))
        x, y, z = v
        s = 2.0 / (w * w + x * x + y * y + z * z)
        R = [
            [1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)],
        ]
        return cls(np.array(R), np.asarray(xyz, dtype=np.float64))

    @classmethod
    def from_matrix(cls, matrix: ArrayLike) -> Transform:
        """From a homogeneous matrix, shape (4, 4)."""
        T = np.asarray(matrix, dtype=np.float64)
        return cls(T[:3, :3], T[:3, 3])

    def __matmul__(self, other: Transform) -> Transform:
        """T_ac = T_ab @ T_bc."""
        return Transform(self.R @ other.R, self.R @ other.p + self.p)

    def inverse(self) -> Transform:
        """T_ba."""
        return Transform(self.R.T, -(self.R.T @ self.p))

    def matrix(self) -> Array:
        """The homogeneous matrix, shape (4, 4)."""
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = self.R, self.p
        return T

    def angle(self) -> float:
        """How far the rotation turns, in [0, π] rad; accurate near 0 and near π."""
        twice_sine = np.linalg.norm(
            [
                self.R[2, 1] - self.R[1, 2],
                self.R[0, 2] - self.R[2, 0],
                self.R[1, 0] - self.R[0, 1],
            ]
        )
        return float(np.arctan2(twice_sine, np.trace(self.R) - 1.0))
