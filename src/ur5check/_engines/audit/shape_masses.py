"""The inertia of a link for an engine that derives it from the link's shape.

Boxes, cylinders and spheres of 1000 kg/m³, MuJoCo's default density.  Meshes are not read: what
an engine makes of one depends on the mesh's file, and is named without its number.
"""

from __future__ import annotations

from functools import reduce
from operator import add
from typing import TYPE_CHECKING

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.transforms import Array, Transform

if TYPE_CHECKING:
    from lxml.etree import _Element

__all__ = ["DENSITY", "inertia_of_shapes"]

DENSITY = 1000.0  # [kg/m³]


def inertia_of_shapes(link: _Element) -> Inertia | None:
    """The inertia of a link's collision shapes, in the link's frame; None without a shape of known
    volume."""
    bodies = [_body(shape) for shape in link.iterchildren("collision")]
    known = [body for body in bodies if body is not None]
    return reduce(add, known) if known else None


def _body(collision: _Element) -> Inertia | None:
    solid = _solid(collision)
    if solid is None:
        return None
    volume, moments = solid
    mass = DENSITY * volume
    origin = collision.find("origin")
    given = {} if origin is None else origin.attrib
    pose = Transform.from_rpy(_numbers(given.get("xyz")), list(_numbers(given.get("rpy"))))
    return Inertia(mass, np.zeros(3), np.diag(mass * moments)).expressed_in(pose)


def _solid(collision: _Element) -> tuple[float, Array] | None:
    """Volume [m³] and moments of inertia for a mass of one, shape (3,) [m²]."""
    box = collision.find("geometry/box")
    if box is not None:
        a, b, c = _numbers(box.get("size"))
        return float(a * b * c), np.array([b * b + c * c, a * a + c * c, a * a + b * b]) / 12.0
    sphere = collision.find("geometry/sphere")
    if sphere is not None:
        r = float(sphere.get("radius", "0"))
        return 4.0 / 3.0 * np.pi * r**3, np.full(3, 0.4 * r * r)
    cylinder = collision.find("geometry/cylinder")
    if cylinder is not None:
        r, length = float(cylinder.get("radius", "0")), float(cylinder.get("length", "0"))
        across = (3.0 * r * r + length * length) / 12.0
        return np.pi * r * r * length, np.array([across, across, r * r / 2.0])
    return None


def _numbers(text: str | None) -> Array:
    return np.array([float(word) for word in (text or "0 0 0").split()])
