"""The joints, tool, base and gravity that an engine holds, against the file's."""

from __future__ import annotations

import numpy as np

from ..._robot.serial_arm import Joint, SerialArm
from ..._robot.transforms import Array
from ..imported_model import ImportedModel, strict_imported_model
from .audit_tolerances import pose_rounding, same_number
from .import_difference import ImportDifference, Kind
from .written_bodies import written_arm

__all__ = ["frame_differences", "joint_differences"]

#: Writers put the largest double where a file must name a limit and nobody knows one; zero for a
#: velocity or an effort means the same, since it would forbid all motion.
_NO_LIMIT = 1e100


def joint_differences(imported_model: ImportedModel, arm: SerialArm) -> list[ImportDifference]:
    """Order first, then joint by joint: axis, motor, limits, damping, friction."""
    names = tuple(joint.name for joint in imported_model.joints)
    found = []
    if names != arm.joint_names:
        found.append(ImportDifference("order", "", ", ".join(arm.joint_names), ", ".join(names)))
    held = {joint.name: joint for joint in imported_model.joints}
    for i, written in enumerate(strict_imported_model(arm).joints):
        if written.name in held:
            found += _of_joint(written, held[written.name], arm, i)
    return found


def _of_joint(written: Joint, held: Joint, arm: SerialArm, i: int) -> list[ImportDifference]:
    where = f"joint {written.name!r}"
    found = []
    if np.abs(written.axis - held.axis).max() > pose_rounding(arm):
        words = (_list(written.axis), _list(held.axis))
        found.append(ImportDifference("axis", where, *words, i))
    for kind, before, after in _numbers(written, held):
        if not all(same_number(a, b) for a, b in zip(before, after, strict=True)):
            words = (_shown(before), _shown(after))
            found.append(ImportDifference(kind, where, *words, i))
    return found


def _numbers(
    written: Joint, held: Joint
) -> list[tuple[Kind, tuple[float | None, ...], tuple[float | None, ...]]]:
    a, b = written.limits, held.limits
    return [
        ("armature", (written.armature,), (held.armature,)),
        ("position-limit", _known(a.lower, a.upper), _known(b.lower, b.upper)),
        ("velocity-limit", _known(a.velocity or None), _known(b.velocity or None)),
        ("effort-limit", (a.known_effort,), (b.known_effort,)),
        ("damping", (written.damping,), (held.damping,)),
        ("friction", (written.friction,), (held.friction,)),
    ]


def frame_differences(imported_model: ImportedModel, arm: SerialArm) -> list[ImportDifference]:
    """Gravity, tool, coordinates, and what became of the base's inertia."""
    found = []
    g = imported_model.gravity
    if not all(same_number(*pair) for pair in zip(g, arm.gravity, strict=True)):
        words = (f"{_list(arm.gravity)} m/s²", f"{_list(g)} m/s²")
        found.append(ImportDifference("gravity", "", *words))
    tool = strict_imported_model(arm).tool
    if np.abs(tool - imported_model.tool).max() > pose_rounding(arm):
        words = (f"at {_list(tool[:3, 3])} m", f"at {_list(imported_model.tool[:3, 3])} m")
        found.append(ImportDifference("tool", f"frame {arm.source.tip!r}", *words))
    if imported_model.coordinates != arm.n:
        words = (f"{arm.n} joints", f"{imported_model.coordinates} position coordinates")
        found.append(ImportDifference("coordinates", "", *words))
    standing = written_arm(arm).standing
    if standing:
        kept = any(body.carried_by is None and body.inertia.mass for body in imported_model.bodies)
        held = "kept" if kept else "left out"
        kind: Kind = "base-kept" if kept else "base-ignored"
        names = ", ".join(map(repr, standing))
        found.append(ImportDifference(kind, "", names, held))
    return found


def _known(*limits: float | None) -> tuple[float | None, ...]:
    return tuple(None if x is None or abs(x) >= _NO_LIMIT else x for x in limits)


def _shown(values: tuple[float | None, ...]) -> str:
    if all(value is None for value in values):
        return "none"
    return " to ".join("none" if value is None else f"{value:.6g}" for value in values)


def _list(vector: Array) -> str:
    return f"({', '.join(f'{value + 0.0:.4g}' for value in np.round(vector, 12))})"
