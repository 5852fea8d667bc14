"""Three-component vectors and matrices over any scalar: a float, an array of states, a symbol.

A component is a Python float when it is a constant of the arm, and otherwise anything with + − ×: a
real or complex NumPy array with one number per state, or a SymPy expression.  Operations with
constants 0 and ±1 are not carried out, so that the many zeros of a chain (a DH table, for instance)
cost nothing and closed forms contain no `0*sin(q)`.  Only these constants are compared and nothing
is conjugated, so that complex-step derivatives are exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .._robot.transforms import Array

__all__ = ["ZERO", "Matrix", "Scalar", "Vector", "plus", "times"]

Scalar = Any


def times(a: Scalar, b: Scalar) -> Scalar:
    """A product; constants 0 and ±1 cost nothing."""
    for constant, other in ((a, b), (b, a)):
        if type(constant) is float:
            if constant == 0.0:
                return 0.0
            if constant == 1.0:
                return other
            if constant == -1.0:
                return -other
    return a * b


def plus(a: Scalar, b: Scalar) -> Scalar:
    """A sum; a constant 0 costs nothing."""
    if type(a) is float and a == 0.0:
        return b
    if type(b) is float and b == 0.0:
        return a
    return a + b


def _minus(a: Scalar, b: Scalar) -> Scalar:
    if type(b) is float and b == 0.0:
        return a
    if type(a) is float and a == 0.0:
        return -b
    return a - b


class Vector:
    """A 3-vector; `+`, `-`, `* scalar`, `cross`, `dot`."""

    __slots__ = ("x", "y", "z")

    def __init__(self, x: Scalar, y: Scalar, z: Scalar) -> None:
        self.x, self.y, self.z = x, y, z

    @classmethod
    def of(cls, values: Any) -> Vector:
        """From three numbers, which become constants."""
        return cls(*(float(value) for value in values))

    def __iter__(self) -> Any:
        return iter((self.x, self.y, self.z))

    def __add__(self, other: Vector) -> Vector:
        return Vector(plus(self.x, other.x), plus(self.y, other.y), plus(self.z, other.z))

    def __sub__(self, other: Vector) -> Vector:
        return Vector(_minus(self.x, other.x), _minus(self.y, other.y), _minus(self.z, other.z))

    def __mul__(self, scalar: Scalar) -> Vector:
        return Vector(times(self.x, scalar), times(self.y, scalar), times(self.z, scalar))

    def cross(self, other: Vector) -> Vector:
        """self × other."""
        return Vector(
            _minus(times(self.y, other.z), times(self.z, other.y)),
            _minus(times(self.z, other.x), times(self.x, other.z)),
            _minus(times(self.x, other.y), times(self.y, other.x)),
        )

    def dot(self, other: Vector) -> Scalar:
        """self · other, without conjugation."""
        xy = plus(times(self.x, other.x), times(self.y, other.y))
        return plus(xy, times(self.z, other.z))

    def turned_about_z(self, cos: Scalar, sin: Scalar) -> Vector:
        """Rot_z · self, from the cosine and sine of the angle."""
        return Vector(
            _minus(times(cos, self.x), times(sin, self.y)),
            plus(times(sin, self.x), times(cos, self.y)),
            self.z,
        )

    def turned_back_about_z(self, cos: Scalar, sin: Scalar) -> Vector:
        """Rot_zᵀ · self."""
        return Vector(
            plus(times(cos, self.x), times(sin, self.y)),
            _minus(times(cos, self.y), times(sin, self.x)),
            self.z,
        )


ZERO = Vector(0.0, 0.0, 0.0)


class Matrix:
    """A constant 3×3 matrix; `@ Vector`, `.T`."""

    __slots__ = ("T", "rows")

    T: Matrix

    def __init__(self, rows: Sequence[Sequence[Scalar]]) -> None:
        self.rows = [Vector(*row) for row in rows]
        transposed: Matrix = object.__new__(Matrix)
        transposed.rows = [Vector(*column) for column in zip(*rows, strict=True)]
        self.T, transposed.T = transposed, self

    @classmethod
    def of(cls, values: Array) -> Matrix:
        """From nine numbers, which become constants."""
        return cls([[float(entry) for entry in row] for row in values])

    def __matmul__(self, v: Vector) -> Vector:
        return Vector(*(row.dot(v) for row in self.rows))
