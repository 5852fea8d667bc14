"""Alignments in words: which joints are reversed and shifted, what stays unknown."""

from __future__ import annotations

import math

from .._comparison.alignment import SAME_ANGLE, Alignment
from .._comparison.alignment_paths import Undetermined
from .._robot.serial_arm import Joint, SerialArm

__all__ = ["alignment_in_words", "nearest_in_words", "offset_in_words", "unknown_in_words"]


def offset_in_words(joint: Joint, offset: float) -> str:
    """A joint's zero offset, in degrees or millimetres."""
    sliding = joint.kind == "prismatic"
    return f"{1e3 * offset:+.4g} mm" if sliding else f"{math.degrees(offset):+.6g}°"


def alignment_in_words(alignment: Alignment, a: SerialArm) -> str:
    """An alignment as "j4 shifted by +180°, j5 reversed"; the joints of arm a."""
    parts = []
    for joint, sign, offset in zip(a.joints, alignment.signs, alignment.offsets, strict=True):
        if sign < 0:
            parts.append(f"{joint.name} reversed")
        if abs(offset) > SAME_ANGLE:
            parts.append(f"{joint.name} shifted by {offset_in_words(joint, float(offset))}")
    if alignment.T_ab.angle() > SAME_ANGLE:
        parts.append(f"the base turned by {math.degrees(alignment.T_ab.angle()):.4g}°")
    return ", ".join(parts) or "joint angles unchanged"


def nearest_in_words(nearest: Alignment, a: SerialArm) -> str:
    """The alignment that all but makes the axes coincide, and by how much it fails."""
    return (
        f"with {alignment_in_words(nearest, a)} all axes would coincide to "
        f"{nearest.axis_angle.max():.1e} rad and {1e3 * nearest.axis_distance.max():.2g} mm; joint "
        "angles are compared as they are written"
    )


def unknown_in_words(unknown: Undetermined, a: SerialArm) -> str:
    """A zero that nothing determines, and why."""
    zero = f"the zero of joint {unknown.joint} ({a.joints[unknown.joint - 1].name})"
    if unknown.reason == "tool":
        return (
            f"{zero}: only a common tool frame would show it, and these arms have none; torques do "
            "not show it either"
        )
    return f"{zero}: it turns about the axis of the next, only their sum shows"
