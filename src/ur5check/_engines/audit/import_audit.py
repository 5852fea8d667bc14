"""The import audit: what an engine believes after reading, against our strict reading of the same.

Torque is linear in π, so each difference of an inertia has its own newton metres, |Y Δπ|, and
together they are the whole: if the engine computes what our recursion computes of the arm that it
*believes* in, its import explains all that it says otherwise.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..._dynamics.equations import gravity_torque
from ..._dynamics.regressor import torque_regressor
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States
from ..._robot.transforms import Array
from ..imported_model import ImportedModel, imported_arm
from ..known_issues import known_issue_for
from .import_difference import Bearing, ImportDifference, Kind
from .imported_bodies import body_differences
from .imported_joints import frame_differences, joint_differences

__all__ = ["Import", "audit", "priced"]


@dataclass(frozen=True, eq=False)
class Import:
    """What came of an engine's reading.

    believed : the arm as the engine has it
    differences : from the arm as it is written, those that bear on torque first
    """

    arm: SerialArm
    imported_model: ImportedModel
    imported_arm: SerialArm
    differences: tuple[ImportDifference, ...]

    @property
    def harmful(self) -> tuple[ImportDifference, ...]:
        """Those that bear on torque."""
        return self.bearing_on("torque")

    def bearing_on(self, what: Bearing) -> tuple[ImportDifference, ...]:
        """Those that bear on torque, on use, or on nothing."""
        return tuple(found for found in self.differences if found.bears_on == what)

    @cached_property
    def kinds(self) -> Counter[Kind]:
        """How many there are of each kind."""
        return Counter(found.kind for found in self.differences)

    @property
    def added_mass(self) -> float:
        """What the engine's arm weighs more than the file's [kg]."""
        return sum(found.mass for found in self.differences)


def audit(imported_model: ImportedModel, arm: SerialArm, key: str = "") -> Import:
    """Name every difference between what an engine holds and what the arm's source says.

    key : the engine's, whose known known issues explain what they can
    """
    found = [
        *body_differences(imported_model, arm),
        *joint_differences(imported_model, arm),
        *frame_differences(imported_model, arm),
    ]
    named = tuple(replace(one, known_issue=known_issue_for(key, one.kind)) for one in found)
    return Import(arm, imported_model, imported_arm(imported_model, arm), named)


def priced(imported: Import, states: States) -> Import:
    """The same with each difference's newton metres at these states, the dearest first."""
    arm, imported_model = imported.arm, imported.imported_model
    if not imported.differences:
        return imported
    inertial = any(one.parameters is not None for one in imported.differences)
    Y = torque_regressor(arm, states.q, states.qd, states.qdd) if inertial else np.empty(0)
    order: tuple[Bearing, ...] = ("torque", "use", "nothing")
    valued = [
        replace(one, cost=_cost(one, imported_model, arm, states, Y))
        for one in imported.differences
    ]
    valued.sort(key=lambda one: (order.index(one.bears_on), -(one.cost or 0.0)))
    return replace(imported, differences=tuple(valued))


def _cost(
    one: ImportDifference, imported_model: ImportedModel, arm: SerialArm, states: States, Y: Array
) -> float | None:
    if one.parameters is not None:
        return float(np.abs(Y @ one.parameters).max())
    if one.kind == "armature" and one.joint is not None:
        motors = {joint.name: joint.armature for joint in imported_model.joints}
        gap = motors[arm.joint_names[one.joint]] - arm.joints[one.joint].armature
        return float(np.abs(gap * states.qdd[:, one.joint]).max())
    if one.kind == "gravity":
        # g(q) is linear in gravity: the torque of the gap is the gap between the torques.
        return float(
            np.abs(gravity_torque(arm, states.q, imported_model.gravity - arm.gravity)).max()
        )
    return None
