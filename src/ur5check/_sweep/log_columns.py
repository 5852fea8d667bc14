"""The columns of a log that hold the states: by number (`q1`, `qd1`, `qdd1`) or joint name."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path

import numpy as np

from .._errors import StateError
from .._robot.serial_arm import SerialArm
from .._robot.states import States
from .._robot.transforms import Array

__all__ = ["PARTS", "state_columns", "states_of"]

PARTS = ("q", "qd", "qdd")  # [rad], [rad/s], [rad/s²]; [m] … for a sliding joint


def state_columns(header: Sequence[str], arm: SerialArm, file: Path) -> tuple[int, ...]:
    """Indices of q of all joints, then q̇, then q̈, in the arm's order.  Other columns are ignored.

    The columns of joint 1 are `q1`, `qd1`, `qdd1`, or `q_NAME`, `qd_NAME`, `qdd_NAME`.

    Raises StateError for a column that is missing or ambiguous.
    """
    return tuple(
        _one(header, (f"{part}{i}", f"{part}_{name}"), file)
        for part in PARTS
        for i, name in enumerate(arm.joint_names, start=1)
    )


def _one(header: Sequence[str], names: tuple[str, str], file: Path) -> int:
    found = [k for k, column in enumerate(header) if column in names]
    if len(found) == 1:
        return found[0]
    if found:
        both = ", ".join(repr(header[k]) for k in found)
        raise StateError(f"{file}: columns {both} hold the same quantity; keep one of them")
    near = get_close_matches(names[0], header, 1) or get_close_matches(names[1], header, 1)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    raise StateError(
        f"{file}: there is no column {names[0]!r} (or {names[1]!r}); a log needs position, "
        f"velocity and acceleration of every joint{hint}"
    )


def states_of(rows: Array) -> States:
    """States from 3 n rows: q of all joints, then q̇, then q̈."""
    q, qd, qdd = np.split(rows, 3)
    return States(q.T, qd.T, qdd.T)
