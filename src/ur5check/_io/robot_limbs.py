"""The limbs of a robot with several chains: each as an arm, by its name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from .._errors import InputError, UsageError
from .._robot.robot import Robot
from .._robot.serial_arm import SerialArm
from .arm_choice import choose_arm
from .arm_loading import load_arm
from .arm_names import tip_of_arm
from .robot_loading import read_robot

__all__ = ["Limbs", "matched_limbs", "read_limbs"]


@dataclass(frozen=True, eq=False)
class Limbs:
    """arms : by the name of the last link, from the root; why not, where it cannot be read"""

    robot: Robot
    arms: Mapping[str, SerialArm | InputError]


def read_limbs(
    model: str,
    *,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
) -> Limbs | None:
    """All limbs of a file in which several chains could be the arm; None of any other file.

    Raises UsageError as `read_robot` does.
    """
    reading = read_robot(model, packages=packages, arguments=arguments)
    robot = reading.robot
    if robot is None or reading.tip is not None:
        return None
    choice = choose_arm(robot)
    if choice.tip is not None or len(choice.chains) < 2:
        return None
    arms: dict[str, SerialArm | InputError] = {}
    for tip, _ in choice.chains:
        try:
            arms[tip] = load_arm(robot, reading.findings, tip=tip, strict=False)
        except InputError as error:
            arms[tip] = error
    return Limbs(robot, arms)


def matched_limbs(a: Limbs, b: Limbs) -> list[tuple[str | None, str | None]]:
    """The limbs of two robots by name: of the same last link, else as `--arm` would find them.

    None for a limb that the other robot has not.
    """
    found = {tip: tip for tip in a.arms if tip in b.arms}
    taken = set(found.values())
    for tip in a.arms:
        other = None if tip in found else _named(b.robot, tip)
        if other is not None and other in b.arms and other not in taken:
            found[tip] = other
            taken.add(other)
    pairs: list[tuple[str | None, str | None]] = [(tip, found.get(tip)) for tip in a.arms]
    return pairs + [(None, tip) for tip in b.arms if tip not in taken]


def _named(robot: Robot, name: str) -> str | None:
    try:
        return tip_of_arm(robot, name)
    except UsageError:
        return None
