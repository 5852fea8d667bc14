"""Torque differences against the stated uncertainties of the models' numbers."""

from __future__ import annotations

from ..._comparison.difference import Difference
from ..._comparison.torque_band import TorqueBand
from ..document import Column, Row, Section, Table
from ..wording import figures, joined, percent, posture

__all__ = ["uncertainty_in_words", "uncertainty_section"]


def uncertainty_section(d: Difference, band: TorqueBand) -> Section:
    """Joint by joint: σ, the largest |Δτ| / 2σ and where it is, the share of states beyond 2σ."""
    joints = d.pair.a.joints
    rows = [
        Row(
            (
                joint.name,
                figures(band.sigma[i]),
                figures(band.ratio[i]),
                percent(band.share[i]),
                posture(d.states[int(band.worst[i])]["q"], joints),
            ),
            bad=i + 1 in band.exceeded,
        )
        for i, joint in enumerate(joints)
    ]
    sliding = any(joint.kind == "prismatic" for joint in joints)
    table = Table(
        (
            Column("joint"),
            Column(f"σ RMS [{'N m or N' if sliding else 'N m'}]", number=True),
            Column("largest |Δτ| / 2σ", number=True),
            Column("beyond 2σ [%]", number=True),
            Column("posture of the largest [°]"),
        ),
        tuple(rows),
        note=f"Of two models of one robot the largest ratio stays below {figures(band.allowed)} "
        "with a probability of 95 %.",
    )
    return Section("Uncertainty", (uncertainty_in_words(d, band),), (table,))


def uncertainty_in_words(d: Difference, band: TorqueBand) -> str:
    """Whether the models differ by more than the stated uncertainties allow, and where."""
    if not band.exceeded:
        return "The stated uncertainties allow this difference at every joint."
    names = [f"{j} ({d.pair.a.joints[j - 1].name})" for j in band.exceeded]
    plural = "s" if len(names) > 1 else ""
    return (
        f"The models differ by more than the stated uncertainties allow at joint{plural} "
        f"{joined(names)}."
    )
