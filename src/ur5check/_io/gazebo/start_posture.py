"""The range of limited joints, half a turn either way, and their start in a simulation.

The paper's launch file has an argument `limited` for a model whose joints stay within [−π, π].  Its
test 9 has a joint at 3.5 rad, outside.  One turn less is the same posture, which both models hold.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..._errors import UsageError
from ..._robot import Joint

__all__ = ["HALF_TURN", "start_angles"]

HALF_TURN = math.pi


def start_angles(joints: Sequence[Joint], pose: Sequence[float]) -> tuple[float, ...]:
    """The pose, each angle where the limited joint can reach it, whole turns added or not.

    pose : joint positions, length n [rad] or [m]

    Raises UsageError for a pose of another length or not finite, and where no such angle exists.
    """
    if len(pose) != len(joints):
        raise UsageError(
            f"--pose: {len(pose)} angles for the {len(joints)} joints of this arm; give --pose "
            "Q1 … Qn, one a joint [rad, m]"
        )
    if not np.isfinite(pose).all():
        raise UsageError(f"--pose {' '.join(map(str, pose))}: an angle must be a finite number")
    return tuple(_start(joint, float(q)) for joint, q in zip(joints, pose, strict=True))


def _start(joint: Joint, q: float) -> float:
    lower, upper = _range(joint)
    if lower <= q <= upper:
        return q
    if joint.kind == "revolute":
        # Of the turns that bring q into the range, the one that needs fewest.
        turns = (
            math.ceil((lower - q) / math.tau) if q < lower else math.floor((upper - q) / math.tau)
        )
        moved = q + turns * math.tau
        if lower <= moved <= upper:
            return moved
    raise UsageError(
        f"--pose: {q:g} lies outside what joint {joint.name!r} may do, limited: [{lower:g}, "
        f"{upper:g}]; give --pose Q1 … Qn, a posture that it can hold"
    )


def _range(joint: Joint) -> tuple[float, float]:
    """Lowest and highest position of the limited joint."""
    limits, bound = joint.limits, HALF_TURN if joint.kind == "revolute" else math.inf
    lower = -bound if limits.lower is None else max(limits.lower, -bound)
    upper = bound if limits.upper is None else min(limits.upper, bound)
    return lower, upper
