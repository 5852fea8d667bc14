"""What an engine holds after it has read a model: joints, bodies, gravity, tool.

Everything is told in the arm's base frame with every joint at zero, which all engines can say of
themselves, whichever link frames they keep inside.  Nothing here judges:
`_engines.audit.import_audit` compares it with our own reading.
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

__all__ = ["HeldBody", "ImportedModel", "imported_arm", "moving_inertias", "strict_imported_model"]


@dataclass(frozen=True, eq=False)
class HeldBody:
    """One rigid body, or several that the engine has merged into one.

    carried_by : index of the arm's joint that carries it; None for what stands on the base
    inertia : in the arm's base frame at q = 0
    """

    name: str
    carried_by: int | None
    inertia: Inertia


@dataclass(frozen=True, eq=False)
class ImportedModel:
    """What an engine believes.

    joints : in the engine's own order; `axis` in the arm's base frame at q = 0.  A limit that the
        engine does not keep is None
    bodies : every body that the engine keeps, massless ones too
    gravity : what the engine would take if nobody told it, in the arm's base frame [m/s²]
    tool : pose of the tool in the base frame at q = 0, shape (4, 4)
    coordinates : how many position coordinates the engine uses for the arm's joints
    said : warnings of the engine's own while it read the model
    """

    joints: tuple[Joint, ...]
    bodies: tuple[HeldBody, ...]
    gravity: Array
    tool: Array
    coordinates: int
    said: tuple[str, ...] = ()


def moving_inertias(imported_model: ImportedModel, arm: SerialArm) -> list[Inertia]:
    """Per joint of the arm, all that the engine lets it carry, as one inertia in our frame i."""
    frames = link_frames(arm, np.zeros(arm.n))
    groups = []
    for i in range(arm.n):
        carried = [body.inertia for body in imported_model.bodies if body.carried_by == i]
        total = reduce(add, carried, Inertia.zero())
        T_0i = Transform(frames[i, :3, :3], frames[i, :3, 3])
        groups.append(total.expressed_in(T_0i.inverse()))
    return groups


def imported_arm(imported_model: ImportedModel, arm: SerialArm) -> SerialArm:
    """The arm as the engine has it: our geometry, the engine's bodies and motors.

    If an engine computes what our recursion computes of *this* arm, then its import explains every
    difference from the arm as it was written.
    """
    motors = {joint.name: joint.armature for joint in imported_model.joints}
    imported_arm = arm.with_inertias(moving_inertias(imported_model, arm))
    return imported_arm.with_armature([motors.get(name, 0.0) for name in arm.joint_names])


def strict_imported_model(arm: SerialArm, base: Sequence[HeldBody] = ()) -> ImportedModel:
    """Our own reading of an arm, in the same words; one body a joint."""
    zero = np.zeros(arm.n)
    frames = link_frames(arm, zero)
    joints, bodies = [], list(base)
    R = arm.base.R
    for i, (joint, link) in enumerate(zip(arm.joints, arm.links, strict=True)):
        joints.append(replace(joint, axis=R @ joint.axis))
        T_0i = Transform(frames[i, :3, :3], frames[i, :3, 3])
        bodies.append(HeldBody(link.name, i, link.inertia.expressed_in(T_0i)))
        R = R @ joint.motion(0.0).R @ link.link_tip_frame.R
    return ImportedModel(tuple(joints), tuple(bodies), arm.gravity, frames[-1], arm.n)
