"""An impossible body as an error of a file's reader, for formats that give one chain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .._errors import ModelError
from .._robot.pseudo_inertia import EXACT, DigitBounds, Fault, judge_body
from .._robot.transforms import Array
from .printed_numbers import common_rounding

__all__ = ["Place", "check_inertia", "printed_tensor"]

#: For each fault: the rule that it breaks, what is wrong, what to do.
_FAULTS: dict[Fault, tuple[str, str, str]] = {
    "mass-negative": (
        "INE101",
        "mass is negative",
        "give the mass in kilograms, above zero",
    ),
    "mass-zero": (
        "INE101",
        "mass is zero although the inertia is not",
        "give the mass, or leave the inertial out",
    ),
    "not-positive-definite": (
        "INE102",
        "inertia tensor is not positive definite",
        "check the six entries, their signs and units",
    ),
    "triangle-inequality": (
        "INE103",
        "inertia tensor breaks the triangle inequality: one moment exceeds the other two",
        "no body of positive density has it; check the six entries",
    ),
}


@dataclass(frozen=True)
class Place:
    """Where an inertia was written, for an error."""

    file: str | None
    element: str
    mass_line: int | None = None
    inertia_line: int | None = None


def printed_tensor(entries: Mapping[str, float]) -> tuple[Array, DigitBounds]:
    """The tensor of entries ixx … izz, (3, 3) [kg m²], and what their printed digits leave open.

    An entry that is a `Printed` knows its rounding; any other number is exact.
    """
    rounding = common_rounding(entries)
    tensor, H = np.zeros((3, 3)), np.zeros((3, 3))
    for i, a in enumerate("xyz"):
        for j, b in enumerate("xyz"):
            name = "i" + min(a, b) + max(a, b)
            tensor[i, j], H[i, j] = entries[name], rounding[name]
    return tensor, DigitBounds.of(H)


def check_inertia(
    mass: float,
    tensor: Array,
    place: Place,
    *,
    digits: DigitBounds = EXACT,
    point_mass: bool = False,
) -> None:
    """Raise ModelError, naming `place`, for an inertia that no body has (`judge_body`).

    tensor : about the centre of mass, (3, 3) [kg m²]
    point_mass : take a mass without any extent, the limit of ever smaller bodies
    """
    body = judge_body(mass, tensor, digits)
    fault = body.fault
    if fault is None and mass > 0.0 and not body.has_tensor and not point_mass:
        fault = "not-positive-definite"
    if fault is None:
        return
    rule, problem, fix = _FAULTS[fault]
    of_mass = rule == "INE101"
    shown = "principal moments " + ", ".join(f"{moment:.6g}" for moment in body.moments)
    raise ModelError(
        problem,
        fix=fix,
        file=place.file,
        line=place.mass_line if of_mass else place.inertia_line,
        element=f"{place.element}{'mass' if of_mass else 'inertia'}",
        value=mass if of_mass else shown,
        rule=rule,
    )
