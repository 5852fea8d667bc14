"""Which quantity and which joint a column holds, from its name.

Names of joint states as ROS tools write them to tables, of UR's RTDE, of Franka's libfranka, and
short ones of one's own ("q1", "qd_elbow", "tau[3]").
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal, get_args

__all__ = ["Quantity", "columns_of"]

#: t: time;  tau: measured torque;  model: torque that a controller computed
Quantity = Literal["t", "q", "qd", "tau", "current", "model"]

_NAMES: dict[Quantity, tuple[str, ...]] = {
    "t": ("t", "time", "timestamp", "stamp", "sec", "seconds", "header_stamp", "elapsed"),
    "q": ("q", "pos", "position", "positions", "actual_q", "joint_position", "angle"),
    "qd": (
        "qd", "dq", "qdot", "vel", "velocity", "velocities", "actual_qd", "joint_velocity",
        "speed",
    ),
    "tau": (
        "tau", "torque", "torques", "effort", "efforts", "tau_j", "actual_torque",
        "joint_torque", "joint_effort", "tau_measured", "actual_joint_torque",
    ),
    "current": ("i", "current", "currents", "actual_current", "motor_current"),
    "model": ("target_moment", "tau_j_d", "tau_model", "tau_d", "desired_torque"),
}  # fmt: skip

_WORDS: dict[str, Quantity] = {
    word: quantity for quantity, words in _NAMES.items() for word in words
}

_NUMBERED = re.compile(r"^(?P<word>.*?)[_\[.\s]*(?P<number>\d+)\]?$")


def columns_of(names: Sequence[str]) -> dict[Quantity, dict[str, int]]:
    """For each quantity, the column of each joint: its name, or its number as text.

    Time has the key "".  Columns of other names are left out.
    """
    found: dict[Quantity, dict[str, int]] = {quantity: {} for quantity in get_args(Quantity)}
    for column, name in enumerate(names):
        meaning = _meaning(name)
        if meaning is not None:
            quantity, joint = meaning
            found[quantity].setdefault(joint, column)
    return {quantity: joints for quantity, joints in found.items() if joints}


def _meaning(name: str) -> tuple[Quantity, str] | None:
    text = name.strip().strip("%\"'_").lower().removeprefix("field.").replace("header.", "header_")
    if _WORDS.get(text) == "t":
        return "t", ""
    numbered = _NUMBERED.match(text)
    if numbered and (quantity := _WORDS.get(numbered["word"].rstrip("_.[ "))) not in (None, "t"):
        return quantity, numbered["number"]
    # "/joint_states/elbow_joint/position", "position_elbow_joint", "elbow_joint.effort"
    parts = [part for part in re.split(r"[/.:\s]+", text) if part]
    if len(parts) > 1:
        for part in (parts[-1], parts[0]):
            quantity = _WORDS.get(part)
            if quantity not in (None, "t"):
                joint = parts[-2] if part is parts[-1] else parts[-1]
                return quantity, joint
    for word in sorted(_WORDS, key=len, reverse=True):
        quantity = _WORDS[word]
        if quantity != "t" and text.startswith(f"{word}_") and len(text) > len(word) + 1:
            return quantity, text[len(word) + 1 :]
    return None
