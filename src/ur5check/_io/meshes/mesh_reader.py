"""Meshes of a robot's links, for the rules that compare a body with its shape."""

from __future__ import annotations

import hashlib
from functools import lru_cache
from pathlib import Path

import numpy as np

from ..._errors import ModelError
from ..._files import read_regular
from ..._finding import Finding
from ..._robot.robot import ShapeRef
from ..._rules.body_extent import MeshBody
from ..._rules.finding_log import finding_of
from ..ros_packages import PackageMap
from .mesh_hull import read_hull

__all__ = ["MeshReader"]


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
            hull = read_hull(path)
        except Exception as error:  # noqa: BLE001 - each format's library has errors of its own
            reason = " ".join(f"{type(error).__name__}: {error}".split())[:120]
            return finding_of(
                "GEO103", subject, f"its mesh {shape.uri!r} cannot be read ({reason})",
                shape.place, value=shape.uri,
            )  # fmt: skip
        scale = np.array(shape.size)
        placed = (hull.corners * scale) @ shape.pose.R.T + shape.pose.p
        factor = float(abs(scale.prod()))
        return MeshBody(shape, placed, hull.volume * factor, hull.hull_volume * factor)


def _digest(path: Path) -> str:
    state = path.stat()
    return _digest_of(path, state.st_mtime_ns, state.st_size)


@lru_cache(maxsize=4096)
def _digest_of(path: Path, changed: int, size: int) -> str:
    return hashlib.sha256(read_regular(path)).hexdigest()
