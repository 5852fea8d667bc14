"""Mistakes of the whole arm: DH convention, joint directions and zeros, base, gravity, motors.

In the order in which they are repaired.
"""

from __future__ import annotations

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from ..alignment import SAME_ANGLE
from ..arm_pair import Pair, Side
from .mistake import ArmDifference, ArmMistake

__all__ = ["ARM_MISTAKES", "ROUNDED"]

_SAME_MOTOR = 1e-4  # relative: the four digits of a data sheet
_SAME_GRAVITY = 1e-9  # relative: both are written by people, and copied


def _not_searched(pair: Pair, rule: Side | None) -> ArmDifference | None:
    return None


def _other_convention(pair: Pair, rule: Side | None) -> ArmDifference | None:
    return None if rule is None else ArmDifference(rule)


def _reversed(pair: Pair, rule: Side | None) -> ArmDifference | None:
    joints = tuple((int(i) + 1, 0.0) for i in np.flatnonzero(pair.alignment.signs < 0))
    return ArmDifference("b", 2**pair.a.n, joints) if joints else None


def _shifted(pair: Pair, rule: Side | None) -> ArmDifference | None:
    joints = tuple(
        (i, float(offset))
        for i, offset in enumerate(pair.alignment.offsets, 1)
        if abs(offset) > SAME_ANGLE
    )
    return ArmDifference("b", pair.a.n, joints) if joints else None


def _base_turned(pair: Pair, rule: Side | None) -> ArmDifference | None:
    T_ab = pair.alignment.T_ab
    return ArmDifference(None, base=T_ab) if T_ab.angle() > SAME_ANGLE else None


def _gravities(pair: Pair) -> tuple[Array, Array] | None:
    """Both arms' gravity, where it differs."""
    g_a, g_b = pair.a.gravity, pair.b.gravity
    size = float(np.linalg.norm(g_a))
    return (g_a, g_b) if np.abs(g_a - g_b).max() > _SAME_GRAVITY * size else None


def _parallel(g_a: Array, g_b: Array) -> bool:
    across = float(np.linalg.norm(np.cross(g_a, g_b)))
    return across <= SAME_ANGLE * float(np.linalg.norm(g_a) * np.linalg.norm(g_b))


def _gravity_up(pair: Pair, rule: Side | None) -> ArmDifference | None:
    gravities = _gravities(pair)
    if gravities is None or not _parallel(*gravities) or float(gravities[0] @ gravities[1]) >= 0.0:
        return None
    return ArmDifference(None, gravity=gravities)


def _gravity_size(pair: Pair, rule: Side | None) -> ArmDifference | None:
    gravities = _gravities(pair)
    if gravities is None or not _parallel(*gravities) or float(gravities[0] @ gravities[1]) < 0.0:
        return None
    return ArmDifference(None, gravity=gravities)


def _gravity_tilted(pair: Pair, rule: Side | None) -> ArmDifference | None:
    gravities = _gravities(pair)
    if gravities is None or _parallel(*gravities):
        return None
    return ArmDifference(None, gravity=gravities)


def _gravity_of_a(arm: SerialArm, found: ArmDifference, T: Transform) -> SerialArm:
    return arm.with_gravity(T.R @ found.gravity[0])


def _motors(pair: Pair, rule: Side | None) -> ArmDifference | None:
    motors = np.stack([pair.a.armature, pair.b.armature])
    apart = np.abs(motors[0] - motors[1]) > _SAME_MOTOR * motors.max(axis=0)
    if not apart.any():
        return None
    joints = tuple((int(i) + 1, float(motors[0, i])) for i in np.flatnonzero(apart))
    return ArmDifference(None, joints=joints, motors=motors)


def _motors_of_a(arm: SerialArm, found: ArmDifference, T: Transform) -> SerialArm:
    return arm.with_armature(found.motors[0])


_EXCHANGE = "poses, angles and gravity that one model gives mean something else to the other"
_WEIGHT = "gravity torque, the largest part of a slow arm's torque, is wrong in every posture"

#: Found by `Pair.corrections`, before the arms are aligned.
ROUNDED: tuple[ArmMistake, ...] = (
    ArmMistake(
        id="rotation-rounded",
        rule_id="CMP164",
        says="the twist (α or rpy) is a rounded part of π",
        sentence="Rounded digits in {arm}: {rounded}",
        repair="write π/2 with all digits",
        bad="α = 1.5707 rad",
        good="α = 1.5707963267948966 rad",
        affects="axes, by the angle that is left out",
        why="axes that are parallel or at right angles in one model are not in the other",
        find=_not_searched,
        sources=("paper-listing",),
    ),
    ArmMistake(
        id="twelfth-rounded",
        rule_id="CMP165",
        says="1/12 in a cylinder's moment is cut off",
        sentence="Rounded digits in {arm}: {rounded}",
        repair="write 1/12 with all digits",
        bad="0.0833 m l²",
        good="m l² / 12",
        affects="tensors",
        why="moments of inertia are too small in the digit after the last that was written",
        find=_not_searched,
        sources=("paper",),
    ),
)

