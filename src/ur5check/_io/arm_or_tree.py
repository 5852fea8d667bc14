"""One arm, or the whole robot where a file has several."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TypeAlias

from .._errors import ModelError, UsageError
from .._robot.as_arm import ArmSource
from .._robot.robot import Robot
from .._robot.robot_tree import ArmOrTree, RobotTree
from .arm_choice import choose_arm
from .loading import load
from .robot_loading import load_robot, read_robot

__all__ = ["WholeSource", "load_arm_or_tree"]

#: What is accepted as an arm or a whole robot.
WholeSource: TypeAlias = "ArmSource | Robot | RobotTree"


def load_arm_or_tree(
    model: WholeSource,
    *,
    whole: bool = False,
    base: str | None = None,
    tip: str | None = None,
    arm: str | None = None,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
) -> ArmOrTree:
    """The arm that `load` gives; the whole robot of a file in which several chains could be meant.

    model : as for `load`, or a Robot or RobotTree, which is taken whole
    whole : whether the whole robot is wanted in any case
    base, tip, arm, packages, arguments : as for `load`

    Raises ModelError and UsageError as `load` and `load_robot` do.
    """
    if isinstance(model, RobotTree):
        return model
    if isinstance(model, Robot):
        return RobotTree.of(model)
    chosen = (base, tip, arm) != (None, None, None)
    if whole and chosen:
        raise UsageError("base, tip and arm choose an arm, not a whole robot; leave them out")
    if whole:
        if not isinstance(model, str | Path):
            raise UsageError(f"a {type(model).__name__} is no whole robot; give a file")
        return RobotTree.of(load_robot(model, packages=packages, arguments=arguments))
    try:
        return load(model, base=base, tip=tip, arm=arm, packages=packages, arguments=arguments)
    except ModelError:
        if chosen or not isinstance(model, str | Path) or not Path(model).is_file():
            raise
        robot = read_robot(model, packages=packages, arguments=arguments).robot
        if robot is None or len((choice := choose_arm(robot)).chains) < 2 or choice.tip:
            raise
        return RobotTree.of(load_robot(model, packages=packages, arguments=arguments))
