"""Numbers as text that reads back as the same number."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from .._robot.transforms import Array

__all__ = ["as_written", "exact", "roll_pitch_yaw", "triple"]


def exact(value: float) -> str:
    """The shortest decimal that reads back as this double; zero has no sign."""
    return repr(float(value) + 0.0)


def triple(values: Iterable[float]) -> str:
    return " ".join(exact(value) for value in values)


def as_written(value: float, error: float) -> float:
    """The number with fewest digits within `error` of `value`.

    A centre of mass that was taken from one frame to another and back is off by rounding:
    0.28 has become 0.27999999999999997.  Within that rounding, the shortest number is the
    best guess at what was written, and as near as any other.
    """
    if abs(value) <= error:
        return 0.0
    for digits in range(1, 17):
        shorter = float(f"{value:.{digits - 1}e}")
        if abs(shorter - value) <= error:
            return shorter
    return value


def roll_pitch_yaw(R: Array) -> tuple[float, float, float]:
    """Angles [rad] with R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).

    R : shape (3, 3)

    At pitch = ±π/2 roll and yaw turn about one axis, and near it each of them alone is ill-defined
    while what they do together is not.  So they are not read off R independently: roll is, and
    yaw and pitch are those of R Rot_x(roll)⁻¹, which makes good whatever roll has missed.
    """
    roll = float(np.arctan2(R[2, 1], R[2, 2])) if R[2, 1] or R[2, 2] else 0.0
    c, s = _cos_sin(R[2, 2], R[2, 1])
    # The columns of Rot_z(yaw) Rot_y(pitch): its second is (−sin yaw, cos yaw, 0).
    second = c * R[:, 1] - s * R[:, 2]
    yaw = float(np.arctan2(-second[0], second[1]))
    c, s = _cos_sin(second[1], -second[0])
    pitch = float(np.arctan2(-R[2, 0], c * R[0, 0] + s * R[1, 0]))
    return roll + 0.0, pitch + 0.0, yaw + 0.0


def _cos_sin(x: float, y: float) -> tuple[float, float]:
    """Cosine and sine of atan2(y, x), exact where one of them is zero."""
    length = float(np.hypot(x, y))
    return (x / length, y / length) if length > 0.0 else (1.0, 0.0)
