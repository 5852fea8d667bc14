"""A robot: what a description says, whole, before any arm is taken from it.

Numbers stand as the file gives them, in its own frames, and each part knows where it is written.
A number that could not be read is nan or None, and the reader has a finding about it: a robot
may be faulty in one place and sound in all others.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np

from .._finding import Place
from .inertia import Inertia
from .pseudo_inertia import BodyTest, DigitBounds, judge_body
from .serial_arm import Limits
from .transforms import Array, Transform

__all__ = [
    "ENTRIES",
    "Inertial",
    "JointKind",
    "Mimic",
    "Robot",
    "RobotJoint",
    "RobotLink",
    "ShapeRef",
    "Unmodelled",
]

JointKind = Literal["revolute", "continuous", "prismatic", "fixed", "floating", "planar", "ball"]

#: The entries of an inertia tensor that a file lists.
ENTRIES = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


@dataclass(frozen=True, eq=False)
class Inertial:
    """What a file says of one body's inertia.

    mass : [kg];  xyz : centre of mass in the link's frame, shape (3,) [m]
    rpy : of the axes along which the entries are given, shape (3,) [rad]
    entries : ixx … izz about the centre of mass, along these axes [kg m²]; none where the file
        leaves the tensor open
    rounding : half a unit of the last digit that each entry prints [kg m²]; empty where the numbers
        were computed, not printed: machine precision then
    places : where "mass", "origin", "inertia" and single entries are written
    """

    mass: float
    xyz: Array
    rpy: Array
    entries: Mapping[str, float]
    rounding: Mapping[str, float] = field(default_factory=dict)
    places: Mapping[str, Place] = field(default_factory=dict)

    @cached_property
    def own_tensor(self) -> Array:
        """About the centre of mass, along the inertial's own axes, shape (3, 3) [kg m²]."""
        e = self.entries
        return np.array(
            [
                [e["ixx"], e["ixy"], e["ixz"]],
                [e["ixy"], e["iyy"], e["iyz"]],
                [e["ixz"], e["iyz"], e["izz"]],
            ]
        )

    @cached_property
    def digits(self) -> DigitBounds:
        """What the printed digits of the entries leave open."""
        names = (("ixx", "ixy", "ixz"), ("ixy", "iyy", "iyz"), ("ixz", "iyz", "izz"))
        H = np.array([[self.rounding.get(name, 0.0) for name in row] for row in names])
        return DigitBounds.of(H)

    @cached_property
    def judged(self) -> BodyTest:
        """Whether a body can have it.  Only of a `readable` one."""
        return judge_body(self.mass, self.own_tensor, self.digits)

    @property
    def tensor_known(self) -> bool:
        """Whether the file says anything of the tensor."""
        return bool(self.entries)

    @cached_property
    def readable(self) -> bool:
        """Whether every number could be read and is finite."""
        numbers = [self.mass, *self.xyz, *self.rpy, *self.entries.values()]
        return len(self.entries) == len(ENTRIES) and bool(np.isfinite(numbers).all())

    @cached_property
    def inertia(self) -> Inertia:
        """In the link's frame.  Only of a `readable` one."""
        own = Inertia(self.mass, np.zeros(3), self.own_tensor, self.digits)
        return own.expressed_in(Transform.from_rpy(self.xyz.tolist(), self.rpy.tolist()))

    def place(self, part: str) -> Place:
        """Where a part is written; where the whole is, if that is not known."""
        return self.places.get(part, self.places.get("inertial", Place()))


@dataclass(frozen=True, eq=False)
class ShapeRef:
    """A shape of a link, not yet loaded.

    kind : which of the two pictures of a link it belongs to
    geometry : "box", "cylinder", "sphere", "capsule" or "mesh"
    size : box: three edges; cylinder, capsule: radius, length; sphere: radius [m]; mesh: scale
    pose : in the link's frame;  uri : of a mesh, as written
    """

    kind: Literal["collision", "visual"]
    geometry: str
    size: tuple[float, ...]
    pose: Transform
    uri: str = ""
    place: Place = field(default_factory=Place)


@dataclass(frozen=True, eq=False)
class RobotLink:
    """A link.

    inertial : None where the file gives none
    between : whether it only stands between two joints of one body, as MJCF writes them
    """

    name: str
    inertial: Inertial | None
    shapes: tuple[ShapeRef, ...] = ()
    place: Place = field(default_factory=Place)
    between: bool = False


@dataclass(frozen=True)
class Mimic:
    """q = multiplier · q_of(joint) + offset"""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True, eq=False)
