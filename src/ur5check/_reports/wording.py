"""Numbers, joint states and places as text."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import PurePath

from .._finding import Place
from .._robot.serial_arm import Joint, SerialArm
from .._robot.transforms import Array

__all__ = [
    "MISSING",
    "coordinates",
    "figures",
    "joined",
    "link_label",
    "percent",
    "posture",
    "residue",
    "titled",
    "where",
]

#: What stands in a table where there is no number.
MISSING = "–"


def figures(value: float | None) -> str:
    """Four significant digits; two for what is close to zero (4.5e-14)."""
    if value is None or math.isnan(value):
        return MISSING
    if value == 0.0 or math.isinf(value):
        return f"{value:.0f}".replace("-0", "0")
    size = abs(value)
    if size < 1e-6:
        return f"{value:.1e}"
    if size < 1e-3 or size >= 1e5:
        return f"{value:.3e}"
    # `#` keeps the zeros that were measured: 7.400, not 7.4.  Rounding up may leave a bare point.
    return f"{value:#.4g}".removesuffix(".") if size < 9999.5 else f"{value:.0f}"


def residue(value: float) -> str:
    """Two significant digits for what should be zero and nearly is; else four."""
    return f"{value:.1e}" if 0.0 < abs(value) < 1e-3 else figures(value)


def percent(share: float | None) -> str:
    """A share in percent, to a hundredth."""
    return MISSING if share is None or math.isnan(share) else f"{100 * share:.2f}"


def coordinates(vector: Array, unit: float = 1.0) -> str:
    """`(x, y, z)`, each divided by `unit`."""
    return f"({', '.join(f'{round(float(x) / unit, 9) + 0.0:.6g}' for x in vector)})"


def posture(q: Sequence[float], joints: Sequence[Joint]) -> str:
    """Joint positions to the degree; a sliding joint's to the millimetre."""
    parts = []
    for value, joint in zip(q, joints, strict=True):
        sliding = joint.kind == "prismatic"
        parts.append(f"{1e3 * value:.0f}mm" if sliding else str(round(math.degrees(value))))
    return " ".join(part.rjust(4) for part in parts)


def link_label(name_a: str, name_b: str) -> str:
    """One name for a link that two sources may name differently."""
    return name_a if name_a == name_b else f"{name_a} / {name_b}"


def titled(arm: SerialArm) -> str:
    """An arm's label; where that is not its name, also the name and, for a letter, the file."""
    if arm.label == arm.name:
        return arm.label
    files = [name for name, _ in arm.source.inputs[:1] if PurePath(name).name != arm.label]
    return f"{arm.label} ({', '.join([arm.name, *files])})"


def joined(parts: Sequence[str]) -> str:
    """`a`, `a and b`, `a, b and c`; nothing of nothing."""
    return " and ".join(part for part in (", ".join(parts[:-1]), *parts[-1:]) if part)


def where(place: Place, file: str) -> str:
    """`line 12:5`, or with the name of a file other than `file`; "" where it is unknown."""
    if place.line == 0:
        return "" if place.file == file else place.file
    if place.file not in ("", file):
        return str(place)
    return f"line {replace(place, file='')}"
