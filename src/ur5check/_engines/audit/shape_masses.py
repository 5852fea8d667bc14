"""The inertia of a link for an engine that derives it from the link's shape.

Boxes, cylinders and spheres of 1000 kg/m³, MuJoCo's default density.  Meshes are not read: what
an engine makes of one depends on the mesh's file, and is named without its number.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from operator import add

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.robot import ShapeRef
from ..._robot.transforms import Array

__all__ = ["DENSITY", "inertia_of_shapes"]

DENSITY = 1000.0  # [kg/m³]


def inertia_of_shapes(shapes: Iterable[ShapeRef]) -> Inertia | None:
    """The inertia of a link's collision shapes, in the link's frame; None without a shape of known
    volume."""
    bodies = [_body(shape) for shape in shapes if shape.kind == "collision"]
    known = [body for body in bodies if body is not None]
    return reduce(add, known) if known else None


def _body(shape: ShapeRef) -> Inertia | None:
    solid = _solid(shape)
    if solid is None:
        return None
    volume, moments = solid
    mass = DENSITY * volume
    return Inertia(mass, np.zeros(3), np.diag(mass * moments)).expressed_in(shape.pose)


def _solid(shape: ShapeRef) -> tuple[float, Array] | None:
    """Volume [m³] and moments of inertia for a mass of one, shape (3,) [m²]."""
    if shape.geometry == "box":
        a, b, c = shape.size
        return a * b * c, np.array([b * b + c * c, a * a + c * c, a * a + b * b]) / 12.0
    if shape.geometry == "sphere":
        (r,) = shape.size
        return 4.0 / 3.0 * np.pi * r**3, np.full(3, 0.4 * r * r)
    if shape.geometry == "cylinder":
        r, length = shape.size
        across = (3.0 * r * r + length * length) / 12.0
        return np.pi * r * r * length, np.array([across, across, r * r / 2.0])
    return None