ARM_MISTAKES: tuple[ArmMistake, ...] = (
    ArmMistake(
        id="dh-convention",
        rule_id="CMP201",
        says="the DH table reads by the other convention",
        sentence="The DH table of {arm} reads by the other convention (standard, modified)",
        repair='say which: convention = "standard" or "modified"',
        bad="a table of Craig's convention read by the standard one",
        good="a table that names its convention",
        affects="all lengths and twists",
        why="every length and twist moves to the neighbouring joint: another arm",
        find=_other_convention,
        sources=("petercorke/robotics-toolbox-python#688",),
    ),
    ArmMistake(
        id="joint-reversed",
        rule_id="CMP202",
        severity="note",
        says="joints turn the other way",
        sentence="Reversed in {b}: {joints}",
        repair="compare at q_b = −q_a there",
        bad="axis (0, 0, −1) in one file",
        good="axis (0, 0, 1) in both",
        affects="nothing: a convention",
        why=_EXCHANGE,
        find=_reversed,
        changes_torque=False,
        sources=("petercorke/robotics-toolbox-python#290",),
    ),
    ArmMistake(
        id="zero-shifted",
        rule_id="CMP203",
        severity="note",
        says="joints count from another zero",
        sentence="Another zero in {b}: {joints} ({angles})",
        repair="add the offset when states are exchanged",
        bad="q = 0 stretches the arm in one file and folds it in the other",
        good="one zero posture in both",
        affects="nothing: a convention",
        why=_EXCHANGE,
        find=_shifted,
        changes_torque=False,
        sources=("petercorke/robotics-toolbox-python#290",),
    ),
    ArmMistake(
        id="base-turned",
        rule_id="CMP204",
        severity="note",
        says="the base stands another way",
        sentence="The base of {b} is {base}",
        repair="turn poses, and gravity, when they are exchanged",
        bad="a base frame turned by 180° about z against the other file's",
        good="one base frame in both",
        affects="nothing: a convention",
        why=_EXCHANGE,
        find=_base_turned,
        changes_torque=False,
        sources=(
            "ros-industrial/universal_robot#505",
            "petercorke/robotics-toolbox-python#290",
        ),
    ),
    ArmMistake(
        id="gravity-sign",
        rule_id="CMP205",
        says="gravity points up in one of the two",
        sentence="Gravity points up in one of the two",
        repair="compare under one gravity: --gravity X Y Z",
        bad="(0, 0, 9.81) m/s² for an arm that stands on the floor",
        good="(0, 0, −9.81) m/s²",
        affects="gravity",
        why=_WEIGHT,
        find=_gravity_up,
        repaired=_gravity_of_a,
        sources=("JuliaRobotics/RigidBodyDynamics.jl#2",),
    ),
    ArmMistake(
        id="gravity-value",
        rule_id="CMP206",
        says="gravity has another size",
        sentence="Gravity is {gravity} m/s² in {a} and {b}",
        repair="compare under one gravity: --gravity X Y Z",
        bad="9.806 m/s² in one model, 9.81 m/s² in the other",
        good="one size in both",
        affects="gravity",
        why=_WEIGHT,
        find=_gravity_size,
        repaired=_gravity_of_a,
        sources=("paper-listing",),
    ),
    ArmMistake(
        id="gravity-direction",
        rule_id="CMP207",
        says="gravity points another way",
        sentence="Gravity points another way",
        repair="compare under one gravity: --gravity X Y Z",
        bad="(0, −9.81, 0) m/s² in one model, (0, 0, −9.81) m/s² in the other",
        good="one vector in both, in one base frame",
        affects="gravity",
        why=_WEIGHT,
        find=_gravity_tilted,
        repaired=_gravity_of_a,
    ),
    ArmMistake(
        id="motor-inertia",
        rule_id="CMP208",
        says="a motor's inertia is in one model only, or differs",
        sentence="The motor inertia of {joints} is {motors}",
        repair="reflect it through the gear, n² J, in both models or in neither",
        bad="armature in an MJCF, none in the URDF",
        good="n² J at the joint in both",
        affects="motor inertia",
        why="the torque that accelerates the motors is missing: with a gear of 100 it is often "
        "larger than the link's own",
        find=_motors,
        repaired=_motors_of_a,
    ),
)
