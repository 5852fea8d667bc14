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

from .._arguments import number, number_array
from .._errors import ModelError

__all__ = ["Array", "Transform", "cos_sin", "frozen", "skew", "unit_vector"]

Array = NDArray[np.float64]

# π/2 is not a double; the cosine of the nearest one is 6e-17.  An angle within two units in the
# last place of a multiple of π/2 is taken as that multiple: 2 ulp covers `3 * pi / 2`, computed in
# any order.
_ULPS = 2


def frozen(values: ArrayLike, shape: tuple[int, ...], name: str = "array") -> Array:
    """A read-only float64 copy of `values`.

    Raises ModelError, with `name`, for values that are not finite real numbers of this shape.
    """
    # In one memory order: products of transposed and of plain arrays round differently.
    numbers = number_array(name, values, error=_array_error)
    array = np.array(numbers, dtype=np.float64, order="C")
    if array.shape != shape:
        raise ModelError(f"{name} has shape {array.shape}", fix=f"give an array of shape {shape}")
    if not np.isfinite(array).all():
        raise ModelError(f"{name} is not finite", fix="give finite numbers", value=array.tolist())
    array.flags.writeable = False
    return array


def _array_error(problem: str) -> ModelError:
    return ModelError(problem, fix="give an array of real numbers")


def cos_sin(angle: float) -> tuple[float, float]:
    """Cosine and sine of `angle` [rad], exact for the doubles next to multiples of π/2."""
    quarter_turns = round(angle / (math.pi / 2))
    nearest = quarter_turns * (math.pi / 2)
    if abs(angle - nearest) <= _ULPS * math.ulp(nearest):
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[quarter_turns % 4]
    return math.cos(angle), math.sin(angle)


def skew(v: ArrayLike) -> Array:
    """The matrix S(v), shape (3, 3), with S(v) x = v × x."""
    x, y, z = np.asarray(v, dtype=np.float64)
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def unit_vector(v: Array) -> Array:
    """The direction of v, shape (3,), finite and not zero.

    A vector of unit length, to rounding, comes back as it is: division would change its digits.
    """
    with np.errstate(over="ignore"):
        length = float(np.linalg.norm(v))
    if not 0.0 < length < np.inf:  # squares of 1e±200 overflow or vanish
        v = v / np.abs(v).max()
        length = float(np.linalg.norm(v))
    return v if abs(length - 1.0) <= np.finfo(float).eps else np.asarray(v / length)


