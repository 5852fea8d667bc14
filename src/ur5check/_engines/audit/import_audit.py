"""The import audit: the model that an engine imported against the strict reading of the same text.

Torque is linear in π, so each difference of an inertia has its own torque effect, |Y Δπ|, and
together they are the whole: if the engine's torques are those of the recursion for the *imported*
arm, the import explains every difference.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..._dynamics.equations import gravity_torque
from ..._dynamics.regressor import torque_regressor
from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.states import States
from ..._robot.transforms import Array
from ..imported_model import ImportedModel, imported_arm
from ..known_issues import known_issue_for
from .import_difference import Bearing, ImportDifference, Kind
from .imported_bodies import body_differences
from .imported_joints import frame_differences, joint_differences

__all__ = ["ImportAudit", "audit", "with_torque_effects"]


@dataclass(frozen=True, eq=False)
class ImportAudit:
    """The result of the audit of one engine.

    arm : as it is written;  imported_arm : as the engine has it
    differences : between the two, those that affect torques first
    """

    arm: ArmOrTree
    imported_model: ImportedModel
    imported_arm: ArmOrTree
    differences: tuple[ImportDifference, ...]

    @property
    def harmful(self) -> tuple[ImportDifference, ...]:
        """Those that affect torques."""
        return self.bearing_on("torque")

    def bearing_on(self, what: Bearing) -> tuple[ImportDifference, ...]:
        """Those that affect torques, use, or nothing."""
        return tuple(found for found in self.differences if found.bears_on == what)

    @cached_property
    def kinds(self) -> Counter[Kind]:
        """How many there are of each kind."""
        return Counter(found.kind for found in self.differences)

    @property
    def added_mass(self) -> float:
        """Mass of the engine's arm in excess of the file's [kg]."""
        return sum(found.mass for found in self.differences)


def audit(imported_model: ImportedModel, arm: ArmOrTree, key: str = "") -> ImportAudit:
    """Name every difference between an imported model and the arm's source.

    key : the engine's; its known issues are attached to the differences that they explain
    """
    found = [
        *body_differences(imported_model, arm),
        *joint_differences(imported_model, arm),
        *frame_differences(imported_model, arm),
    ]
    named = tuple(replace(one, known_issue=known_issue_for(key, one.kind)) for one in found)
    return ImportAudit(arm, imported_model, imported_arm(imported_model, arm), named)


def with_torque_effects(imported: ImportAudit, states: States) -> ImportAudit:
    """The same with each difference's torque effect at these states, the largest first."""
    arm, imported_model = imported.arm, imported.imported_model
    if not imported.differences:
        return imported
    inertial = any(one.parameters is not None for one in imported.differences)
    Y = torque_regressor(arm, states.q, states.qd, states.qdd) if inertial else np.empty(0)
    order: tuple[Bearing, ...] = ("torque", "use", "nothing")
    valued = [
        replace(one, torque_effect=_torque_effect(one, imported_model, arm, states, Y))
        for one in imported.differences
    ]
    valued.sort(key=lambda one: (order.index(one.bears_on), -(one.torque_effect or 0.0)))
    return replace(imported, differences=tuple(valued))


def _torque_effect(
    one: ImportDifference, imported_model: ImportedModel, arm: ArmOrTree, states: States, Y: Array
) -> float | None:
    if one.parameters is not None:
        return float(np.abs(Y @ one.parameters).max())
    if one.kind == "armature" and one.joint is not None:
        motors = {joint.name: joint.armature for joint in imported_model.joints}
        each = tree_links(arm)[one.joint]
        gap = motors[each.joint.name] - each.joint.armature
        return float(np.abs(gap * each.multiplier**2 * states.qdd[:, each.coordinate]).max())
    if one.kind == "gravity":
        # g(q) is linear in gravity.
        return float(
            np.abs(gravity_torque(arm, states.q, imported_model.gravity - arm.gravity)).max()
        )
    return None
