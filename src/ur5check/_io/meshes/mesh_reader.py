"""Meshes of a robot's links, for the rules that compare a body with its shape."""

from __future__ import annotations

import hashlib
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from ..._errors import ModelError
from ..._files import read_regular
from ..._finding import Finding
from ..._robot.robot import ShapeRef
from ..._robot.transforms import Array
from ..._rules.body_extent import MeshBody
from ..._rules.finding_log import finding_of
from ..ros_packages import PackageMap

__all__ = ["MeshReader"]

_FORMATS = (".dae", ".glb", ".obj", ".off", ".ply", ".stl")  # one file each, no archive


class MeshReader:
    """Reads a shape's mesh: a `MeshBody`, or a finding that says why there is none.

    folder : that relative paths are seen from;  packages : where package:// addresses lead
    """

    def __init__(self, folder: Path, packages: PackageMap) -> None:
        self.folder, self.packages = folder, packages
        #: SHA-256 of every mesh that was read, by its address in the file.
        self.inputs: dict[str, str] = {}

    def __call__(self, shape: ShapeRef, subject: str) -> MeshBody | Finding:
        try:
            path = self.packages.resolve(shape.uri, self.folder)
        except ModelError as error:
            return finding_of(
                "GEO102", subject, f"its mesh {shape.uri!r} is not found", shape.place,
                value=shape.uri, fix=error.fix,
            )  # fmt: skip
        try:
            self.inputs[shape.uri] = _digest(path)
            points, volume, hull_volume = _hull_and_volumes(path)
        except Exception as error:  # noqa: BLE001 - each format's library has errors of its own
            reason = " ".join(f"{type(error).__name__}: {error}".split())[:120]
            return finding_of(
                "GEO103", subject, f"its mesh {shape.uri!r} cannot be read ({reason})",
                shape.place, value=shape.uri,
            )  # fmt: skip
        scale = np.array(shape.size)
        placed = (points * scale) @ shape.pose.R.T + shape.pose.p
        factor = float(abs(scale.prod()))
        return MeshBody(shape, placed, volume * factor, hull_volume * factor)


@lru_cache(maxsize=256)
def _digest(path: Path) -> str:
    return hashlib.sha256(read_regular(path)).hexdigest()


@lru_cache(maxsize=256)
def _hull_and_volumes(path: Path) -> tuple[Array, float, float]:
    """Corners of the convex hull, shape (k, 3), the volume of the solid, and that of the hull."""
    import trimesh

    if path.suffix.lower() not in _FORMATS:
        raise ValueError(f"{path.suffix or 'this'} is no mesh format that is read here")
    mesh: Any = trimesh.load_scene(path, skip_materials=True).to_mesh()
    points = np.asarray(getattr(mesh, "vertices", ()), dtype=np.float64)
    if len(points) < 4 or not np.isfinite(points).all() or not np.ptp(points, axis=0).all():
        raise ValueError("it encloses nothing")
    hull = mesh.convex_hull
    filled = abs(float(hull.volume))
    solid = abs(float(mesh.volume)) if mesh.is_watertight else filled
    return np.asarray(hull.vertices, dtype=np.float64), solid, filled
