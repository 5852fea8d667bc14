"""The shapes of an arm's links in its URDF, with which plausibility compares masses and inertias.

Dynamics do not use shapes, so a shape that cannot be read is a note, not an error.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ..._errors import ModelError
from ..._robot import SerialArm, Transform
from ..._robot.robot import RobotLink, ShapeRef
from ..._robot.transforms import Array
from ..chain_assembly import rigid_poses
from ..ros_packages import PackageMap, default_packages
from ..urdf.urdf_reader import description_of_arm
from .mesh_hull import MESH_FORMATS, MeshHull, hull_of, read_hull

__all__ = ["Meshes", "Shape", "link_meshes"]

_KINDS: tuple[Literal["collision", "visual"], ...] = ("collision", "visual")


@dataclass(frozen=True, eq=False)
class Shape:
    """One shape of a link.

    kind : which of a URDF's two pictures of a link it belongs to
    name : the mesh's address as the URDF writes it, or "box", "cylinder", "sphere"
    vertices : corners of its convex hull in the link's source frame, shape (k, 3) [m]
    volume : of the solid; of its convex hull where the surface does not close [m³]
    closed : whether the surface closes
    """

    kind: Literal["collision", "visual"]
    name: str
    vertices: Array
    volume: float
    closed: bool

    @property
    def bounds(self) -> Array:
        """Smallest and largest coordinates, shape (2, 3) [m]."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])


@dataclass(frozen=True, eq=False)
class Meshes:
    """links : the shapes of link 1 … n, with those of all that is fixed to it
    notes : what could not be read, in sentences"""

    links: tuple[tuple[Shape, ...], ...]
    notes: tuple[str, ...] = ()


def link_meshes(arm: SerialArm, packages: PackageMap | None = None) -> Meshes:
    """The shapes of every link, each in the frame in which the URDF writes that link's numbers.

    packages : where package:// addresses lead (default: what is installed with this program)

    An arm that came from no URDF has no shapes.
    """
    if arm.source.urdf is None:
        return Meshes(((),) * arm.n)
    file = arm.source.inputs[0][0] if arm.source.inputs else arm.name
    description, findings = description_of_arm(arm, file)
    chain = description.tree.chain(arm.source.base, arm.source.tip)
    moving = frozenset(edge.joint for edge in chain.moving)
    reader = _Reader(Path(file).parent, default_packages() if packages is None else packages)
    links = []
    for edge in chain.moving:
        shapes: list[Shape] = []
        edges = description.tree.rigid_group(edge.child, chain)
        for member, pose in rigid_poses(description, edge.child, edges, moving).items():
            for kind in _KINDS:
                prefix = f"link {member!r} {kind}"
                reader.notes += [str(f) for f in findings if f.subject.startswith(prefix)]
            shapes += reader.shapes(description.robot.link[member], pose)
        links.append(tuple(shapes))
    return Meshes(tuple(links), tuple(dict.fromkeys(reader.notes)))


class _Reader:
    """Loads the shapes of links, and notes what it cannot."""

    def __init__(self, folder: Path, packages: PackageMap) -> None:
        self.folder, self.packages = folder, packages
        self.notes: list[str] = []

    def shapes(self, link: RobotLink, pose: Transform) -> list[Shape]:
        """The shapes of one link whose frame stands at `pose`."""
        found = []
        for kind in _KINDS:
            for shape in (shape for shape in link.shapes if shape.kind == kind):
                try:
                    found.append(self._shape(shape, pose))
                except ModelError as error:
                    self.notes.append(str(error))
        return found

    def _shape(self, shape: ShapeRef, pose: Transform) -> Shape:
        place, scale = pose @ shape.pose, np.ones(3)
        if shape.geometry == "mesh":
            name = shape.uri
            hull = _read(self.packages.resolve(name, self.folder), name)
            scale = np.array(shape.size)
        else:
            name, hull = shape.geometry, hull_of(_primitive(shape))
        vertices = (hull.corners * scale) @ place.R.T + place.p
        return Shape(
            shape.kind, name, vertices, hull.volume * float(abs(scale.prod())), hull.closed
        )


def _primitive(shape: ShapeRef) -> Any:
    from trimesh import creation

    if shape.geometry == "box":
        return creation.box(shape.size)
    if shape.geometry == "sphere":
        return creation.icosphere(radius=shape.size[0])
    if shape.geometry == "capsule":
        return creation.capsule(height=shape.size[1], radius=shape.size[0])
    return creation.cylinder(radius=shape.size[0], height=shape.size[1])


def _read(path: Path, name: str) -> MeshHull:
    try:
        return read_hull(path)
    except Exception as error:  # each format's library has errors of its own
        problem = f"the mesh cannot be read: {type(error).__name__}: {error}"
        fix = f"export it again, as one of {', '.join(MESH_FORMATS)}"
        raise ModelError(problem, fix=fix, element=name) from error
