"""What else differs between two arms: gravity, mass, tool, friction, motors and limits."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .._finding import Place
from .._robot.serial_arm import NO_LIMIT, Joint
from .alignment import SAME_ANGLE, SAME_LENGTH
from .arm_pair import Pair

__all__ = ["OtherNumber", "compare_other_numbers"]

#: Two numbers are the same to this part of their size: fewer digits than files carry.  Limits are
#: moved by offsets of the alignment, which are known to 1e-6 rad.
_SAME = 1e-6


@dataclass(frozen=True)
class OtherNumber:
    """A number that differs.

    Attributes
    ----------
    quantity : str
        "damping", "effort limit", …
    unit : str
        Of both values.
    joint : str
        Name of the joint, in a; "" where it is about the arm.
    a, b : float, tuple of float or None
        The values, in a's joint coordinates and base frame; three for a vector, None where a
        source gives none.
    place_a, place_b : Place
        Where they are written, as far as that is known.
    moves_joints : bool
        Whether a simulator or a controller would move the joints differently: not for the tool's
        frame or a total mass that changes no torque, nor where one source is silent.
    """

    quantity: str
    unit: str
    joint: str
    a: float | tuple[float, ...] | None
    b: float | tuple[float, ...] | None
    place_a: Place = field(default_factory=Place)
    place_b: Place = field(default_factory=Place)
    moves_joints: bool = True


def compare_other_numbers(pair: Pair) -> tuple[OtherNumber, ...]:
    """Those that differ, of the arm, then joint by joint; or that only one of the two gives."""
    found = []
    mass_a, mass_b = (float(sum(x.inertia.mass for x in arm.links)) for arm in (pair.a, pair.b))
    if _differ(mass_a, mass_b):
        found.append(OtherNumber("total mass", "kg", "", mass_a, mass_b, moves_joints=False))
    g_a, g_b = (tuple(map(float, arm.gravity)) for arm in (pair.a, pair.b))
    if float(np.abs(np.subtract(g_a, g_b)).max()) > _SAME * float(np.linalg.norm([g_a, g_b])):
        found.append(OtherNumber("gravity", "m/s²", "", g_a, g_b))
    tool = pair.alignment.tool
    if pair.alignment.exact and (
        tool.angle() > SAME_ANGLE or float(np.abs(tool.p).max()) > SAME_LENGTH
    ):
        shift = tuple(map(float, tool.p))
        zero = (0.0, 0.0, 0.0)
        found.append(OtherNumber("tool position", "m", "", zero, shift, moves_joints=False))
        found.append(
            OtherNumber("tool angle", "rad", "", 0.0, float(tool.angle()), moves_joints=False)
        )
    for a, b, given in zip(pair.a.joints, pair.b.joints, pair.given_b.joints, strict=True):
        found += _of_joint(a, b, given)
    return tuple(found)


def _of_joint(a: Joint, b: Joint, given: Joint) -> list[OtherNumber]:
    slides = a.kind == "prismatic"
    length, effort = ("m", "N") if slides else ("rad", "N m")
    rows: list[tuple[str, str, float | None, float | None]] = [
        ("damping", f"{effort} s/{length}", a.damping, b.damping),
        ("friction", effort, a.friction, b.friction),
        ("motor inertia", "kg" if slides else "kg m²", a.armature, b.armature),
        ("lower limit", length, a.limits.lower, b.limits.lower),
        ("upper limit", length, a.limits.upper, b.limits.upper),
        ("velocity limit", f"{length}/s", a.limits.velocity, b.limits.velocity),
        ("effort limit", effort, a.limits.effort, b.limits.effort),
    ]
    found = []
    for quantity, unit, *values in rows:
        one, other = map(_known, values)
        if _differ(one, other):
            part = "limit" if quantity.endswith("limit") else "dynamics"
            at_a, at_b = (joint.places.get(part, Place()) for joint in (a, given))
            moves = one is not None and other is not None
            found.append(OtherNumber(quantity, unit, a.name, one, other, at_a, at_b, moves))
    return found


def _known(value: float | None) -> float | None:
    """None also for the largest double, which writers put where a limit must stand."""
    return None if value is None or abs(value) >= NO_LIMIT else value


def _differ(a: float | None, b: float | None) -> bool:
    if a is None or b is None:
        return a is not b
    return abs(a - b) > _SAME * max(abs(a), abs(b))
