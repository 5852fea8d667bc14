"""A whole robot as the dynamics see it: its moving bodies over a parent list, on a fixed base.

Links that are fixed to a moving link are merged with it; those fixed to the root take no part.
A joint that mimics another has no coordinate of its own: it follows that of the other joint.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .._arguments import instance
from .._errors import ModelError, UsageError
from .inertia import Inertia
from .robot import Robot, RobotJoint, RobotLink
from .serial_arm import Joint, Link, SerialArm, Source
from .transforms import Array, Transform, frozen

__all__ = ["ArmOrTree", "RobotTree", "TreeLink", "tree_links"]


@dataclass(frozen=True, eq=False)
class TreeLink:
    """A moving link with all that is fixed to it, and the joint that moves it.

    parent : index of the link that carries the joint, -1 for the root
    origin : pose of the joint's frame in the parent's, at q_i = 0
    coordinate, multiplier, offset : q_i = multiplier · q[coordinate] + offset; not 1 and 0 where
        the joint mimics another
    """

    parent: int
    origin: Transform
    joint: Joint
    link: Link
    coordinate: int
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True, eq=False)
class RobotTree:
    """A fixed-base tree of n coordinates; immutable.

    Parameters
    ----------
    name : str
    links : tuple of TreeLink
        Each after its parent.
    joint_names : tuple of str, length n
        The joint of each coordinate.
    gravity : array, shape (3,)
        In the root's frame [m/s²].
    placements : mapping from a link's name to (index, Transform)
        The moving link that a link of the file belongs to (-1: the root), and its pose in it.
    source : Source
        Where it came from; its tip is the last moving link.

    Raises
    ------
    ModelError
        For a link before its parent, or a coordinate that is not one of the n.

    Examples
    --------
    >>> import ur5check
    >>> tree = ur5check.RobotTree.of(ur5check.load_robot("erd-ur5"))
    >>> tree.n, tree.joint_names[0]
    (6, 'shoulder_pan_joint')
    """

    name: str
    links: tuple[TreeLink, ...]
    joint_names: tuple[str, ...]
    gravity: Array
    placements: Mapping[str, tuple[int, Transform]] = field(default_factory=dict)
    source: Source = field(default_factory=Source)

    def __post_init__(self) -> None:
        object.__setattr__(self, "gravity", frozen(self.gravity, (3,), "gravity"))
        for i, link in enumerate(self.links):
            if not (-1 <= link.parent < i and 0 <= link.coordinate < self.n):
                raise ModelError(
                    f"link {i} has parent {link.parent} and coordinate {link.coordinate}",
                    fix=f"give a parent from -1 to {i - 1}, a coordinate from 0 to {self.n - 1}",
                    element=f"link {link.link.name!r}",
                )

    @classmethod
    def of(cls, robot: Robot) -> RobotTree:
        """The tree of a robot that `load_robot` read, joints depth first in the file's order.

        Parameters
        ----------
        robot : Robot

        Returns
        -------
        RobotTree

        Raises
        ------
        ModelError
            For a robot without a single root or a moving joint, for floating, planar and ball
            joints, numbers that could not be read, and a mimic joint without a source.
        """
        instance("robot", robot, Robot, "see ur5check.load_robot")
        for one in robot.unmodelled:
            raise _refused(one.what, one.place.file, one.place.line, one.problem)
        placements = {_root(robot): (-1, Transform.identity())}
        moved: list[tuple[int, Transform, RobotJoint]] = []
        bodies: list[list[Inertia]] = []
        stack = [*reversed(robot.below[_root(robot)])]
        while stack:
            joint = stack.pop()
            index, pose = placements[joint.parent]
            origin = pose @ joint.origin
            if joint.moves:
                moved.append((index, origin, joint))
                bodies.append([])
                index, pose = len(bodies) - 1, Transform.identity()
            else:
                pose = origin @ joint.carried
            placements[joint.child] = (index, pose)
            inertial = robot.link[joint.child].inertial
            if index >= 0 and inertial is not None:
                bodies[index].append(_inertia(robot.link[joint.child]).expressed_in(pose))
            stack += reversed(robot.below[joint.child])
        names = tuple(joint.name for *_, joint in moved if joint.mimic is None)
        if not names:
            raise ModelError("the robot has no moving joint", fix="give one", file=robot.file)
        links = []
        for (parent, origin, joint), inertias in zip(moved, bodies, strict=True):
            source, multiplier, offset = _followed(robot, joint)
            link = Link(joint.child, joint.carried, _sum(inertias))
            links.append(
                TreeLink(
                    parent, origin, _joint(joint), link, names.index(source), multiplier, offset
                )
            )
        read = Source(
            robot.kind, robot.inputs, robot.urdf, base=_root(robot), tip=links[-1].link.name
        )
        return cls(robot.name, tuple(links), names, robot.gravity, placements, read)

    @property
    def n(self) -> int:
        """Number of coordinates."""
        return len(self.joint_names)

    @property
    def label(self) -> str:
        """What reports call the robot."""
        return self.name

    @cached_property
    def followers(self) -> tuple[str, ...]:
        """Names of the joints that mimic another: those without a coordinate of their own."""
        own = frozenset(self.joint_names)
        return tuple(link.joint.name for link in self.links if link.joint.name not in own)

    @cached_property
    def unconstrained(self) -> RobotTree:
        """The same tree with a coordinate for each of its N joints, in the order of its links."""
        if not self.followers:
            return self
        links = tuple(
            replace(link, coordinate=i, multiplier=1.0, offset=0.0)
            for i, link in enumerate(self.links)
        )
        return replace(self, links=links, joint_names=tuple(link.joint.name for link in links))

    def with_inertias(self, inertias: Sequence[Inertia]) -> RobotTree:
        """The same tree with other inertias.

        Parameters
        ----------
        inertias : sequence of Inertia, length N
            One a moving link, each in its frame i.

        Returns
        -------
        RobotTree

        Raises
        ------
        UsageError
            For another number of inertias, or values of another type.
        """
        bodies = [instance("inertias", one, Inertia, "give ur5check.Inertia") for one in inertias]
        if len(bodies) != len(self.links):
            count = len(self.links)
            raise UsageError(f"{self.name!r} has {count} moving links; give {count} inertias")
        links = (
            replace(link, link=replace(link.link, inertia=inertia))
            for link, inertia in zip(self.links, bodies, strict=True)
        )
        return replace(self, links=tuple(links), source=self.source.as_value())

    def with_armature(self, armature: Sequence[float] | Array) -> RobotTree:
        """The same tree with other motor inertias.

        Parameters
        ----------
        armature : array-like, shape (N,)
            One a joint, reflected through the gear [kg m²]; [kg] for a prismatic joint.

        Returns
        -------
        RobotTree

        Raises
        ------
        ModelError
            For another shape, or entries that are not finite numbers.
        """
        values = frozen(armature, (len(self.links),), "armature").tolist()
        links = (
            replace(link, joint=replace(link.joint, armature=float(value)))
            for link, value in zip(self.links, values, strict=True)
        )
        return replace(self, links=tuple(links), source=self.source.as_value())

    def parameters(self) -> Array:
        """The inertial parameters π of all N moving links.

        Returns
        -------
        ndarray, shape (10 N,)
            `Inertia.parameters()` of each moving link, in its frame.
        """
        return np.concatenate([link.link.inertia.parameters() for link in self.links])

    def all_joints(self, q: NDArray[Any]) -> NDArray[Any]:
        """Positions of the N joints from the n coordinates.

        Parameters
        ----------
        q : ndarray, shape (n, states)
            [rad] or [m]

        Returns
        -------
        ndarray, shape (N, states)
            [rad] or [m]
        """
        offsets = np.array([link.offset for link in self.links])
        return np.asarray(self.all_rates(q) + offsets[:, None])

    def all_rates(self, qd: NDArray[Any]) -> NDArray[Any]:
        """Velocities or accelerations of the N joints from those of the n coordinates.

        Parameters
        ----------
        qd : ndarray, shape (n, states)
            [rad/s] or [m/s]; accelerations in [rad/s²] or [m/s²].

        Returns
        -------
        ndarray, shape (N, states)
            In the same units.
        """
        multipliers = np.array([link.multiplier for link in self.links])
        return np.asarray(multipliers[:, None] * qd[[link.coordinate for link in self.links]])


#: Whatever has moving links over a parent list.
ArmOrTree: TypeAlias = SerialArm | RobotTree


def tree_links(model: ArmOrTree) -> tuple[TreeLink, ...]:
    """The moving links of a tree; an arm is the tree in which each hangs on the one before."""
    if isinstance(model, RobotTree):
        return model.links
    return tuple(
        TreeLink(i - 1, Transform.identity() if i else model.base, joint, link, i)
        for i, (joint, link) in enumerate(zip(model.joints, model.links, strict=True))
    )


def _root(robot: Robot) -> str:
    """The only root, from which every link is reached."""
    roots = robot.roots
    if len(roots) != 1 or len(list(robot.down(roots[0]))) != len(robot.links):
        raise ModelError(
            f"the links form no tree with one root; roots: {', '.join(roots) or 'none'}",
            fix="connect every link by one chain of joints to one root",
            file=robot.file,
        )
    return roots[0]


def _sum(inertias: list[Inertia]) -> Inertia:
    total, *others = inertias or [Inertia.zero()]
    for other in others:
        total = total + other
    return total


def _inertia(link: RobotLink) -> Inertia:
    inertial = link.inertial
    if inertial is None or not inertial.readable:
        raise _refused(
            f"link {link.name!r}", link.place.file, link.place.line, "its inertia is not readable"
        )
    if inertial.mass != 0.0 and not inertial.tensor_known:
        place = link.place
        raise _refused(f"link {link.name!r}", place.file, place.line, "its tensor is unknown")
    return inertial.inertia


def _joint(joint: RobotJoint) -> Joint:
    where = f"joint {joint.name!r}", joint.place.file, joint.place.line
    if joint.kind not in ("revolute", "continuous", "prismatic"):
        raise _refused(*where, f"a {joint.kind} joint has no place in a tree on a fixed base")
    if not np.isfinite(joint.axis).all():
        raise _refused(*where, "its axis is not readable")
    return Joint(
        joint.name,
        joint.axis,
        "prismatic" if joint.kind == "prismatic" else "revolute",
        joint.limits,
        joint.armature,
        joint.damping,
        joint.friction,
    )


def _followed(robot: Robot, joint: RobotJoint) -> tuple[str, float, float]:
    """The joint whose coordinate a joint has, and q_joint = multiplier · q + offset."""
    multiplier, offset, source = 1.0, 0.0, joint
    seen = {joint.name}
    while source.mimic is not None:
        offset += multiplier * source.mimic.offset
        multiplier *= source.mimic.multiplier
        followed = robot.joint.get(source.mimic.joint)
        if followed is None or not followed.moves or followed.name in seen:
            raise _refused(
                f"joint {joint.name!r}",
                joint.place.file,
                joint.place.line,
                f"it mimics {source.mimic.joint!r}, which has no coordinate",
            )
        source = followed
        seen.add(source.name)
    return source.name, multiplier, offset


def _refused(element: str, file: str, line: int, problem: str) -> ModelError:
    fix = "correct the file: `ur5check validate` lists all its findings"
    return ModelError(problem, fix=fix, file=file, line=line or None, element=element)
