"""0.0833333 for 1/12 in the transverse moment of a cylinder.

A cylinder of mass m, radius r and length l has I_axial = m r²/2 and I_transverse = m (3r² + l²)/12.
Where 0.0833333 was written for 1/12, r and l come out as round numbers with that constant, but not
with 1/12.  The mistake (3r)² for 3r² is allowed for.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import sqrt

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.serial_arm import Link, SerialArm
from ..._robot.transforms import Array, Transform
from .decimals import decimals_of
from .frame_change import arm_with_link

__all__ = ["CutTwelfth", "cut_twelfths", "with_exact_twelfth"]

# 0.083, 0.0833, … 0.08333333.  One digit more changes no moment in its first nine.
_CONSTANTS = tuple((f"0.08{'3' * n}", float(f"0.08{'3' * n}")) for n in range(1, 8))

# Lengths are typed to 0.01 mm or 0.1 mm.  The moment must pin l down to a hundredth of that, or a
# round length is no evidence.
_GRIDS = (5, 4)  # decimals of a metre
_EVIDENCE = 1e-2
_MOST_DIGITS = 14  # URDFs are often printed to 12 decimals
_SAME_MOMENT = 1e-9  # two moments equal but for the rounding of frames, relative


@dataclass(frozen=True, eq=False)
class CutTwelfth:
    """A cylinder's tensor computed with a cut-off 1/12.

    link : from 1;  constant : as written, "0.0833333"
    radius, length : of the cylinder [m];  axis : unit vector in frame i, shape (3,)
    """

    link: int
    constant: str
    radius: float
    length: float
    axis: Array


def cut_twelfths(arm: SerialArm) -> tuple[CutTwelfth, ...]:
    """Every link whose tensor is that of a round-numbered cylinder under a cut-off 1/12 only."""
    found = (_cylinder(i, link) for i, link in enumerate(arm.links, 1))
    return tuple(cylinder for cylinder in found if cylinder is not None)


def with_exact_twelfth(arm: SerialArm, found: tuple[CutTwelfth, ...]) -> SerialArm:
    """The arm with 1/12 in these links' transverse moments."""
    for cut in found:
        link = arm.links[cut.link - 1]
        I_c, u = link.inertia.tensor, cut.axis
        across = np.eye(3) - np.outer(u, u)
        transverse = 0.5 * float(np.trace(across @ I_c))
        tensor = I_c + transverse * (1.0 / (12.0 * float(cut.constant)) - 1.0) * across
        better = Inertia(link.inertia.mass, link.inertia.com, tensor)
        arm = arm_with_link(arm, cut.link - 1, replace(link, inertia=better))
    return arm


def _cylinder(number: int, link: Link) -> CutTwelfth | None:
    body = link.inertia.expressed_in(Transform(link.source_frame.R.T, np.zeros(3)))
    # Files write a cylinder along one of their axes; in other axes its digits are lost.
    if np.abs(body.tensor - np.diag(np.diag(body.tensor))).max() > _SAME_MOMENT * body.tensor.max():
        return None
    for k in range(3):
        axial, (t, other) = body.tensor[k, k], np.delete(np.diag(body.tensor), k)
        if min(axial, t, body.mass) <= 0.0 or abs(t - other) > _SAME_MOMENT * t:
            continue
        fit = _fit(body.mass, float(axial), float(t))
        if fit is not None:
            return CutTwelfth(number, *fit, link.source_frame.R[:, k])
    return None


def _fit(m: float, axial: float, t: float) -> tuple[str, float, float] | None:
    """(constant, r, l) of a cylinder that these moments [kg m²] are, under a cut-off 1/12."""
    doubt = _doubt(axial, t)
    r = sqrt(2.0 * axial / m)
    radius = _round_length(r, doubt / (m * r))
    if radius is None:
        return None
    for factor in (3.0, 9.0):  # 3 r², and the mistake (3 r)²
        if _length(m, radius, t, doubt, factor, 1.0 / 12.0) is not None:
            return None
        for text, constant in _CONSTANTS:
            length = _length(m, radius, t, doubt, factor, constant)
            if length is not None:
                return text, radius, length
    return None


def _length(
    m: float, r: float, t: float, doubt: float, factor: float, twelfth: float
) -> float | None:
    """The round l with t = twelfth · m (factor r² + l²), if there is one."""
    square = t / (twelfth * m) - factor * r**2
    if square <= 0.0:
        return None
    return _round_length(sqrt(square), doubt / (twelfth * m) / (2.0 * sqrt(square)))


def _doubt(*moments: float) -> float:
    """Half a unit in the last printed digit of moments; of computed ones, rounding error."""
    decimals = [decimals_of(moment, _MOST_DIGITS) for moment in moments]
    if None in decimals:
        return 1e-13 * max(moments)
    return 0.5 * 10.0 ** -max(places for places in decimals if places is not None)


def _round_length(value: float, doubt: float) -> float | None:
    """The round number [m] that `value` is, if it is one and can be distinguished from none."""
    for decimals in _GRIDS:
        nearest = round(value, decimals)
        if doubt <= 0.5 * _EVIDENCE * 10.0**-decimals:
            return nearest if nearest > 0.0 and abs(value - nearest) <= 1.01 * doubt else None
    return None