@dataclass(frozen=True, eq=False)
class Transform:
    """A rigid transform T_ab, from coordinates in frame b to coordinates in frame a.

    Parameters
    ----------
    R : array-like, shape (3, 3)
        Rotation matrix; its columns are the axes of b in a.
    p : array-like, shape (3,)
        Origin of b in a [m].

    Raises
    ------
    ModelError
        For another shape, or entries that are not finite numbers.

    Examples
    --------
    >>> from ur5check import Transform
    >>> T = Transform.translation((1.0, 0.0, 0.0)) @ Transform.rotation((0, 0, 1), 0.0)
    >>> T.p.tolist()
    [1.0, 0.0, 0.0]
    """

    R: Array
    p: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "R", frozen(self.R, (3, 3), "R"))
        object.__setattr__(self, "p", frozen(self.p, (3,), "p"))

    @classmethod
    def identity(cls) -> Transform:
        """The transform from a frame to itself.

        Returns
        -------
        Transform
        """
        return cls(np.eye(3), np.zeros(3))

    @classmethod
    def translation(cls, xyz: ArrayLike) -> Transform:
        """A translation without rotation.

        Parameters
        ----------
        xyz : array-like, shape (3,)
            [m]

        Returns
        -------
        Transform

        Raises
        ------
        ModelError
            For another shape, or entries that are not finite numbers.
        """
        return cls(np.eye(3), frozen(xyz, (3,), "xyz"))

    @classmethod
    def rotation(cls, axis: ArrayLike, angle: float) -> Transform:
        """A rotation about an axis through the origin (Rodrigues' formula).

        Parameters
        ----------
        axis : array-like, shape (3,)
            Unit vector.
        angle : float
            [rad]; multiples of π/2 give exact zeros and ones.

        Returns
        -------
        Transform

        Raises
        ------
        ModelError, UsageError
            For another shape, or entries that are not finite numbers.
        """
        u = frozen(axis, (3,), "axis")
        c, s = cos_sin(number("angle", angle))
        return cls(c * np.eye(3) + s * skew(u) + (1.0 - c) * np.outer(u, u), np.zeros(3))

    @classmethod
    def from_rpy(cls, xyz: ArrayLike, rpy: Sequence[float]) -> Transform:
        """URDF's `<origin xyz rpy>`: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll), fixed axes.

        Parameters
        ----------
        xyz : array-like, shape (3,)
            [m]
        rpy : array-like, shape (3,)
            Roll, pitch and yaw [rad].

        Returns
        -------
        Transform

        Raises
        ------
        ModelError
            For another shape, or entries that are not finite numbers.
        """
        roll, pitch, yaw = frozen(rpy, (3,), "rpy").tolist()
        if roll == pitch == yaw == 0.0:  # most origins; files of 20,000 links are read too
            return cls(np.eye(3), frozen(xyz, (3,), "xyz"))
        R = (
            cls.rotation((0, 0, 1), yaw)
            @ cls.rotation((0, 1, 0), pitch)
            @ cls.rotation((1, 0, 0), roll)
        )
        return cls(R.R, frozen(xyz, (3,), "xyz"))

    @classmethod
    def from_quaternion(cls, xyz: ArrayLike, wxyz: ArrayLike) -> Transform:
        """From a translation and a quaternion of any norm but zero.

        The formula divides by the squared norm, so that rotations by π/2 come out exact although
        √½ is not a double.

        Parameters
        ----------
        xyz : array-like, shape (3,)
            [m]
        wxyz : array-like, shape (4,)
            The scalar part first.

        Returns
        -------
        Transform

        Raises
        ------
        ModelError
            For another shape, entries that are not finite, or a quaternion of zeros.
        """
        w, x, y, z = frozen(wxyz, (4,), "wxyz").tolist()
        squared_norm = w * w + x * x + y * y + z * z
        if squared_norm == 0.0:
            raise ModelError("the quaternion is zero", fix="give (1, 0, 0, 0) for no rotation")
        s = 2.0 / squared_norm
        R = [
            [1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)],
        ]
        return cls(np.array(R), frozen(xyz, (3,), "xyz"))

    @classmethod
    def from_matrix(cls, matrix: ArrayLike) -> Transform:
        """From a homogeneous matrix.

        Parameters
        ----------
        matrix : array-like, shape (4, 4)
            The last row is not read.

        Returns
        -------
        Transform

        Raises
        ------
        ModelError
            For another shape, or entries that are not finite numbers.
        """
        T = frozen(matrix, (4, 4), "matrix")
        return cls(T[:3, :3], T[:3, 3])

    def __matmul__(self, other: Transform) -> Transform:
        """T_ac = T_ab @ T_bc."""
        return Transform(self.R @ other.R, self.R @ other.p + self.p)

    def inverse(self) -> Transform:
        """The inverse transform T_ba.

        Returns
        -------
        Transform
        """
        return Transform(self.R.T, -(self.R.T @ self.p))

    def matrix(self) -> Array:
        """The homogeneous matrix.

        Returns
        -------
        ndarray, shape (4, 4)
        """
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = self.R, self.p
        return T

    def angle(self) -> float:
        """Angle of the rotation; accurate near 0 and near π.

        Returns
        -------
        float
            In [0, π] [rad].
        """
        twice_sine = np.linalg.norm(
            [
                self.R[2, 1] - self.R[1, 2],
                self.R[0, 2] - self.R[2, 0],
                self.R[1, 0] - self.R[0, 1],
            ]
        )
        return float(np.arctan2(twice_sine, np.trace(self.R) - 1.0))
