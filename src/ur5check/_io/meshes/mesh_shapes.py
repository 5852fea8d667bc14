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
from ..._robot.transforms import Array
from ..chain_assembly import rigid_poses
from ..ros_packages import PackageMap, default_packages
from ..urdf.urdf_checks import check_urdf
from ..urdf.urdf_values import Robot
from ..xml.xml_numbers import Element, ElementReader
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
    root = check_urdf(arm.source.urdf.encode("utf-8"), file)
    robot = Robot(root, file)
    chain = robot.tree.chain(arm.source.base, arm.source.tip)
    nodes = {node.get("name"): node for node in root.iterchildren("link")}
    reader = _Reader(file, default_packages() if packages is None else packages)
    moving = frozenset(edge.joint for edge in chain.moving)
    links = []
    for edge in chain.moving:
        shapes: list[Shape] = []
        edges = robot.tree.rigid_group(edge.child, chain)
        for member, pose in rigid_poses(robot, edge.child, edges, moving).items():
            shapes += reader.shapes(nodes[member], pose)
        links.append(tuple(shapes))
    return Meshes(tuple(links), tuple(dict.fromkeys(reader.notes)))


class _Reader:
    """Reads the shapes of one file's links, and notes what it cannot."""

    def __init__(self, file: str, packages: PackageMap) -> None:
        self.numbers = ElementReader(file)
        self.folder = Path(file).parent
        self.packages = packages
        self.notes: list[str] = []

    def shapes(self, link: Element, pose: Transform) -> list[Shape]:
        """The shapes of one `<link>` whose frame stands at `pose`."""
        found = []
        for kind in _KINDS:
            for node in link.iterchildren(kind):
                subject = f"link {link.get('name')!r} {kind}"
                try:
                    found.append(self._shape(kind, node, subject, pose))
                except ModelError as error:
                    self.notes.append(str(error))
        return found

    def _shape(
        self,
        kind: Literal["collision", "visual"],
        node: Element,
        subject: str,
        pose: Transform,
    ) -> Shape:
        place = pose @ Transform.from_rpy(*self.numbers.origin(node, subject))
        geometry = self.numbers.child(node, "geometry", subject)
        solid = None if geometry is None else next(geometry.iterchildren("*"), None)
        if solid is None:
            self.numbers.fail(node, subject, "has no geometry", "write one, or remove it")
        scale = np.ones(3)
        if solid.tag == "mesh":
            name = solid.get("filename") or ""
            hull = _read(self.packages.resolve(name, self.folder), name)
            scale = np.array(self.numbers.triple(solid, "scale", subject, (1.0, 1.0, 1.0)))
        else:
            name, hull = solid.tag, hull_of(self._primitive(solid, subject))
        vertices = (hull.corners * scale) @ place.R.T + place.p
        return Shape(kind, name, vertices, hull.volume * float(abs(scale.prod())), hull.closed)

    def _primitive(self, solid: Element, subject: str) -> Any:
        from trimesh import creation

        if solid.tag == "box":
            return creation.box(self.numbers.triple(solid, "size", subject, None))
        if solid.tag not in ("cylinder", "sphere"):
            self.numbers.fail(solid, subject, f"<{solid.tag}> is no shape of URDF", "use a mesh")
        radius = self.numbers.number(solid, "radius", subject)
        if solid.tag == "sphere":
            return creation.icosphere(radius=float(radius))
        return creation.cylinder(
            float(radius), float(self.numbers.number(solid, "length", subject))
        )


def _read(path: Path, name: str) -> MeshHull:
    try:
        return read_hull(path)
    except Exception as error:  # each format's library has errors of its own
        problem = f"the mesh cannot be read: {type(error).__name__}: {error}"
        fix = f"export it again, as one of {', '.join(MESH_FORMATS)}"
        raise ModelError(problem, fix=fix, element=name) from error
