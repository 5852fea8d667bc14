"""The numbers of a strictly checked URDF: poses, joints, inertias."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NoReturn

import numpy as np

from ..._finding import Place
from ..._robot import Inertia, Joint, Limits, Transform
from ..inertia_checks import printed_tensor
from ..xml.xml_numbers import Element, ElementReader
from .urdf_chain import Edge, Tree
from .urdf_checks import ENTRIES

__all__ = ["Robot"]

_X = (1.0, 0.0, 0.0)  # URDF: a joint without <axis> moves about or along x


@dataclass(frozen=True)
class _Mimic:
    joint: str
    multiplier: float
    offset: float


class Robot:
    """The tree of a checked file, and the values of its links and joints.

    root : what `check_urdf` returned, so elements and numbers that it requires are there
    lines : whether the text is the file itself, so that its lines are those of the file
    """

    def __init__(self, root: Element, file: str, *, lines: bool = True) -> None:
        self._file, self._lines = file, lines
        self.name = str(root.get("name"))
        self._reader = ElementReader(file)
        self._nodes: dict[str, dict[str, Element]] = {
            tag: {node.get("name"): node for node in root.iterchildren(tag)}
            for tag in ("link", "joint")
        }
        edges = [
            Edge(
                name, joint.get("type"), joint.find("parent").get("link"),
                joint.find("child").get("link"),
            )
            for name, joint in self._nodes["joint"].items()
        ]  # fmt: skip
        self.tree = Tree(list(self._nodes["link"]), edges, file)

    def fail(
        self, tag: Literal["link", "joint"], name: str, part: str, problem: str, fix: str
    ) -> NoReturn:
        """Raise ModelError at a link or joint; part : " inertial/mass", or ""."""
        self._reader.fail(self._nodes[tag][name], f"{tag} {name!r}{part}", problem, fix)

    def mimicked(self, joint: str) -> str | None:
        """The joint that this one mimics, or None."""
        mimic = self._mimic(joint)
        return None if mimic is None else mimic.joint

    def joint_origin(self, edge: Edge) -> Transform:
        """Pose of the child's frame in the parent's, at q = 0."""
        return self._pose(self._nodes["joint"][edge.joint])

    def carried(self, edge: Edge) -> Transform:
        """A URDF's link has its frame where its joint is."""
        return Transform.identity()

    def joint(self, edge: Edge) -> Joint:
        """Axis, limits, damping and friction of a joint."""
        node, bounded = self._nodes["joint"][edge.joint], edge.kind != "continuous"
        axis, limit, losses = node.find("axis"), node.find("limit"), node.find("dynamics")
        limits = Limits()
        if limit is not None:
            # URDF: a bound left out is 0, and a continuous joint has none.
            limits = Limits(
                lower=(self._optional(limit, "lower") or 0.0) if bounded else None,
                upper=(self._optional(limit, "upper") or 0.0) if bounded else None,
                velocity=self._optional(limit, "velocity"),
                effort=self._optional(limit, "effort"),
            )
        kind: Literal["revolute", "prismatic"] = (
            "prismatic" if edge.kind == "prismatic" else "revolute"
        )
        return Joint(
            edge.joint,
            np.array(_X if axis is None else self._reader.triple(axis, "xyz", "", _X)),
            kind,
            limits,
            damping=self._optional(losses, "damping") or 0.0,  # URDF: left out, they are 0
            friction=self._optional(losses, "friction") or 0.0,
            places={
                tag: Place(self._file, node.sourceline, 0, f"joint {edge.joint!r} {tag}")
                for tag, node in (("limit", limit), ("dynamics", losses))
                if node is not None and self._lines
            },
        )

    def inertia(self, link: str) -> Inertia | None:
        """A link's own inertia, in the link's frame; None where it has no `<inertial>`."""
        inertial = self._nodes["link"][link].find("inertial")
        if inertial is None:
            return None
        mass = self._reader.number(inertial.find("mass"), "value", "")
        moments = inertial.find("inertia")
        tensor, _ = printed_tensor(
            {entry: self._reader.number(moments, entry, "") for entry in ENTRIES}
        )
        return Inertia(float(mass), np.zeros(3), tensor).expressed_in(self._pose(inertial))

    def held_pose(self, edge: Edge, moving: frozenset[str]) -> Transform:
        """Pose of the child of a joint that is fixed, or held still because it is not among the
        chain's `moving` ones: at zero, or where its `<mimic>` then puts it."""
        value = self._held_at(edge.joint, moving, frozenset())
        pose = self.joint_origin(edge)
        return pose if value == 0.0 else pose @ self.joint(edge).motion(value)

    def _held_at(self, name: str, moving: frozenset[str], followers: frozenset[str]) -> float:
        mimic = self._mimic(name)
        if mimic is None:
            return 0.0
        if mimic.joint in moving:
            problem = f"moves with joint {mimic.joint!r} of the arm, beside it: no serial chain"
            self.fail("joint", name, " mimic", problem, "describe the arm without this joint")
        if name in followers:
            self.fail("joint", name, " mimic", "leads round in a circle", "remove one <mimic>")
        followed = self._held_at(mimic.joint, moving, followers | {name})
        return float(mimic.multiplier * followed + mimic.offset)

    def _mimic(self, joint: str) -> _Mimic | None:
        node = self._nodes["joint"][joint].find("mimic")
        if node is None:
            return None
        multiplier, offset = self._optional(node, "multiplier"), self._optional(node, "offset")
        return _Mimic(node.get("joint"), 1.0 if multiplier is None else multiplier, offset or 0.0)

    def _pose(self, node: Element) -> Transform:
        """The pose that a node's `<origin>` gives."""
        return Transform.from_rpy(*self._reader.origin(node, ""))

    def _optional(self, node: Element | None, attribute: str) -> float | None:
        """A number that was checked already; None where it is left out."""
        value = None if node is None else self._reader.optional_number(node, attribute, "")
        return None if value is None else float(value)
