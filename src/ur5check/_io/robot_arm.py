"""A `SerialArm` out of a `Robot`: the chain between two links, what is beside it held still."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Literal, NoReturn

import numpy as np

from .._errors import ModelError, UsageError
from .._finding import Place
from .._robot.inertia import Inertia
from .._robot.robot import Robot, RobotJoint
from .._robot.serial_arm import Joint, SerialArm, Source
from .._robot.transforms import Transform
from .arm_choice import choose_arm
from .chain_assembly import assemble
from .suggestions import did_you_mean
from .urdf.urdf_chain import Chain, Edge, Tree
from .world_body import chain_from_world

__all__ = ["RobotDescription", "arm_along", "arm_of_robot"]


def arm_of_robot(
    robot: Robot,
    *,
    base: str | None = None,
    tip: str | None = None,
    hold: Mapping[str, float] | None = None,
) -> SerialArm:
    """The arm between two links of a robot.

    base : default the root;  tip : default as `choose_arm` says, then the tool frame fixed there
    hold : positions of joints beside the arm [rad] or [m]; 0 where none is given

    Raises ModelError where the chain holds a joint or a link that no arm can have, or where several
    chains could be meant; UsageError for a joint in `hold` that is not there or is the arm's own.
    """
    description = RobotDescription(robot, hold)
    return arm_along(description, description.chain(base, tip))


def arm_along(description: RobotDescription, chain: Chain, *, strict: bool = True) -> SerialArm:
    """The arm along a chain of a robot.  Raises as `arm_of_robot` does.

    strict : refuse a moving tip without mass, and a moving mass without a tensor
    """
    robot = description.robot
    moving = frozenset(edge.joint for edge in chain.moving)
    description.check_unmodelled(chain)
    for name in description.hold:
        if name not in robot.joint or name in moving:
            beside = [
                joint.name for joint in robot.joints if joint.moves and joint.name not in moving
            ]
            what = "belongs to the arm" if name in moving else "is no joint of this robot"
            raise UsageError(f"--hold {name}: it {what}; {did_you_mean(name, beside)}")
    parts = assemble(description, chain, strict=strict)
    return SerialArm(
        robot.name,
        parts.joints,
        parts.links,
        base=parts.base,
        gravity=description.root_to(chain.base).R.T @ robot.gravity,
        source=Source(
            kind=robot.kind,
            inputs=robot.inputs,
            urdf=robot.urdf,
            base=chain.base,
            tip=chain.tip,
            held=description.held_beside(moving),
            notes=(*robot.notes, *parts.notes),
            robot=robot,
        ),
    )


class RobotDescription:
    """What `assemble` asks of a robot.

    hold : positions of joints that are not the arm's [rad] or [m]; 0 where none is given

    Raises ModelError for a robot without links.
    """

    def __init__(self, robot: Robot, hold: Mapping[str, float] | None = None) -> None:
        self.robot, self.hold = robot, dict(hold or {})
        if not robot.roots:
            raise ModelError("has no link", fix="an arm needs joints and links", file=robot.file)
        edges = [Edge(j.name, j.kind, j.parent, j.child) for j in robot.joints]
        root = max(robot.roots, key=lambda name: len(list(robot.down(name))))
        links = list(robot.down(root))
        here = set(links)
        self.tree = Tree(links, [e for e in edges if e.parent in here], robot.file)

    def chain(self, base: str | None, tip: str | None) -> Chain:
        """The chain from `base` (default: the root) to `tip` (default: as `choose_arm` says, then
        the tool frame fixed there).  Raises ModelError where none or several could be meant."""
        robot = self.robot
        for option, name in (("base", base), ("tip", tip)):
            if name is not None and name not in self.tree.below:
                fix = did_you_mean(name, self.tree.links)
                problem = "is no link of this robot"
                raise ModelError(problem, fix=fix, file=robot.file, element=option, value=name)
        notes: tuple[str, ...] = ()
        if tip is None:
            choice = choose_arm(robot, None if base is None else self._carrier(base))
            if choice.tip is None:
                self._several(choice.chains)
            tip = choice.tip
            rigid = [name for name in robot.rigid(tip) if not robot.below[name]]
            if len(rigid) == 1 and not choice.fingers:
                tip = rigid[0]
            elif len(rigid) > 1:
                shown = ", ".join(map(repr, rigid))
                notes = (
                    f"tip is {tip!r}, the last moving link: {len(rigid)} links end there ({shown})",
                )
            if choice.fingers:
                shown = ", ".join(map(repr, choice.fingers[:6]))
                shown += ", …" if choice.fingers[6:] else ""
                notes += (f"the arm ends before its gripper ({shown})",)
        in_world = robot.kind in ("mjcf", "sdf")
        chain = chain_from_world(self.tree, base, tip) if in_world else self.tree.chain(base, tip)
        return replace(chain, notes=notes)

    def _carrier(self, link: str) -> str:
        """The topmost link that a link is fixed to: a base may be a frame beside the arm."""
        for joint in self.robot.up(link):
            if joint.moves:
                break
            link = joint.parent
        return link

    def root_to(self, link: str) -> Transform:
        """The pose of a link in the root, joints on the way held still."""
        pose = Transform.identity()
        for joint in reversed(list(self.robot.up(link))):
            edge = Edge(joint.name, joint.kind, joint.parent, joint.child)
            pose = pose @ self.held_pose(edge, frozenset())
        return pose

    def joint(self, edge: Edge) -> Joint:
        joint = self.robot.joint[edge.joint]
        if joint.kind in ("planar", "floating", "ball"):
            problem = f"is {joint.kind}: neither revolute nor prismatic"
            fix = "choose base and tip so that it lies outside the arm"
            self.fail("joint", joint.name, "", problem, fix)
        if joint.mimic is not None:
            problem = f"mimics {joint.mimic.joint!r}: it has no coordinate of its own"
            self.fail("joint", joint.name, "", problem, "choose a tip before it, or remove <mimic>")
        numbers = [*joint.axis, *joint.origin.p]
        if not np.isfinite(numbers).all():
            self.fail("joint", joint.name, "", "its axis or origin is no number", "correct it")
        return Joint(
            joint.name,
            joint.axis,
            "prismatic" if joint.kind == "prismatic" else "revolute",
            joint.limits,
            joint.armature,
            _finite(joint.damping),
            _finite(joint.friction),
            joint.places,
        )

    def joint_origin(self, edge: Edge) -> Transform:
        return self.robot.joint[edge.joint].origin

    def carried(self, edge: Edge) -> Transform:
        return self.robot.joint[edge.joint].carried

    def held_pose(self, edge: Edge, moving: frozenset[str]) -> Transform:
        joint = self.robot.joint[edge.joint]
        value = self._held_at(joint, moving, ())
        motion = Transform.identity()
        if value != 0.0 and joint.kind in ("revolute", "continuous", "prismatic"):
            kind: Literal["revolute", "prismatic"] = (
                "prismatic" if joint.kind == "prismatic" else "revolute"
            )
            motion = Joint(joint.name, joint.axis, kind).motion(value)
        return joint.origin @ motion @ joint.carried

    def held_beside(self, moving: frozenset[str]) -> tuple[tuple[str, float], ...]:
        """Joints that are not the arm's and do not stand at zero, and where they are held."""
        beside = (j for j in self.robot.joints if j.moves and j.name not in moving)
        values = ((joint.name, self._held_at(joint, moving, ())) for joint in beside)
        return tuple((name, value) for name, value in values if value != 0.0)

    def _held_at(self, joint: RobotJoint, moving: frozenset[str], seen: tuple[str, ...]) -> float:
        """Where a joint beside the arm is held: as asked, as another joint has it, or at rest."""
        if joint.name in self.hold:
            return self.hold[joint.name]
        mimic = joint.mimic
        if mimic is None or joint.name in seen or mimic.joint not in self.robot.joint:
            return joint.rest
        if mimic.joint in moving:
            problem = f"moves with joint {mimic.joint!r} of the arm, beside it: no serial chain"
            self.fail("joint", joint.name, " mimic", problem, "choose the arm without this joint")
        followed = self._held_at(self.robot.joint[mimic.joint], moving, (*seen, joint.name))
        return mimic.multiplier * followed + mimic.offset

    def inertia(self, link: str) -> Inertia | None:
        if self.robot.link[link].between:
            return Inertia.zero()
        inertial = self.robot.link[link].inertial
        if inertial is None:
            return None
        if not inertial.readable:
            problem = "one of its numbers could not be read"
            self.fail("link", link, " inertial", problem, "correct it")
        return inertial.inertia

    def fail(
        self,
        tag: Literal["link", "joint"],
        name: str,
        part: str,
        problem: str,
        fix: str,
        rule: str = "XML100",
    ) -> NoReturn:
        place: Place = getattr(self.robot, tag)[name].place
        raise ModelError(
            problem,
            fix=fix,
            file=place.file,
            line=place.line or None,
            element=f"{tag} {name!r}{part}",
            rule=rule,
        )

    def check_unmodelled(self, chain: Chain) -> None:
        """Refuse what acts on a joint of the chain, or between two of its links."""
        moving = {edge.joint for edge in chain.moving}
        mover: dict[str, str] = {}
        for edge in chain.moving:
            mover[edge.child] = edge.joint
            for rigid in self.tree.rigid_group(edge.child, chain):
                mover[rigid.child] = edge.joint
        for one in self.robot.unmodelled:
            if one.joints & moving or len({mover.get(link, "") for link in one.links}) > 1:
                raise ModelError(
                    one.problem,
                    fix="choose --base and --tip so that it lies outside the arm, or remove it",
                    file=one.place.file,
                    line=one.place.line or None,
                    element=one.what,
                    rule="TRE106",
                )

    def _several(self, chains: tuple[tuple[str, int], ...]) -> NoReturn:
        if not chains:
            raise ModelError("has no moving joint", fix="an arm needs one", file=self.robot.file)
        listed = ", ".join(f"--tip {tip} ({n} joints)" for tip, n in chains[:6])
        more = f", and {len(chains) - 6} more" if len(chains) > 6 else ""
        raise ModelError(
            f"has {len(chains)} chains of moving joints, none of which is clearly the arm",
            fix=f"choose one: {listed}{more}",
            file=self.robot.file,
        )


def _finite(value: float) -> float:
    return value if np.isfinite(value) else 0.0
