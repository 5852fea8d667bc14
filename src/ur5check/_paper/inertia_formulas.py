"""Which formula made each printed tensor: eqs 3 to 8, or a mistake of them.

Eqs 3–8 are those of a solid cylinder along z: I_xx = I_yy = m (3 r² + l²)/12 and I_zz = m r²/2.
The listing prints numbers, not radii.  The cylinders are the appendix's, read back from its tensors
as round lengths; every plausible formula is then tried on every cylinder, and one is
accepted if it gives the printed digits.  Nine digits rule out coincidence among a few dozen.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._comparison.diagnosis.cylinder_fit import fit_cylinder
from .._comparison.rounded_constants.cylinder_constant import CutTwelfth, cut_twelfths
from .._comparison.rounded_constants.decimals import half_units
from .._robot.serial_arm import SerialArm

__all__ = ["EQ_3", "FORMULAS", "Formula", "TensorFormula", "tensor_formulas", "which_formula"]


@dataclass(frozen=True)
class Formula:
    """I_xx = I_yy = m (k r² + l²) · twelfth.

    text : as it would be written;  k : 3 in eq. 3, 9 where 3r was squared
    honest : whether it is eq. 3, to the digits of its constant
    """

    text: str
    k: float
    twelfth: float
    honest: bool

    def across(self, mass: float, radius: float, length: float) -> float:
        """I_xx = I_yy [kg m²] of a cylinder, in [kg] and [m]."""
        return mass * (self.k * radius**2 + length**2) * self.twelfth


_SQUARES = (
    ("3r² + l²", 3.0),
    ("(3r)² + l²", 9.0),
    ("r² + l²", 1.0),
    ("6r² + l²", 6.0),
    ("l²", 0.0),
)
_TWELFTHS = (
    ("1/12", 1.0 / 12.0),
    *((f"0.08{'3' * n}", float(f"0.08{'3' * n}")) for n in range(1, 8)),
)

#: Eq. 3 first, then other ways to write it, wrong ones included.
FORMULAS = tuple(
    Formula(
        f"m({square})/12" if twelfth == "1/12" else f"m({square})·{twelfth}", k, value, k == 3.0
    )
    for square, k in _SQUARES
    for twelfth, value in _TWELFTHS
)

#: What the paper says it used.
EQ_3 = FORMULAS[0]


@dataclass(frozen=True)
class TensorFormula:
    """The formula that gives one printed tensor.

    link : from 1;  mass : [kg]
    across, along : as printed, I_xx = I_yy and I_zz [kg m²];  half_unit : of their last digit
    radius, length : of the cylinder [m];  formula : that gives the printed digits.  All three are
        None where no formula on any cylinder does.
    along_error : smallest |m r²/2 − I_zz| over the cylinders [kg m²]
    honest : what eq. 3 gives for the appendix's cylinder of this link [kg m²]
    honest_length : the length that eq. 3 would need for the printed numbers [m]; nan if none would
    """

    link: int
    mass: float
    across: float
    along: float
    half_unit: float
    radius: float | None
    length: float | None
    formula: Formula | None
    along_error: float
    honest: float
    honest_length: float

    @property
    def honest_error(self) -> float:
        """How far the printed number lies from eq. 3, as a part of eq. 3's."""
        return abs(self.across - self.honest) / self.honest


def tensor_formulas(listing: SerialArm, appendix: SerialArm) -> tuple[TensorFormula, ...]:
    """Of each tensor of the listing, the formula behind it, on the cylinders of the appendix."""
    cylinders = cut_twelfths(appendix)
    own = {cylinder.link: cylinder for cylinder in cylinders}
    bodies = [link.inertia for link in listing.links]
    printed = [float(body.tensor[k, k]) for body in bodies for k in (0, 2)]
    half_unit = max(half_units(printed))
    return tuple(
        _formula(i, body.mass, body.tensor[0, 0], body.tensor[2, 2], half_unit, own[i], cylinders)
        for i, body in enumerate(bodies, 1)
    )


def which_formula(
    mass: float, across: float, half_unit: float, cylinders: tuple[CutTwelfth, ...]
) -> tuple[Formula, CutTwelfth] | None:
    """The first formula, and the cylinder, that give I_xx [kg m²] to half a unit of its last digit.

    None if none does: a number that no formula gives is not made to fit one.
    """
    for formula in FORMULAS:
        for c in cylinders:
            if abs(formula.across(mass, c.radius, c.length) - across) <= half_unit:
                return formula, c
    return None


def _formula(
    link: int,
    mass: float,
    across: float,
    along: float,
    half_unit: float,
    own: CutTwelfth,
    cylinders: tuple[CutTwelfth, ...],
) -> TensorFormula:
    fit = fit_cylinder(mass, np.diag([across, across, along]))
    # The link's own cylinder is tried first: links 4 and 5 share one with each other.
    found = which_formula(mass, across, half_unit, (own, *cylinders))
    formula, cylinder = (None, None) if found is None else found
    return TensorFormula(
        link,
        mass,
        float(across),
        float(along),
        half_unit,
        None if cylinder is None else cylinder.radius,
        None if cylinder is None else cylinder.length,
        formula,
        min(abs(mass * c.radius**2 / 2.0 - float(along)) for c in cylinders),
        EQ_3.across(mass, own.radius, own.length),
        float("nan") if fit is None else fit.length,
    )
