"""An arm of a robot by the name that a person uses: "left", "right_arm", its tip's name."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping

from .._errors import UsageError
from .._robot.robot import Robot
from .arm_choice import choose_arm

__all__ = ["tip_of_arm"]

_LISTED = 12


def tip_of_arm(robot: Robot, arm: str, base: str | None = None) -> str:
    """The tip of the one chain that `arm` names.

    In this order, upper and lower case alike: the name of its last link, or of a link fixed there;
    how that name begins; a part of it; the name's words in any order; then the same of links and
    joints that are this chain's alone.  The first of these that any chain meets decides.

    Raises UsageError, with the names of all chains, where none meets any, or several the first.
    """
    chains = dict(choose_arm(robot, base).chains)
    for tip in chains:
        if arm in robot.rigid(tip):
            return arm
    for names in ({tip: [tip] for tip in chains}, _own_names(robot, chains)):
        for criterion in (_begins, _holds, _has_words):
            met = [tip for tip in chains if any(criterion(name, arm) for name in names[tip])]
            if len(met) > 1:
                raise UsageError(f"{arm!r} may be {_listed(met, chains)}; write more of the name")
            if met:
                return met[0]
    raise UsageError(f"no arm is called {arm!r}; the arms are {_listed(list(chains), chains)}")


def _begins(name: str, start: str) -> bool:
    return name.lower().startswith(start.lower())


def _holds(name: str, part: str) -> bool:
    return part.lower() in name.lower()


def _has_words(name: str, words: str) -> bool:
    return _words(words) <= _words(name)


def _words(name: str) -> set[str]:
    return set(re.findall(r"[^\W_]+", name.lower()))


def _own_names(robot: Robot, chains: Mapping[str, int]) -> dict[str, list[str]]:
    """The links and joints of each chain that are no other's."""
    ways = {tip: list(robot.up(tip)) for tip in chains}
    users = Counter(joint.name for way in ways.values() for joint in way)
    return {
        tip: [name for joint in way if users[joint.name] == 1 for name in (joint.name, joint.child)]
        for tip, way in ways.items()
    }


def _listed(tips: list[str], chains: Mapping[str, int]) -> str:
    shown = [f"{tip} ({chains[tip]} joints)" for tip in tips[:_LISTED]]
    return ", ".join(shown) + (f" and {len(tips) - _LISTED} more" if tips[_LISTED:] else "")
