"""One explanation of a residual, with the values that fit best."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from .._robot.transforms import Array

__all__ = ["Cause", "CauseId"]

CauseId = Literal[
    "gain-of-all",
    "gain-of-joint",
    "payload",
    "gravity-direction",
    "joint-zero",
    "joint-sign",
    "link-mass",
    "link-centre",
    "link-tensor",
    "mistake",
]


@dataclass(frozen=True, eq=False)
class Cause:
    """One cause, with the values that explain the recording best.

    id : its name
    joint : of the joint, or of the link that it moves, from 1; 0 where it concerns the whole arm
    names, units : of the values
    value, half_width : 95 % interval value ± half_width, shape (k,)
    evidence : by how much the weighted sum of squares falls, over what chance would take; above 0
        the cause is likelier than none
    closes : the part that it takes away of what the free base parameters take away
    sizes : of each joint's residual with this cause [N m], shape (n,)
    mistake, how : id of the known mistake, and how it could have been made; "" for other causes
    """

    id: CauseId
    joint: int
    names: tuple[str, ...]
    units: tuple[str, ...]
    value: Array
    half_width: Array
    evidence: float
    closes: float
    sizes: Array
    mistake: str = ""
    how: str = ""
