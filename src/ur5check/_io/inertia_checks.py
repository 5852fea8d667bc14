"""Could a real body have this inertia?  One judgement for URDF, DH tables and a `pin.Model`.

A body of positive density has a positive mass and a positive definite tensor about its centre of
mass whose principal moments keep the triangle inequality, I_a + I_b ≥ I_c.  The second says the
same as: Σ = ½ tr(I) 1 − I has no negative eigenvalue (Wensing, Kim & Slotine 2018).

Tolerance.  Each entry may be off by the rounding h_ij of its printed digits.  A symmetric E with
|E_ij| ≤ H_ij moves no eigenvalue by more than its spectral norm, and that is at most H's.  Beside
it stand a few ulp for the eigenvalue solver itself.  Nothing else is forgiven.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from .._errors import ModelError
from .._robot.transforms import Array

__all__ = ["Flaw", "Place", "check_inertia", "find_flaw", "printed_tensor"]

_SOLVER_ULPS = 16  # of the largest moment: eigvalsh's own error on 3×3


@dataclass(frozen=True)
class Flaw:
    """Why no body has this inertia.  part : which of its numbers is at fault."""

    part: Literal["mass", "inertia"]
    problem: str
    fix: str
    value: object


@dataclass(frozen=True)
class Place:
    """Where an inertia was written, for an error."""

    file: str | None
    element: str
    mass_line: int | None = None
    inertia_line: int | None = None


def printed_tensor(entries: dict[str, float]) -> tuple[Array, Array]:
    """The tensor of entries ixx … izz and the roundings h_ij of their digits, each (3, 3) [kg m²].

    An entry that is a `Printed` knows its rounding; any other number is exact.
    """
    tensor, rounding = np.zeros((3, 3)), np.zeros((3, 3))
    for i, a in enumerate("xyz"):
        for j, b in enumerate("xyz"):
            entry = entries["i" + min(a, b) + max(a, b)]
            tensor[i, j] = entry
            rounding[i, j] = getattr(entry, "rounding", 0.0)
    return tensor, rounding


def find_flaw(
    mass: float, tensor: Array, *, rounding: Array | float = 0.0, point_mass: bool = False
) -> Flaw | None:
    """What keeps a real body from having this inertia; None if nothing does.

    mass : [kg];  tensor : about the centre of mass, (3, 3) [kg m²]
    rounding : how far each entry may be off, (3, 3) or one number [kg m²]
    point_mass : take a mass without any extent, the limit of ever smaller bodies

    No mass and no tensor together are no flaw: that is a mere frame.
    """
    if mass < 0.0:
        return Flaw("mass", "mass is negative", "give the mass in kilograms, above zero", mass)
    if not tensor.any() and (mass == 0.0 or point_mass):
        return None
    if mass == 0.0:
        problem = "mass is zero although the inertia is not"
        return Flaw("mass", problem, "give the mass, or leave the inertial out", mass)
    moments = np.linalg.eigvalsh(tensor)
    solver = _SOLVER_ULPS * np.finfo(float).eps * np.abs(moments).max()
    H = np.broadcast_to(np.asarray(rounding, dtype=np.float64), (3, 3))
    shown = "principal moments " + ", ".join(f"{moment:.6g}" for moment in moments)
    if not moments[0] + np.linalg.norm(H, 2) - solver > 0.0:
        problem = "inertia tensor is not positive definite"
        return Flaw("inertia", problem, "check the six entries, their signs and units", shown)
    # Σ's entries move by at most G: half the trace's rounding on the diagonal, h_ij beside it.
    G = H - np.diag(np.diag(H)) + np.trace(H) / 2 * np.eye(3)
    least = np.trace(tensor) / 2 - moments[2]
    if least + np.linalg.norm(G, 2) + solver < 0.0:
        problem = "inertia tensor breaks the triangle inequality: one moment exceeds the other two"
        fix = "no body of positive density has it; check the six entries"
        return Flaw("inertia", problem, fix, shown)
    return None


def check_inertia(
    mass: float,
    tensor: Array,
    place: Place,
    *,
    rounding: Array | float = 0.0,
    point_mass: bool = False,
) -> None:
    """Raise ModelError, naming `place`, if `find_flaw` finds a flaw."""
    flaw = find_flaw(mass, tensor, rounding=rounding, point_mass=point_mass)
    if flaw is not None:
        line = place.mass_line if flaw.part == "mass" else place.inertia_line
        raise ModelError(
            flaw.problem,
            fix=flaw.fix,
            file=place.file,
            line=line,
            element=f"{place.element}{flaw.part}",
            value=flaw.value,
        )
