"""The model that an engine has after reading: joints, bodies, gravity, tool.

Everything is expressed in the base frame with every joint at zero, which is available from all
engines, whichever link frames they use inside.  `_engines.audit.import_audit` compares it with
the arm, or the whole robot, as the file describes it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from operator import add

import numpy as np

from .._dynamics.kinematics import link_frames
from .._robot.inertia import Inertia
from .._robot.robot_tree import ArmOrTree, RobotTree, tree_links
from .._robot.serial_arm import Joint
from .._robot.transforms import Array, Transform

__all__ = [
    "ImportedBody",
    "ImportedModel",
    "frames_at_zero",
    "imported_arm",
    "moving_inertias",
    "strict_imported_model",
]


@dataclass(frozen=True, eq=False)
class ImportedBody:
    """One rigid body, or several that the engine has merged into one.

    carried_by : index of the joint that carries it; None for what is fixed to the base
    inertia : in the base frame at q = 0
    """

    name: str
    carried_by: int | None
    inertia: Inertia


@dataclass(frozen=True, eq=False)
class ImportedModel:
    """What an engine has imported.

    joints : in the engine's own order; `axis` in the base frame at q = 0.  A limit that the engine
        does not keep is None
    origins : of these joints, in the base frame at q = 0, shape (joints, 3) [m]
    bodies : every body that the engine keeps, massless ones too
    gravity : the engine's default, in the base frame [m/s²]
    tool : pose of the tool (of a tree: of its last moving link) in the base frame at q = 0, (4, 4)
    coordinates : how many position coordinates the engine uses for the joints
    warnings : the engine's own, captured while it read the model
    """

    joints: tuple[Joint, ...]
    origins: Array
    bodies: tuple[ImportedBody, ...]
    gravity: Array
    tool: Array
    coordinates: int
    warnings: tuple[str, ...] = ()


def frames_at_zero(model: ArmOrTree) -> list[Transform]:
    """Pose of each moving link's frame in the base frame, all joints at zero."""
    free = model.unconstrained if isinstance(model, RobotTree) else model
    return [Transform.from_matrix(T) for T in link_frames(free, np.zeros(free.n))]


def moving_inertias(imported_model: ImportedModel, arm: ArmOrTree) -> list[Inertia]:
    """Per joint, all bodies that it carries in the engine, as one inertia in frame i."""
    groups = []
    for i, T_0i in enumerate(frames_at_zero(arm)):
        carried = [body.inertia for body in imported_model.bodies if body.carried_by == i]
        total = reduce(add, carried, Inertia.zero())
        groups.append(total.expressed_in(T_0i.inverse()))
    return groups


def imported_arm(imported_model: ImportedModel, arm: ArmOrTree) -> ArmOrTree:
    """The arm as the engine has it: the file's geometry, the engine's bodies and motor inertias.

    If an engine's torques equal those of the recursion for *this* arm, then the import explains
    every difference from the arm as it is written.
    """
    motors = {joint.name: joint.armature for joint in imported_model.joints}
    imported_arm = arm.with_inertias(moving_inertias(imported_model, arm))
    names = (link.joint.name for link in tree_links(arm))
    return imported_arm.with_armature([motors.get(name, 0.0) for name in names])


def strict_imported_model(arm: ArmOrTree, base: Sequence[ImportedBody] = ()) -> ImportedModel:
    """An arm or a tree itself as an imported model, one body per joint."""
    frames = frames_at_zero(arm)
    joints, origins, bodies = [], [], list(base)
    for i, each in enumerate(tree_links(arm)):
        placed = frames[each.parent] @ each.origin if each.parent >= 0 else each.origin
        joints.append(replace(each.joint, axis=placed.R @ each.joint.axis))
        origins.append(placed.p)
        bodies.append(ImportedBody(each.link.name, i, each.link.inertia.expressed_in(frames[i])))
    return ImportedModel(
        tuple(joints),
        np.array(origins),
        tuple(bodies),
        arm.gravity,
        frames[-1].matrix(),
        len(joints),
    )
