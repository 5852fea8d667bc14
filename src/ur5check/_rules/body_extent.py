"""How far a link's shapes extend along a direction, and what they enclose.

The bound that the rules need is one-dimensional: if all of a body lies between `low` and `high`
along a unit vector u and its centre of mass at c, its spread about the centre is at most

    σ² = uᵀ Σ u / m ≤ (c − low)(high − c),    Σ = ∫ (x − c)(x − c)ᵀ dm = ½ tr(I) 1 − I,

since (x − low)(high − x) ≥ 0 for every point of the body and its mean is what stands on the right
less σ².  Equality needs all mass at the two ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .._robot.robot import ShapeRef
from .._robot.transforms import Array

__all__ = ["Body", "Extent", "MeshBody", "PrimitiveBody"]


@dataclass(frozen=True, eq=False)
class PrimitiveBody:
    """A box, cylinder, capsule or sphere, as the file writes it."""

    shape: ShapeRef

    def extent(self, directions: Array) -> tuple[Array, Array]:
        """Lowest and highest coordinate along each row of `directions` (k, 3), each (k,) [m]."""
        local = directions @ self.shape.pose.R
        size = np.abs(self.shape.size)
        if self.shape.geometry == "box":
            half = np.abs(local) @ (size / 2.0)
        elif self.shape.geometry == "sphere":
            half = np.full(len(local), size[0])
        else:
            along = np.abs(local[:, 2])
            across = np.sqrt(np.maximum(0.0, 1.0 - along**2))
            ends = size[0] if self.shape.geometry == "capsule" else size[0] * across
            half = ends + along * size[1] / 2.0
        middle = directions @ self.shape.pose.p
        return middle - half, middle + half

    @property
    def hull_volume(self) -> float:
        """The same: these shapes are convex."""
        return self.volume

    @property
    def volume(self) -> float:
        """[m³]"""
        size = np.abs(self.shape.size)
        if self.shape.geometry == "box":
            return float(size.prod())
        if self.shape.geometry == "sphere":
            return float(4.0 / 3.0 * np.pi * size[0] ** 3)
        cylinder = float(np.pi * size[0] ** 2 * size[1])
        caps = 4.0 / 3.0 * np.pi * size[0] ** 3 if self.shape.geometry == "capsule" else 0.0
        return cylinder + float(caps)


@dataclass(frozen=True, eq=False)
class MeshBody:
    """A mesh.  points : corners of its convex hull in the link's frame, shape (k, 3) [m]
    volume : of the solid, or of the hull where the surface does not close [m³]
    hull_volume : of the convex hull, which no body that the mesh shows exceeds [m³]
    """

    shape: ShapeRef
    points: Array
    volume: float
    hull_volume: float

    def extent(self, directions: Array) -> tuple[Array, Array]:
        """As for a primitive."""
        along = self.points @ directions.T
        return along.min(axis=0), along.max(axis=0)


Body = PrimitiveBody | MeshBody


@dataclass(frozen=True, eq=False)
class Extent:
    """The shapes of one link together.  bodies : at least one"""

    bodies: Sequence[Body]

    def along(self, directions: Array) -> tuple[Array, Array]:
        """Lowest and highest coordinate along unit vectors (k, 3), each (k,) [m]."""
        low, high = zip(*(body.extent(directions) for body in self.bodies), strict=True)
        return np.min(low, axis=0), np.max(high, axis=0)

    @property
    def diameter(self) -> float:
        """The longest edge of the box along the link's axes [m]."""
        low, high = self.along(np.eye(3))
        return float((high - low).max())

    @property
    def volume(self) -> float:
        """Of the larger of the two pictures, collision and visual, as solids [m³]."""
        kinds = ("collision", "visual")
        return max(sum(b.volume for b in self.bodies if b.shape.kind == kind) for kind in kinds)

    @property
    def most_volume(self) -> float:
        """Of the larger of the two pictures, each shape filled to its convex hull [m³]."""
        kinds = ("collision", "visual")
        return max(
            sum(b.hull_volume for b in self.bodies if b.shape.kind == kind) for kind in kinds
        )
