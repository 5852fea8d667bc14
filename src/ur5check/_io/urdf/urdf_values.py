"""The numbers of a strictly checked URDF: poses, joints, inertias, each where the text has it."""

from __future__ import annotations

import io
from typing import Any, Literal, NoReturn

import numpy as np
from lxml import etree

from ..._errors import ModelError
from ..._robot import Inertia, Joint, Limits, Transform
from ..xml.xml_numbers import Element, ElementReader
from .urdf_chain import Edge, Tree

__all__ = ["Robot"]

# What bears on dynamics.  Shapes and pictures are left out: a broken mesh is no fault of the
# dynamics, and nothing is to be fetched for it.
_KEPT = {
    "link": ("inertial",),
    "joint": ("origin", "axis", "parent", "child", "limit", "dynamics", "mimic"),
}


class Robot:
    """yourdfpy's reading of a file, the checked XML that says on which line things stand, and the
    tree of both.

    root : what `check_urdf` returned
    """

    def __init__(self, root: Element, file: str) -> None:
        parsed = _parsed(root, file)
        self.name: str = parsed.name
        self.tree = Tree(
            [link.name for link in parsed.links],
            [Edge(joint.name, joint.type, joint.parent, joint.child) for joint in parsed.joints],
            file,
        )
        self._joints = {joint.name: joint for joint in parsed.joints}
        self._inertials = {link.name: link.inertial for link in parsed.links}
        self._reader = ElementReader(file)
        self._nodes = {
            tag: {node.get("name"): node for node in root.iterchildren(tag)} for tag in _KEPT
        }

    def fail(
        self, tag: Literal["link", "joint"], name: str, part: str, problem: str, fix: str
    ) -> NoReturn:
        """Raise ModelError at a link or joint; part : " inertial/mass", or ""."""
        self._reader.fail(self._nodes[tag][name], f"{tag} {name!r}{part}", problem, fix)

    def mimicked(self, joint: str) -> str | None:
        """The joint that this one copies, if it does."""
        mimic = self._joints[joint].mimic
        return None if mimic is None else str(mimic.joint)

    def joint_origin(self, edge: Edge) -> Transform:
        """Pose of the child's frame in the parent's, at q = 0."""
        return self._pose(self._nodes["joint"][edge.joint], self._joints[edge.joint].origin)

    def carried(self, edge: Edge) -> Transform:
        """A URDF's link has its frame where its joint is."""
        return Transform.identity()

    def joint(self, edge: Edge) -> Joint:
        parsed = self._joints[edge.joint]
        limit, bounded = parsed.limit, edge.kind != "continuous"
        limits = Limits()
        if limit is not None:
            # URDF: a bound left out is 0, and a continuous joint has none.
            limits = Limits(
                lower=(limit.lower or 0.0) if bounded else None,
                upper=(limit.upper or 0.0) if bounded else None,
                velocity=limit.velocity,
                effort=limit.effort,
            )
        kind: Literal["revolute", "prismatic"] = (
            "prismatic" if edge.kind == "prismatic" else "revolute"
        )
        losses = parsed.dynamics
        return Joint(
            parsed.name,
            parsed.axis,
            kind,
            limits,
            damping=float((losses and losses.damping) or 0.0),  # URDF: left out, they are 0
            friction=float((losses and losses.friction) or 0.0),
        )

    def inertia(self, link: str) -> Inertia | None:
        """A link's own inertia, in the link's frame; None where it has no `<inertial>`."""
        inertial = self._inertials[link]
        if inertial is None:
            return None
        pose = self._pose(self._nodes["link"][link].find("inertial"), inertial.origin)
        own = Inertia(inertial.mass, np.zeros(3), inertial.inertia)
        return own.expressed_in(pose)

    def held_pose(self, edge: Edge, moving: frozenset[str]) -> Transform:
        """Pose of the child of a joint that is fixed, or held still because it is not among the
        chain's `moving` ones: at zero, or where its `<mimic>` then puts it."""
        value = self._held_at(edge.joint, moving, frozenset())
        pose = self.joint_origin(edge)
        return pose if value == 0.0 else pose @ self.joint(edge).motion(value)

    def _held_at(self, name: str, moving: frozenset[str], followers: frozenset[str]) -> float:
        mimic = self._joints[name].mimic
        if mimic is None:
            return 0.0
        if mimic.joint in moving:
            problem = f"moves with joint {mimic.joint!r} of the arm, beside it: no serial chain"
            self.fail("joint", name, " mimic", problem, "describe the arm without this joint")
        if name in followers:
            self.fail("joint", name, " mimic", "leads round in a circle", "remove one <mimic>")
        followed = self._held_at(mimic.joint, moving, followers | {name})
        return float(mimic.multiplier * followed + mimic.offset)

    def _pose(self, node: Element, parsed: Any) -> Transform:
        """The pose that a node's `<origin>` gives.

        yourdfpy keeps it as a matrix, in which a quarter turn has 6e-17 where a zero belongs.  So
        its translation is taken, and the rotation is made from the rpy of the checked text.
        """
        if parsed is None:
            return Transform.identity()
        _, rpy = self._reader.origin(node, "")
        return Transform.from_rpy(parsed[:3, 3], rpy)


def _parsed(root: Element, file: str) -> Any:
    """The robot, as yourdfpy has it, of the part of the file that bears on dynamics."""
    from yourdfpy import URDF  # imports trimesh: a second and a half that only this reading pays

    bare = etree.Element("robot", name=root.get("name"))
    for element in root.iterchildren(*_KEPT):
        kept = etree.SubElement(bare, element.tag, dict(element.attrib))
        for part in element.iterchildren(*_KEPT[element.tag]):
            kept.append(etree.fromstring(etree.tostring(part, with_tail=False)))
    try:
        return URDF.load(
            io.BytesIO(etree.tostring(bare)),
            build_scene_graph=False,
            load_meshes=False,
            build_collision_scene_graph=False,
            load_collision_meshes=False,
        ).robot
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        problem = f"yourdfpy cannot read it: {error}"
        raise ModelError(problem, fix="simplify the file", file=file) from error
