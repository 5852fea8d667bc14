"""Mistakes of the whole arm: gravity, the base, joint directions and zeros, the DH rule."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from ..._robot.transforms import Array, Transform
from ..alignment import SAME_ANGLE
from ..arm_pair import Side
from .pair_readings import Reading

__all__ = ["WholeArm", "whole_arm"]

Id = Literal[
    "dh-convention",
    "base-turned",
    "joint-reversed",
    "zero-shifted",
    "gravity-sign",
    "gravity-value",
    "gravity-direction",
    "motor-inertia",
]

_SAME_MOTOR = 1e-4  # relative: the four digits of a data sheet
_SAME_GRAVITY = 1e-9  # relative: both are written by people, and copied


@dataclass(frozen=True, eq=False)
class WholeArm:
    """One mistake, or one difference of convention, that concerns the whole arm.

    joints : numbers from 1 and what is asked of each [rad] or [m]
    base : pose of b's base in a's;  gravity : a's and b's, in a's base frame [m/s²]
    motors : a's and b's motor inertias, shape (2, n) [kg m²]
    mends_torque : whether the torque difference changes when it is repaired; the alignment of joint
        angles has been applied already
    """

    id: Id
    side: Side | None
    repairs_torque: bool
    choices: int
    joints: tuple[tuple[int, float], ...] = ()
    base: Transform = field(default_factory=Transform.identity)
    gravity: tuple[Array, Array] | None = None
    motors: Array | None = None


def whole_arm(reading: Reading) -> list[WholeArm]:
    """What concerns the whole arm in a reading, in the order in which it is to be repaired."""
    pair, alignment = reading.pair, reading.pair.alignment
    found = []
    if reading.rule is not None:
        found.append(WholeArm("dh-convention", reading.rule, True, 1))
    reversed_joints = tuple((int(i) + 1, 0.0) for i in np.flatnonzero(alignment.signs < 0))
    if reversed_joints:
        found.append(WholeArm("joint-reversed", "b", False, 2**pair.a.n, reversed_joints))
    shifted = tuple(
        (i, float(offset))
        for i, offset in enumerate(alignment.offsets, 1)
        if abs(offset) > SAME_ANGLE
    )
    if shifted:
        found.append(WholeArm("zero-shifted", "b", False, pair.a.n, shifted))
    if alignment.T_ab.angle() > SAME_ANGLE:
        found.append(WholeArm("base-turned", None, False, 1, base=alignment.T_ab))
    g_a, g_b = pair.a.gravity, pair.b.gravity
    size = float(np.linalg.norm(g_a))
    if np.abs(g_a - g_b).max() > _SAME_GRAVITY * size:
        found.append(WholeArm(_gravity_id(g_a, g_b), None, True, 1, gravity=(g_a, g_b)))
    motors = np.stack([pair.a.armature, pair.b.armature])
    apart = np.abs(motors[0] - motors[1]) > _SAME_MOTOR * motors.max(axis=0)
    if apart.any():
        numbers = tuple((int(i) + 1, float(motors[0, i])) for i in np.flatnonzero(apart))
        found.append(WholeArm("motor-inertia", None, True, 1, numbers, motors=motors))
    return found


def _gravity_id(g_a: Array, g_b: Array) -> Id:
    across = float(np.linalg.norm(np.cross(g_a, g_b)))
    if across > SAME_ANGLE * float(np.linalg.norm(g_a) * np.linalg.norm(g_b)):
        return "gravity-direction"
    return "gravity-sign" if float(g_a @ g_b) < 0.0 else "gravity-value"
