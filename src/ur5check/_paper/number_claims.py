"""The paper's claims on its inertia tensors: a cylinder's formula, in the frames of the links.

All are checked against the paper itself; no measured robot is needed.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._comparison.rounded_constants.cylinder_constant import CutTwelfth, cut_twelfths
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .inertia_formulas import EQ_3, TensorFormula
from .paper_models import PRINTED, REPAIRED, Form

__all__ = ["across_the_axis", "along_the_axis", "tensors_lie_along_links"]

#: Links whose cylinders are long enough to have a direction that matters.
_LONG = (2, 3)

#: Nearer along than across.  The next joint lies beside the link's axis, so that not even a
#: correct cylinder points exactly at it.
_ALONG = 45.0  # [°]


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
    """The printed moments against eq. 3, and the formula that gives them."""
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
    """The tensors of the long links are given in the frames in which they are used."""
    claim = Claim(
        "inertia-frame",
        "The cylinders of links 2 and 3 lie along these links",
        "largest angle between the cylinder's axis and the vector to the next joint: 45°, nearer "
        "along than across",
        "listing, inertia tensors",
        "°",
    )
    models = (evidence.model(name) for name in (PRINTED, REPAIRED, "appendix"))
    yield from judged(claim, (direction_trial(m.arm, m.name, m.form) for m in models))


def direction_trial(arm: SerialArm, name: str, form: Form) -> Trial:
    """The direction of the cylinders of the long links."""
    axes = {c.link: c.axis for c in cut_twelfths(arm)}
    angles = [
        _angle(axes[i], arm.links[i - 1].link_tip_frame.R.T @ arm.links[i - 1].link_tip_frame.p)
        for i in _LONG
    ]
    why = "tensors of URDF frames, used unrotated in DH frames" * (max(angles) > _ALONG)
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


def _angle(one: Array, other: Array) -> float:
    """Between two lines [°], 0 … 90."""
    cosine = abs(one @ other) / np.linalg.norm(one) / np.linalg.norm(other)
    return float(np.degrees(np.arccos(min(1.0, float(cosine)))))
