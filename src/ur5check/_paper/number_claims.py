"""What the paper says of its numbers: lengths from the DH table, tensors from a cylinder's formula.

All of these can be held against the paper itself; no measured robot is needed.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._comparison.rounding.cylinder_constant import CutTwelfth, cut_twelfths
from .._comparison.rounding.decimals import half_units
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .inertia_formulas import EQ_3, TensorFormula
from .paper_models import PRINTED, REPAIRED, Form

__all__ = ["across_the_axis", "along_the_axis", "tensors_lie_along_links", "vectors_from_dh"]

#: Links whose cylinders are long enough to have a direction that matters.
_LONG = (2, 3)

#: Nearer along than across.  The next joint stands beside the link's own axis, so that not even a
#: good cylinder points straight at it.
_ALONG = 45.0  # [°]


def vectors_from_dh(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """The vectors between origins follow from the DH table."""
    claim = Claim(
        "vectors",
        "The vectors between link origins follow from the DH table",
        "largest distance from R_iᵀ p_i of Table 1: half a unit of the last digit printed",
        "listing, r of links 1 to 6",
        "m",
    )
    table = evidence.model(REPAIRED).arm
    yield from judged(
        claim,
        (
            vector_trial(evidence.model(PRINTED).arm, table),
            Trial(
                REPAIRED,
                "repaired",
                *_apart(evidence.listing_mistakes.repaired, table),
                "mistakes repaired",
            ),
        ),
    )


def vector_trial(listing: SerialArm, table: SerialArm) -> Trial:
    """The listing's vectors against Table 1's."""
    value, limit = _apart(listing, table)
    wrong = np.flatnonzero(np.abs(_reaches(listing) - _reaches(table)).max(axis=1) > limit) + 1
    links = ", ".join(map(str, wrong))
    return Trial(
        PRINTED, "printed", value, limit, f"links {links} reach the wrong way" * bool(links)
    )


def across_the_axis(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """I_xx and I_yy are those of a cylinder."""
    claim = Claim(
        "inertia-across",
        "I_xx and I_yy are m(3r² + l²)/12 of the links' cylinders",
        "largest distance from the formula, on the cylinders of the appendix: half a unit of the "
        "last digit printed, of the tensor or of the 1/12",
        "eqs 3 and 5",
        "kg m²",
    )
    cylinders = cut_twelfths(evidence.model("appendix").arm)
    arm = evidence.model("appendix").arm
    yield from judged(claim, (across_trial(evidence.formulas), _appendix_trial(arm, cylinders)))


def across_trial(formulas: tuple[TensorFormula, ...]) -> Trial:
    """The printed moments against eq. 3, and what made them instead."""
    worst = max(abs(f.across - f.honest) for f in formulas)
    percent = sorted(100.0 * f.honest_error for f in formulas)
    made = sorted({"no known formula" if f.formula is None else f.formula.text for f in formulas})
    why = f"off by {percent[0]:.0f} to {percent[-1]:.0f} %; they follow {' and '.join(made)}"
    return Trial(PRINTED, "printed", worst, formulas[0].half_unit, why)


def along_the_axis(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """I_zz is that of a cylinder."""
    claim = Claim(
        "inertia-along",
        "I_zz is m r²/2 of the links' cylinders",
        "largest distance from the formula: half a unit of the last digit printed",
        "eq. 8",
        "kg m²",
    )
    yield from judged(claim, (along_trial(evidence.formulas),))


def along_trial(formulas: tuple[TensorFormula, ...]) -> Trial:
    """The printed I_zz against eq. 8."""
    worst = max(formulas, key=lambda f: f.along_error)
    return Trial(PRINTED, "printed", worst.along_error, worst.half_unit)


def tensors_lie_along_links(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """The tensors of the long links are held in the frames in which they are used."""
    claim = Claim(
        "inertia-frame",
        "The cylinders of links 2 and 3 lie along these links",
        "largest angle between the cylinder's axis and the way to the next joint: 45°, nearer "
        "along than across",
        "listing, inertia tensors",
        "°",
    )
    models = (evidence.model(name) for name in (PRINTED, REPAIRED, "appendix"))
    yield from judged(claim, (direction_trial(m.arm, m.name, m.form) for m in models))


def direction_trial(arm: SerialArm, name: str, form: Form) -> Trial:
    """Which way the cylinders of the long links lie."""
    axes = {c.link: c.axis for c in cut_twelfths(arm)}
    angles = [
        _angle(axes[i], arm.links[i - 1].link_tip_frame.R.T @ arm.links[i - 1].link_tip_frame.p)
        for i in _LONG
    ]
    why = "tensors of URDF frames, used unturned in DH frames" * (max(angles) > _ALONG)
    return Trial(name, form, max(angles), _ALONG, why)


def _appendix_trial(arm: SerialArm, cylinders: tuple[CutTwelfth, ...]) -> Trial:
    """The appendix computes its tensors: eq. 3 with a constant of so many digits."""
    pairs = []
    for c in cylinders:
        body = arm.links[c.link - 1].inertia
        across = (np.trace(body.tensor) - c.axis @ body.tensor @ c.axis) / 2.0
        honest = EQ_3.across(body.mass, c.radius, c.length)
        pairs.append((abs(float(across) - honest), honest))
    # The error grows with the moment, and so does its limit: the worst is so relatively.
    error, honest = max(pairs, key=lambda pair: pair[0] / pair[1])
    constant = cylinders[0].constant
    half_unit = 0.5 * 10.0 ** -len(constant.partition(".")[2]) * 12.0
    return Trial(
        "appendix", "other", error, half_unit * honest, f"computed with {constant} for 1/12"
    )


def _apart(arm: SerialArm, table: SerialArm) -> tuple[float, float]:
    """Largest distance of the vectors between origins, and half a unit of their last digit [m]."""
    reaches = _reaches(table)
    return float(np.abs(_reaches(arm) - reaches).max()), max(half_units(reaches.ravel().tolist()))


def _reaches(arm: SerialArm) -> Array:
    """r_{i−1,i} in frame i, shape (n, 3) [m]."""
    return np.array([link.link_tip_frame.R.T @ link.link_tip_frame.p for link in arm.links])


def _angle(one: Array, other: Array) -> float:
    """Between two lines [°], 0 … 90."""
    cosine = abs(one @ other) / np.linalg.norm(one) / np.linalg.norm(other)
    return float(np.degrees(np.arccos(min(1.0, float(cosine)))))
