"""The model that an engine has after reading: joints, bodies, gravity, tool.

Everything is expressed in the arm's base frame with every joint at zero, which is available from
all engines, whichever link frames they use inside.  `_engines.audit.import_audit` compares it with
the arm as the file describes it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from operator import add

import numpy as np

from .._dynamics.kinematics import link_frames
from .._robot.inertia import Inertia
from .._robot.serial_arm import Joint, SerialArm
from .._robot.transforms import Array, Transform

__all__ = [
    "ImportedBody",
    "ImportedModel",
    "imported_arm",
    "moving_inertias",
    "strict_imported_model",
]


@dataclass(frozen=True, eq=False)
class ImportedBody:
    """One rigid body, or several that the engine has merged into one.

    carried_by : index of the arm's joint that carries it; None for what is fixed to the base
    inertia : in the arm's base frame at q = 0
    """

    name: str
    carried_by: int | None
    inertia: Inertia


@dataclass(frozen=True, eq=False)
class ImportedModel:
    """What an engine has imported.

    joints : in the engine's own order; `axis` in the arm's base frame at q = 0.  A limit that the
        engine does not keep is None
    bodies : every body that the engine keeps, massless ones too
    gravity : the engine's default, in the arm's base frame [m/s²]
    tool : pose of the tool in the base frame at q = 0, shape (4, 4)
    coordinates : how many position coordinates the engine uses for the arm's joints
    warnings : the engine's own, captured while it read the model
    """

    joints: tuple[Joint, ...]
    bodies: tuple[ImportedBody, ...]
    gravity: Array
    tool: Array
    coordinates: int
    warnings: tuple[str, ...] = ()


def moving_inertias(imported_model: ImportedModel, arm: SerialArm) -> list[Inertia]:
    """Per joint of the arm, all bodies that it carries in the engine, as one inertia in frame i."""
    frames = link_frames(arm, np.zeros(arm.n))
    groups = []
    for i in range(arm.n):
        carried = [body.inertia for body in imported_model.bodies if body.carried_by == i]
        total = reduce(add, carried, Inertia.zero())
        T_0i = Transform(frames[i, :3, :3], frames[i, :3, 3])
        groups.append(total.expressed_in(T_0i.inverse()))
    return groups


def imported_arm(imported_model: ImportedModel, arm: SerialArm) -> SerialArm:
    """The arm as the engine has it: the file's geometry, the engine's bodies and motor inertias.

    If an engine's torques equal those of the recursion for *this* arm, then the import explains
    every difference from the arm as it is written.
    """
    motors = {joint.name: joint.armature for joint in imported_model.joints}
    imported_arm = arm.with_inertias(moving_inertias(imported_model, arm))
    return imported_arm.with_armature([motors.get(name, 0.0) for name in arm.joint_names])


def strict_imported_model(arm: SerialArm, base: Sequence[ImportedBody] = ()) -> ImportedModel:
    """An arm itself as an imported model, one body per joint."""
    zero = np.zeros(arm.n)
    frames = link_frames(arm, zero)
    joints, bodies = [], list(base)
    R = arm.base.R
    for i, (joint, link) in enumerate(zip(arm.joints, arm.links, strict=True)):
        joints.append(replace(joint, axis=R @ joint.axis))
        T_0i = Transform(frames[i, :3, :3], frames[i, :3, 3])
        bodies.append(ImportedBody(link.name, i, link.inertia.expressed_in(T_0i)))
        R = R @ joint.motion(0.0).R @ link.link_tip_frame.R
    return ImportedModel(tuple(joints), tuple(bodies), arm.gravity, frames[-1], arm.n)
