"""What rules look at: a robot, with sizes and shapes that several rules need, computed once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property

import numpy as np

from .._finding import Finding
from .._robot.robot import Inertial, Robot, RobotLink, ShapeRef
from .._robot.serial_arm import SerialArm
from .body_extent import Body, Extent, PrimitiveBody

__all__ = ["RuleSubject"]

#: Reads a mesh: a body, or a finding that says why there is none.
MeshReader = Callable[[ShapeRef, str], "Body | Finding"]

#: No link of a robot is taken for smaller than this [m].
_SMALLEST = 0.05
#: A link without length (a wrist, a spherical shoulder) is taken for this part of the reach.
_PART_OF_REACH = 0.15
#: Where nothing says how large a part is, it may have this length [m].
_UNKNOWN = 1.0


class RuleSubject:
    """A robot under examination.

    arm : the arm in it, None where there is none
    meshes : reads the mesh of a shape of a link; None leaves meshes aside
    payload : mass held at the tip [kg];  expected_mass : of the whole robot [kg], None if unknown
    """

    def __init__(
        self,
        robot: Robot,
        meshes: MeshReader | None = None,
        *,
        arm: SerialArm | None = None,
        payload: float = 0.0,
        expected_mass: float | None = None,
    ) -> None:
        self.robot = robot
        self.arm = arm
        self.payload = payload
        self.expected_mass = expected_mass
        self._meshes = meshes
        self._extents: dict[str, Extent | None] = {}
        self.mesh_findings: list[Finding] = []

    @cached_property
    def bodies(self) -> tuple[tuple[RobotLink, Inertial], ...]:
        """Links whose inertial could be read, in the file's order."""
        return tuple(
            (link, link.inertial)
            for link in self.robot.links
            if link.inertial is not None and link.inertial.readable
        )

    @cached_property
    def moving(self) -> frozenset[str]:
        """Links that some moving joint carries, directly or not."""
        found = set()
        for root in self.robot.roots:
            for name in self.robot.down(root):
                joint = self.robot.above.get(name)
                if joint is not None and (joint.moves or joint.parent in found):
                    found.add(name)
        return frozenset(found)

    @cached_property
    def reach(self) -> float:
        """The longest way along joints to a leaf, sliding joints drawn out [m].

        It begins at the first moving joint: where the robot stands says nothing of its size.
        """
        length: dict[str, float] = {}
        for root in self.robot.roots:
            for name in self.robot.down(root):
                joint = self.robot.above.get(name)
                if joint is None or name not in self.moving or joint.parent not in self.moving:
                    length[name] = 0.0
                    continue
                step = float(np.linalg.norm(joint.origin.p) + np.linalg.norm(joint.carried.p))
                if joint.kind == "prismatic":
                    stroke = max(abs(joint.limits.lower or 0.0), abs(joint.limits.upper or 0.0))
                    step += stroke if np.isfinite(stroke) else 0.0
                length[name] = length[joint.parent] + step
        return max(length.values(), default=0.0)

    @cached_property
    def _own_length(self) -> Mapping[str, float]:
        """How far each moving link reaches: to its frame, and on to what it carries."""
        lengths = dict.fromkeys((link.name for link in self.robot.links), 0.0)
        for name in self.moving:
            before = float(np.linalg.norm(self.robot.above[name].carried.p))
            lengths[name] = max(before, self._beyond(name))
        return lengths

    def _beyond(self, link: str) -> float:
        """How far from a link's frame the joints lie that it carries [m]."""
        return max((float(np.linalg.norm(x.origin.p)) for x in self.robot.below[link]), default=0.0)

    def length(self, link: str) -> float:
        """A link's length from joint to joint, at least what such links have in this robot [m].

        A link that carries nothing ends where its file does not say: twice as far out as its centre
        of mass, but not beyond the robot's own size, or a metre where that is unknown.
        """
        length = max(self._own_length[link], _PART_OF_REACH * self.reach, _SMALLEST)
        inertial = self.robot.link[link].inertial
        if inertial is None or not inertial.readable or any(self.robot.below[link]):
            return length
        out = 2.0 * float(np.linalg.norm(inertial.xyz))
        return max(length, min(out, max(self.reach, _UNKNOWN)))

    def longest(self, link: str) -> float:
        """What a link's length may be at most, where no shape says it [m].

        A moving link may lie between its joint and the one before, as a forearm does whose joint
        is drawn at the wrist.  What stands may be as large as the robot: a column, a cabinet, a
        body with legs.
        """
        length = self.length(link)
        if link in self.moving:
            return max(length, float(np.linalg.norm(self.robot.above[link].origin.p)))
        return max(length, self._beyond(link), self.reach, _UNKNOWN)

    def extent(self, link: str) -> Extent | None:
        """The shapes of a link itself, not of what is fixed to it; None where it has none.

        A mesh that cannot be read leaves the link without an extent: the rest of its shapes might
        not enclose it.  What keeps it from being read is in `mesh_findings`.
        """
        if link not in self._extents:
            self._extents[link] = self._read_extent(self.robot.link[link])
        return self._extents[link]

    def _read_extent(self, link: RobotLink) -> Extent | None:
        bodies: list[Body] = []
        complete = True
        for shape in link.shapes:
            if shape.geometry != "mesh":
                bodies.append(PrimitiveBody(shape))
                continue
            read = None if self._meshes is None else self._meshes(shape, f"link {link.name!r}")
            if isinstance(read, Finding):
                self.mesh_findings.append(read)
            if read is None or isinstance(read, Finding):
                complete = False
            else:
                bodies.append(read)
        return Extent(bodies) if bodies and complete else None