class RobotJoint:
    """A joint.

    origin : pose of the joint's frame in the parent link's, at q = 0
    axis : unit vector in the joint's frame, shape (3,); written_axis : as the file has it
    carried : pose of the child's frame seen from the joint's moving side (identity in a URDF)
    rest : position in the posture that the file describes [rad] or [m]
    rpy : the origin's angles as written, shape (3,) [rad]
    places : where "origin", "axis", "limit", "dynamics", "mimic" and single attributes are written
    """

    name: str
    kind: JointKind
    parent: str
    child: str
    origin: Transform
    axis: Array
    written_axis: Array
    limits: Limits = field(default_factory=Limits)
    carried: Transform = field(default_factory=Transform.identity)
    rpy: Array = field(default_factory=lambda: np.zeros(3))
    damping: float = 0.0
    friction: float = 0.0
    armature: float = 0.0
    mimic: Mimic | None = None
    rest: float = 0.0
    place: Place = field(default_factory=Place)
    places: Mapping[str, Place] = field(default_factory=dict)

    @property
    def moves(self) -> bool:
        """Whether it has a coordinate at all, its own or another joint's."""
        return self.kind != "fixed"

    def at(self, part: str) -> Place:
        """Where a part is written; where the joint is, if that is not known."""
        return self.places.get(part, self.place)


@dataclass(frozen=True, eq=False)
class Unmodelled:
    """What acts on the robot beside joints, weight and drives, and is in no torque computed here.

    what : "equality 'weld'", "tendon 't'", "joint 'elbow' stiffness";  problem : as a clause
    joints, links : on whose motion it acts: on a joint, or between the links
    """

    what: str
    problem: str
    joints: frozenset[str] = frozenset()
    links: frozenset[str] = frozenset()
    place: Place = field(default_factory=Place)


@dataclass(frozen=True, eq=False)
class Robot:
    """A whole description, as the file gives it; `load_robot` reads one.

    Attributes
    ----------
    name : str
    links : tuple of RobotLink
    joints : tuple of RobotJoint
        Those whose parent and child exist, each child once: a forest.
    kind : str
        "urdf", "xacro", "mjcf", "sdf" or "dh".
    file : str
        As the user gave it.
    gravity : ndarray, shape (3,)
        In the root's frame [m/s²].
    inputs : tuple of (str, str)
        Name and SHA-256 of every file that was read.
    urdf : str or None
        The URDF's text, after xacro expansion, for engines that bring their own parser.
    unmodelled : tuple of Unmodelled
        What acts on it beside its joints, weight and drives.
    notes : tuple of str
        Remarks of the reader for reports.
    """

    name: str
    links: tuple[RobotLink, ...]
    joints: tuple[RobotJoint, ...]
    kind: str
    file: str
    gravity: Array
    inputs: tuple[tuple[str, str], ...] = ()
    urdf: str | None = None
    unmodelled: tuple[Unmodelled, ...] = ()
    notes: tuple[str, ...] = ()

    @cached_property
    def link(self) -> Mapping[str, RobotLink]:
        """Links by name."""
        return {link.name: link for link in self.links}

    @cached_property
    def joint(self) -> Mapping[str, RobotJoint]:
        """Joints by name."""
        return {joint.name: joint for joint in self.joints}

    @cached_property
    def above(self) -> Mapping[str, RobotJoint]:
        """The joint that carries each link but the roots."""
        return {joint.child: joint for joint in self.joints}

    @cached_property
    def below(self) -> Mapping[str, tuple[RobotJoint, ...]]:
        """The joints that each link carries."""
        found: dict[str, list[RobotJoint]] = {link.name: [] for link in self.links}
        for joint in self.joints:
            found[joint.parent].append(joint)
        return {name: tuple(joints) for name, joints in found.items()}

    @cached_property
    def roots(self) -> tuple[str, ...]:
        """Links that no joint carries."""
        return tuple(link.name for link in self.links if link.name not in self.above)

    def up(self, link: str) -> Iterator[RobotJoint]:
        """The joints from a link to its root.

        Parameters
        ----------
        link : str

        Yields
        ------
        RobotJoint
            The link's own joint first.
        """
        while link in self.above:
            joint = self.above[link]
            yield joint
            link = joint.parent

    def down(self, link: str) -> Iterator[str]:
        """A link and all that it carries, parents first.

        Parameters
        ----------
        link : str

        Yields
        ------
        str
            Names of links.
        """
        reached = [link]
        for name in reached:
            yield name
            reached += [joint.child for joint in self.below[name]]

    def rigid(self, link: str) -> dict[str, Transform]:
        """A link and all links that are fixed to it.

        Parameters
        ----------
        link : str

        Returns
        -------
        dict of str to Transform
            The pose of each in the frame of `link`.
        """
        poses = {link: Transform.identity()}
        for name in list(self._rigid_order(link))[1:]:
            joint = self.above[name]
            poses[name] = poses[joint.parent] @ joint.origin @ joint.carried
        return poses

    def _rigid_order(self, link: str) -> Iterator[str]:
        reached = [link]
        for name in reached:
            yield name
            reached += [joint.child for joint in self.below[name] if not joint.moves]

    @cached_property
    def depth(self) -> int:
        """The most joints between a root and a link."""
        depth: dict[str, int] = {}
        for root in self.roots:
            for name in self.down(root):
                above = self.above.get(name)
                depth[name] = 0 if above is None else depth[above.parent] + 1
        return max(depth.values(), default=0)

    @cached_property
    def mass(self) -> float:
        """Mass of all links, without those whose mass could not be read [kg]."""
        masses = [link.inertial.mass for link in self.links if link.inertial is not None]
        return float(np.nansum(masses)) if masses else 0.0
