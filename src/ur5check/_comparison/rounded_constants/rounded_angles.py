"""Angles that were written as decimals: π/2 as 1.5707, or as 1.570796327; π/4 as 0.7854."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2, gcd, hypot, pi

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from .decimals import Writing, written_as
from .frame_change import arm_with_link, link_vector_is_written_at_link_tip, with_link_tip_frame

__all__ = [
    "NEARLY",
    "RoundedAngle",
    "rounded_angles",
    "with_angles_written_out",
    "with_exact_angles",
]

#: How far [rad] a rotation may lie from a quarter turn and still be one: 1.57 is 8e-4 off.
NEARLY = 1e-3

_ZERO_TOLERANCE = 2e-15  # of a product of three rotations [rad]
_QUARTERS = (("π/2", pi / 2), ("π", pi), ("3π/2", 1.5 * pi), ("2π", 2 * pi))

# Roll, pitch and yaw of a product of three rotations [rad], unless pitch is near a quarter turn.
_ANGLE_TOLERANCE = 4e-15
_DEGENERATE = 0.1  # cosine of pitch

# Other parts of π are recognised where as many decimals were written: a measured angle has the same
# four by chance once in a thousand times.
_PARTS, _PART_DECIMALS = 12, 4


@dataclass(frozen=True, eq=False)
class RoundedAngle:
    """A rotation of an arm with an angle that is a part of π but for its digits.

    place : 0 for the base B, i for P_i
    constant : "π/2";  writing : how it was written, the coarsest if several angles were
    exact : the rotation that was meant, shape (3, 3)
    """

    place: int
    constant: str
    writing: Writing
    exact: Array

    @property
    def where(self) -> str:
        return "B" if self.place == 0 else f"P{self.place}"


def rounded_angles(arm: SerialArm) -> tuple[RoundedAngle, ...]:
    """Every rotation of B and P_i in which an angle was written with some decimals of a part of π.

    Being near a quarter turn is not enough: the angles of a calibrated arm are.  The rest
    must be what rounding or cutting off leaves, to the last digit: about each axis of a quarter
    turn, or in roll, pitch or yaw (a DH row's α and θ are roll and yaw).
    """
    transforms = [arm.base, *(link.link_tip_frame for link in arm.links)]
    found = (_rounded(place, T.R) or _rounded_rpy(place, T.R) for place, T in enumerate(transforms))
    return tuple(angle for angle in found if angle is not None)


def with_angles_written_out(arm: SerialArm) -> SerialArm:
    """The arm with every rounded angle as it was meant."""
    return with_exact_angles(arm, rounded_angles(arm))


def with_exact_angles(arm: SerialArm, angles: tuple[RoundedAngle, ...]) -> SerialArm:
    """The arm with these rotations as they were meant, every other written number kept."""
    for angle in angles:
        if angle.place == 0:
            arm = replace(arm, base=Transform(angle.exact, arm.base.p))
            continue
        link = arm.links[angle.place - 1]
        p = link.link_tip_frame.p
        if link_vector_is_written_at_link_tip(link):
            p = angle.exact @ (link.link_tip_frame.R.T @ p)
        arm = arm_with_link(
            arm, angle.place - 1, with_link_tip_frame(link, Transform(angle.exact, p))
        )
    return arm


def _rounded(place: int, R: Array) -> RoundedAngle | None:
    exact = np.rint(R) + 0.0  # no −0
    if np.abs(R - exact).max() > NEARLY or not np.array_equal(exact @ exact.T, np.eye(3)):
        return None
    rotation = np.abs(_rotation_vector(exact.T @ R))
    # Turns about several axes are known to second order only.
    tolerance = (
        _ZERO_TOLERANCE
        if (rotation > _ZERO_TOLERANCE).sum() < 2
        else max(_ZERO_TOLERANCE, 2.0 * float(rotation.max()) ** 2)
    )
    writings = [_written(float(angle), tolerance) for angle in rotation if angle > tolerance]
    if not writings or None in writings:
        return None
    coarsest = min((w for w in writings if w is not None), key=lambda found: found[1].decimals)
    return RoundedAngle(place, *coarsest, exact)


def _rounded_rpy(place: int, R: Array) -> RoundedAngle | None:
    """The same for R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll) with one or more rounded angles."""
    level = hypot(R[0, 0], R[1, 0])
    if level < _DEGENERATE:
        return None
    angles = (atan2(R[2, 1], R[2, 2]), atan2(-R[2, 0], level), atan2(R[1, 0], R[0, 0]))
    found = [_part_of_pi(angle) for angle in angles]
    if not any(found):
        return None
    meant = [
        angle if part is None else np.sign(angle) * part[0]
        for angle, part in zip(angles, found, strict=True)
    ]
    coarsest = min((part[1:] for part in found if part), key=lambda part: part[1].decimals)
    return RoundedAngle(place, *coarsest, Transform.from_rpy(np.zeros(3), meant).R)


def _part_of_pi(angle: float) -> tuple[float, str, Writing] | None:
    """The multiple of π/12 that |angle| [rad] was written for, its name and writing."""
    k = round(abs(angle) / (pi / _PARTS))
    if k == 0 or abs(abs(angle) - k * pi / _PARTS) > NEARLY:
        return None
    quarter = k % (_PARTS // 2) == 0
    writing = written_as(
        abs(angle),
        k * pi / _PARTS,
        least=2 if quarter else _PART_DECIMALS,
        tolerance=_ANGLE_TOLERANCE,
    )
    if writing is None:
        return None
    over, under = k // gcd(k, _PARTS), _PARTS // gcd(k, _PARTS)
    name = ("" if over == 1 else str(over)) + "π" + ("" if under == 1 else f"/{under}")
    return k * pi / _PARTS, name, writing


def _written(off: float, tolerance: float) -> tuple[str, Writing] | None:
    """The constant whose writing is `off` [rad] away from it: the one with the fewest decimals."""
    found = [
        (name, writing)
        for name, constant in _QUARTERS
        for sign in (1.0, -1.0)
        if (writing := written_as(constant + sign * off, constant, least=2, tolerance=tolerance))
    ]
    return min(found, key=lambda each: each[1].decimals, default=None)


def _rotation_vector(R: Array) -> Array:
    """Axis times angle [rad] of a small rotation."""
    v = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    sine = float(np.linalg.norm(v))
    if sine == 0.0:
        return v
    return np.asarray(v * (np.arctan2(sine, 0.5 * (np.trace(R) - 1.0)) / sine))
