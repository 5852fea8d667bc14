"""Physical consistency of ten inertial parameters: pseudo-inertia and triangle inequality."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ..._robot.serial_arm import Link

__all__ = ["Plausibility", "Severity", "body_findings"]

Severity = Literal["note", "suspicious", "impossible"]

#: Least of I_a + I_b − I_c as a share of I_c below which a body is nearly flat.  A plate that is a
#: hundred times wider than thick has 2e-4: no link of an arm is one.
_FLAT = 1e-3


@dataclass(frozen=True)
class Plausibility:
    """One implausible number of an arm.

    severity : "note", "suspicious" (outside the range of robot arms) or "impossible" (for such a
        body)
    link, name : number, from 1, and name; None and the arm's name for the whole arm
    quantity : what was checked;  value, bound, unit : the number and its bound; None where there
        is no number
    sentence : for the report
    """

    severity: Severity
    link: int | None
    name: str
    quantity: str
    value: float | None
    bound: float | None
    unit: str
    sentence: str


def body_findings(number: int, link: Link) -> list[Plausibility]:
    """Whether some distribution of positive mass has this inertia.

    J is positive definite exactly if m > 0 and the second moment about the centre of mass,
    Σ_c = ½ tr(I_c) 1 − I_c, is (a Schur complement).  The eigenvalues of Σ_c are half the margins
    of the triangle inequality.  A tensor that is not positive definite breaks one of them too.
    """
    body, name = link.inertia.judged(), link.name
    moments, largest, margin, m = body.moments, body.largest, body.margin, body.mass
    if not body.mass_possible:
        sentence = f"{name}: a mass of {m:.4g} kg with an inertia: no body has these."
        return [Plausibility("impossible", number, name, "mass", m, 0.0, "kg", sentence)]
    if m == 0.0:
        sentence = f"{name} moves but has no mass."
        return [Plausibility("note", number, name, "mass", 0.0, 0.0, "kg", sentence)]
    if not body.has_tensor:
        sentence = f"{name}: {m:.4g} kg in one point; a body has extent, and an inertia tensor."
        quantity = "pseudo-inertia"
        return [Plausibility("suspicious", number, name, quantity, 0.0, 0.0, "m²", sentence)]
    if body.fault == "not-positive-definite":
        # Least eigenvalue of Σ_c per kilogram: a mean square distance, which cannot be negative.
        sentence = (
            f"{name}: the inertia tensor has a negative principal moment, {moments[0]:.4g} kg m²: "
            "the pseudo-inertia is not positive definite, and no mass distribution has it."
        )
        spread = margin / (2.0 * m)
        quantity = "pseudo-inertia"
        return [Plausibility("impossible", number, name, quantity, spread, 0.0, "m²", sentence)]
    if body.fault == "triangle-inequality":
        sentence = (
            f"{name}: principal moments {', '.join(f'{x:.4g}' for x in moments)} kg m² break the "
            f"triangle inequality by {-margin / largest:.2%} of the largest: one moment exceeds "
            "the sum of the others, as for no body of positive density."
        )
        return [_triangle("impossible", number, name, margin, sentence)]
    if moments[0] <= body.moment_tolerance:
        sentence = f"{name}: no inertia about one axis; only a line without thickness has that."
        quantity, least = "principal moment", float(moments[0])
        return [Plausibility("suspicious", number, name, quantity, least, 0.0, "kg m²", sentence)]
    if margin < _FLAT * largest:
        sentence = (
            f"{name}: the triangle inequality holds with a margin of only {margin / largest:.1e} "
            "of the largest moment, as for a body without thickness."
        )
        return [_triangle("note", number, name, margin, sentence)]
    return []


def _triangle(
    severity: Severity, number: int, name: str, margin: float, sentence: str
) -> Plausibility:
    quantity = "triangle inequality"
    return Plausibility(severity, number, name, quantity, margin, 0.0, "kg m²", sentence)
