"""A link's numbers against the shape that its URDF shows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..._io.meshes.mesh_shapes import Shape
from ..._robot.inertia import Inertia
from ..._robot.serial_arm import Link
from ..._robot.transforms import Array
from .plausible_body import Plausibility, Severity

if TYPE_CHECKING:
    from scipy.spatial import ConvexHull

__all__ = ["extent_findings"]

#: How far a mesh may be from the body that it shows [m]: rounded edges, covers, screws.
_MARGIN = 0.005

#: k of the link over k of its hull filled evenly.  All mass at the ends of a rod gives √3; all
#: of it in a middle part of the same form, a fifth as large, gives ⅕.
_WIDEST, _NARROWEST = float(np.sqrt(3.0)), 0.2

#: kg/m³.  A hollow shell of aluminium or carbon with cables in it stays above 200 (balsa has 150);
#: nothing that arms are built of is denser than copper, 8,960 (steel 7,850, aluminium 2,700).
_LIGHTEST, _DENSEST = 200.0, 9000.0


def extent_findings(number: int, link: Link, shapes: Sequence[Shape]) -> list[Plausibility]:
    """Centre of mass, radii of gyration and density against the shapes, in the source's frame."""
    from scipy.spatial import ConvexHull, QhullError  # heavy: only links with shapes pay for it

    inertia = link.inertia.expressed_in(link.source_frame.inverse())
    points = np.concatenate([shape.vertices for shape in shapes])
    try:
        hull = ConvexHull(points)
    except QhullError:
        return []  # flat shapes enclose no volume and say nothing about a body
    findings = _centre(number, link.name, inertia, hull)
    findings += _gyration(number, link.name, inertia, hull)
    return findings + _density(number, link.name, inertia.mass, shapes)


def _centre(number: int, name: str, inertia: Inertia, hull: ConvexHull) -> list[Plausibility]:
    low, high = hull.points.min(axis=0), hull.points.max(axis=0)
    over_box = float(np.maximum(low - inertia.com, inertia.com - high).max())
    # Each row of `equations` is a face's outward normal and offset.
    over_hull = float((hull.equations[:, :3] @ inertia.com + hull.equations[:, 3]).max())
    if over_hull <= 0.0:
        return []
    severity: Severity = "note" if over_hull <= _MARGIN else "impossible"
    if over_box > 0.0:
        where = f"{1e3 * over_box:.3g} mm outside the mesh's bounding box"
    else:
        where = f"{1e3 * over_hull:.3g} mm outside the mesh's convex hull"
    at = ", ".join(f"{x:.4g}" for x in inertia.com)
    sentence = f"{name}: the centre of mass ({at}) m lies {where}."
    quantity = "centre of mass"
    return [Plausibility(severity, number, name, quantity, over_hull, _MARGIN, "m", sentence)]


def _gyration(number: int, name: str, inertia: Inertia, hull: ConvexHull) -> list[Plausibility]:
    """A finding on the principal axis with the most implausible radius of gyration, if any."""
    moments, axes = np.linalg.eigh(inertia.tensor)
    if moments[0] < 0.0:
        return []  # no radius; the check of the pseudo-inertia reports this
    k = np.sqrt(moments / inertia.mass)
    farthest = _distances(hull.points[hull.vertices] - inertia.com, axes).max(axis=0)
    over = k / (farthest + _MARGIN)
    worst = int(over.argmax())
    quantity = "radius of gyration"
    if over[worst] > 1.0:
        sentence = (
            f"{name}: a radius of gyration of {k[worst]:.3g} m about {_axis(axes[:, worst])}, but "
            f"no point of its mesh is farther than {farthest[worst]:.3g} m from that axis; the "
            f"moment is at least {(k[worst] / farthest[worst]) ** 2:.3g} times too large."
        )
        value, bound = float(k[worst]), float(farthest[worst])
        return [Plausibility("impossible", number, name, quantity, value, bound, "m", sentence)]
    even = np.sqrt(np.einsum("ia,ij,ja->a", axes, _even_tensor(hull), axes))
    ratio = k / even
    for worst, bound, much in (
        (int(ratio.argmax()), _WIDEST, "as if all its mass lay beyond its ends"),
        (int(ratio.argmin()), _NARROWEST, "as if all its mass lay in its middle"),
    ):
        beyond = ratio[worst] > bound if bound > 1.0 else ratio[worst] < bound
        if beyond:
            sentence = (
                f"{name}: the radius of gyration about {_axis(axes[:, worst])}, {k[worst]:.3g} m, "
                f"is {ratio[worst]:.2g} times that of the mesh filled evenly, {much}."
            )
            value, held = float(k[worst]), float(bound * even[worst])
            return [Plausibility("suspicious", number, name, quantity, value, held, "m", sentence)]
    return []


def _distances(points: Array, axes: Array) -> Array:
    """Distance of each point from each axis (a column) through the origin, shape (k, 3)."""
    along = points @ axes
    squares = (points**2).sum(axis=1, keepdims=True) - along**2
    return np.asarray(np.sqrt(np.maximum(squares, 0.0)))


def _even_tensor(hull: ConvexHull) -> Array:
    """Inertia per kilogram of the hull filled evenly, about its own centre, shape (3, 3) [m²].

    The hull is cut into tetrahedra with a corner in its middle.  One with corners v_1 … v_4 and
    s = Σ v_i has ∫ x xᵀ dV = V/20 (Σ v_i v_iᵀ + s sᵀ).
    """
    middle = hull.points[hull.vertices].mean(axis=0)
    corners = hull.points[hull.simplices] - middle  # (faces, 3, 3), the fourth corner is 0
    volumes = np.abs(np.linalg.det(corners)) / 6.0
    sums = corners.sum(axis=1)
    total = volumes.sum()
    centre = (volumes[:, None] * sums).sum(axis=0) / (4.0 * total)
    second = np.einsum("f,fvi,fvj->ij", volumes, corners, corners)
    second += np.einsum("f,fi,fj->ij", volumes, sums, sums)
    second = second / (20.0 * total) - np.outer(centre, centre)
    return np.asarray(np.trace(second) * np.eye(3) - second)


def _density(number: int, name: str, mass: float, shapes: Sequence[Shape]) -> list[Plausibility]:
    kinds = [[s for s in shapes if s.kind == kind] for kind in ("visual", "collision")]
    shown = [kind for kind in kinds if kind]
    # A closed surface has a volume; where none is closed, the hulls of the simpler shapes are used.
    best = next((kind for kind in shown if all(s.closed for s in kind)), shown[-1])
    volume = sum(shape.volume for shape in best)
    density = mass / volume
    if _LIGHTEST <= density <= _DENSEST:
        return []
    bound, than = (
        (_LIGHTEST, "lighter than balsa")
        if density < _LIGHTEST
        else (
            _DENSEST,
            "denser than copper",
        )
    )
    of = "its mesh" if all(s.closed for s in best) else "the convex hull of its mesh"
    sentence = (
        f"{name}: {mass:.4g} kg in the {1e3 * volume:.3g} litres of {of} are {density:.3g} kg/m³, "
        f"{than}."
    )
    quantity = "density"
    return [Plausibility("suspicious", number, name, quantity, density, bound, "kg/m³", sentence)]


def _axis(u: Array) -> str:
    k = int(np.abs(u).argmax())
    if abs(u[k]) > 0.999:
        return "xyz"[k]
    return f"({', '.join(f'{x:.2f}' for x in u)})"
