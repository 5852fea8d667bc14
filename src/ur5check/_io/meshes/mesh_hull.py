"""What is asked of a mesh file: the corners of its convex hull, and volumes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from ..._robot.transforms import Array

__all__ = ["MESH_FORMATS", "MeshHull", "hull_of", "read_hull"]

MESH_FORMATS = (".dae", ".glb", ".obj", ".off", ".ply", ".stl")  # one file each, no archive


@dataclass(frozen=True, eq=False)
class MeshHull:
    """corners : of the convex hull, shape (k, 3) [m]
    volume : of the solid; of its convex hull where the surface does not close [m³]
    hull_volume : of the convex hull [m³]
    closed : whether the surface closes
    """

    corners: Array
    volume: float
    hull_volume: float
    closed: bool


def read_hull(path: Path) -> MeshHull:
    """The hull of a mesh file, which is read once for all robots as long as it does not change.

    COLLADA files say what a unit of theirs is; it is applied, as viewers and simulators do.

    Raises ValueError for a mesh that encloses nothing, and whatever the format's library raises.
    """
    state = path.stat()
    return _read(path, state.st_mtime_ns, state.st_size)


@lru_cache(maxsize=4096)  # corners only: some kilobytes each
def _read(path: Path, changed: int, size: int) -> MeshHull:
    import trimesh

    if path.suffix.lower() not in MESH_FORMATS:
        raise ValueError(f"{path.suffix or 'this'} is no mesh format that is read here")
    scene: Any = trimesh.load_scene(path, skip_materials=True)
    unit = scene.units if path.suffix.lower() == ".dae" else None
    mesh = scene.to_mesh()
    if unit is not None and unit != "meters":
        mesh.apply_scale(trimesh.units.unit_conversion(unit, "meters"))
    return hull_of(mesh)


def hull_of(mesh: Any) -> MeshHull:
    """The hull of a trimesh.  Raises ValueError if it encloses nothing."""
    from scipy.spatial import ConvexHull, QhullError

    points = np.asarray(getattr(mesh, "vertices", ()), dtype=np.float64)
    if len(points) < 4 or not np.isfinite(points).all() or not np.ptp(points, axis=0).all():
        raise ValueError("it encloses nothing")
    try:
        hull = ConvexHull(points, qhull_options="QbB Pp Qt")  # scaled to a cube: any unit is fine
    except QhullError:
        hull = ConvexHull(points, qhull_options="QJ")  # nearly flat: joggled until it is not
    corners = points[hull.vertices]
    facets = points[hull.simplices] - corners.mean(axis=0)  # pyramids from a point inside
    filled = float(np.abs(np.linalg.det(facets)).sum() / 6.0)
    closed = bool(mesh.is_watertight)
    return MeshHull(corners, abs(float(mesh.volume)) if closed else filled, filled, closed)
