"""An arm from whatever a public function is given for one.

Public functions of every layer accept a model's name or path.  The readers of files stand above
most of these layers, so they are imported by name when one is needed.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from .robot_tree import RobotTree
from .serial_arm import SerialArm

if TYPE_CHECKING:
    import pinocchio as pin

__all__ = ["ArmSource", "ModelSource", "as_arm", "as_arm_or_tree"]

#: What is accepted as an arm.
ArmSource: TypeAlias = "str | Path | SerialArm | pin.Model"

#: What the dynamics accept: an arm, or a whole robot.
ModelSource: TypeAlias = "ArmSource | RobotTree"


def as_arm(model: ArmSource) -> SerialArm:
    """`model` itself if it is a SerialArm, otherwise what `ur5check.load` makes of it.

    A name or a path is read at every call: in a loop, load the arm once.  Raises as `load` does.
    """
    if isinstance(model, SerialArm):
        return model
    arm: SerialArm = import_module("ur5check._io.loading").load(model)
    return arm


def as_arm_or_tree(model: ModelSource) -> SerialArm | RobotTree:
    """`model` itself if it is a RobotTree, otherwise as `as_arm`."""
    return model if isinstance(model, RobotTree) else as_arm(model)
