"""The joints, tool, base and gravity that an engine imported against those of the file."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.serial_arm import Joint
from ..._robot.transforms import Array
from ..imported_model import ImportedModel, strict_imported_model
from .audit_tolerances import pose_rounding, same_number
from .import_difference import ImportDifference, Kind
from .written_bodies import written_arm

__all__ = ["frame_differences", "joint_differences"]

#: Writers put the largest double where a file must name a limit and none is known; zero for a
#: velocity or an effort means the same, since it would forbid all motion.
_NO_LIMIT = 1e100

#: So many joints are listed, in order.
_FEW = 8

#: Units of the numbers of a joint: revolute, prismatic.
_UNITS: dict[Kind, tuple[str, str]] = {
    "armature": ("kg m²", "kg"),
    "velocity-limit": ("rad/s", "m/s"),
    "effort-limit": ("N m", "N"),
    "damping": ("N m s/rad", "N s/m"),
    "friction": ("N m", "N"),
}


def joint_differences(imported_model: ImportedModel, arm: ArmOrTree) -> list[ImportDifference]:
    """Order first, then joint by joint: place, axis, motor, limits, damping, friction."""
    names = [joint.name for joint in imported_model.joints]
    wanted = [link.joint.name for link in tree_links(arm)]
    found = []
    if names != wanted:
        found.append(ImportDifference("order", "", *_where_they_part(wanted, names)))
    strict = strict_imported_model(arm)
    for i, written in enumerate(strict.joints):
        if written.name in names:
            k = names.index(written.name)
            found += _moved(written.name, strict.origins[i], imported_model.origins[k], arm, i)
            found += _of_joint(written, imported_model.joints[k], arm, i)
    return found


def _where_they_part(wanted: list[str], names: list[str]) -> tuple[str, str]:
    """Two orders of joints in words; of many joints, a few from the first that differs."""
    both = list(zip(wanted, names, strict=False))
    first = next((k for k, (a, b) in enumerate(both) if a != b), len(both))
    if max(len(wanted), len(names)) <= _FEW:
        first, last = 0, _FEW
    else:
        last = first + _FEW // 2

    def shown(order: list[str]) -> str:
        parts = ["…"] * (first > 0) + order[first:last] + ["…"] * (len(order) > last)
        return ", ".join(parts)

    return shown(wanted), shown(names)


def _moved(
    name: str, written: Array, imported: Array, arm: ArmOrTree, i: int
) -> list[ImportDifference]:
    """A joint that the engine has at another point of the base frame, all joints at zero."""
    if np.abs(written - imported).max() <= pose_rounding(arm):
        return []
    words = (f"at {_list(written)} m", f"at {_list(imported)} m")
    return [ImportDifference("joint-moved", f"joint {name!r}", *words, i)]


def _of_joint(written: Joint, imported: Joint, arm: ArmOrTree, i: int) -> list[ImportDifference]:
    where = f"joint {written.name!r}"
    found = []
    if np.abs(written.axis - imported.axis).max() > pose_rounding(arm):
        words = (_list(written.axis), _list(imported.axis))
        found.append(ImportDifference("axis", where, *words, i))
    for kind, before, after in _numbers(written, imported):
        if not all(same_number(a, b) for a, b in zip(before, after, strict=True)):
            words = (_shown(before), _shown(after))
            one = ImportDifference(kind, where, *words, i)
            if len(before) == 1:
                unit = _UNITS[kind][written.kind == "prismatic"]
                one = replace(one, value=after[0], bound=before[0], unit=unit)
            found.append(one)
    return found


def _numbers(
    written: Joint, imported: Joint
) -> list[tuple[Kind, tuple[float | None, ...], tuple[float | None, ...]]]:
    a, b = written.limits, imported.limits
    return [
        ("armature", (written.armature,), (imported.armature,)),
        ("position-limit", _known(a.lower, a.upper), _known(b.lower, b.upper)),
        ("velocity-limit", _known(a.velocity or None), _known(b.velocity or None)),
        ("effort-limit", (a.known_effort,), (b.known_effort,)),
        ("damping", (written.damping,), (imported.damping,)),
        ("friction", (written.friction,), (imported.friction,)),
    ]


def frame_differences(imported_model: ImportedModel, arm: ArmOrTree) -> list[ImportDifference]:
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
    n = len(tree_links(arm))
    if imported_model.coordinates != n:
        words = (f"{n} joints", f"{imported_model.coordinates} position coordinates")
        found.append(ImportDifference("coordinates", "", *words))
    on_base = written_arm(arm).on_base
    if on_base:
        kept = any(body.carried_by is None and body.inertia.mass for body in imported_model.bodies)
        outcome = "kept" if kept else "left out"
        kind: Kind = "base-kept" if kept else "base-ignored"
        names = ", ".join(map(repr, on_base))
        found.append(ImportDifference(kind, "", names, outcome))
    return found


def _known(*limits: float | None) -> tuple[float | None, ...]:
    return tuple(None if x is None or abs(x) >= _NO_LIMIT else x for x in limits)


def _shown(values: tuple[float | None, ...]) -> str:
    if all(value is None for value in values):
        return "none"
    return " to ".join("none" if value is None else f"{value:.6g}" for value in values)


def _list(vector: Array) -> str:
    return f"({', '.join(f'{value + 0.0:.4g}' for value in np.round(vector, 12))})"
