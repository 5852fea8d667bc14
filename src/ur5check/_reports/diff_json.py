"""`ur5check diff` as JSON; `validate` has the same comparison for each pair of models."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

import msgspec
import numpy as np
from msgspec import Meta

from .._comparison.attribution import Attribution
from .._comparison.difference import Difference
from .._comparison.explanation import Explanation
from .._comparison.other_numbers import OtherNumber
from .._comparison.torque_band import TorqueBand
from .._validation.revision_change import RevisionChange
from .diff_sections.stated_uncertainty import uncertainty_in_words
from .difference_summary import summarize as summarize_difference
from .explanation_json import ExplanationValue, explanation_value
from .explanation_summary import summarize as summarize_explanation
from .finding_json import FindingValue, finding_value
from .json_report import Report, head
from .json_values import (
    AlignmentValue,
    InertiaValue,
    Model,
    Number,
    State,
    Vector,
    Vector3,
    alignment_value,
    inertia_value,
    model_value,
    state,
    vector,
)

__all__ = ["Comparison", "DiffReport", "comparison_value", "diff_json"]

Share = Annotated[float, Meta(ge=0.0, le=1.0)]


class KinematicsValue(msgspec.Struct, frozen=True):
    """Largest distance [m] and angle [rad] between the tools, and the state of the distance."""

    position_max: float
    angle_max: float
    worst_state: State


class LinkPairValue(msgspec.Struct, frozen=True, kw_only=True):
    """One link's numbers in both models."""

    link: int
    name_a: str
    name_b: str
    a: InertiaValue
    b: InertiaValue
    link_vector_a: Vector3
    link_vector_b: Vector3
    centre_distance: float
    moment_ratio: Number


class JointTorque(msgspec.Struct, frozen=True, kw_only=True):
    """τ_a − τ_b of one joint [N m or N]."""

    joint: str
    rms: float
    max: float
    worst_state: State
    rms_of_a: float
    effort_limit: Number
    max_share_of_effort: Number


class ContributionValue(msgspec.Struct, frozen=True, kw_only=True):
    """What one kind of numbers contributes to the torque difference."""

    kind: Literal[
        "geometry", "gravity", "motor inertia", "mass", "centre of mass", "tensor",
        "m", "mx", "my", "mz", "Ixx", "Ixy", "Iyy", "Ixz", "Iyz", "Izz",
    ]  # fmt: skip
    link: int | None
    rms: Vector
    share: float
    weight: Share


class AttributionValue(msgspec.Struct, frozen=True, kw_only=True):
    """The torque difference as a sum of contributions and a residual [N m]."""

    contributions: list[ContributionValue]
    residual_max: float


class OtherNumberValue(msgspec.Struct, frozen=True, kw_only=True):
    """A number beside geometry and inertias that differs, or that only one model gives."""

    quantity: str
    unit: str
    joint: str | None
    a: Number | Vector
    b: Number | Vector
    place_a: str
    place_b: str
    moves_joints: bool


class JointBand(msgspec.Struct, frozen=True, kw_only=True):
    """Δτ of one joint against its standard deviation σ [N m or N]."""

    joint: str
    sigma_rms: float
    max_ratio: Number
    share_beyond: Share
    worst_state: State
    exceeds: bool


class UncertaintyValue(msgspec.Struct, frozen=True, kw_only=True):
    """The torque difference against stated uncertainties; ratios are |Δτ| / 2σ.

    Of two models of one robot the largest ratio stays below `allowed_ratio` with a probability of
    95 %.
    """

    sentence: str
    allowed_ratio: float
    joints: list[JointBand]


class Comparison(msgspec.Struct, frozen=True, kw_only=True):
    """Two models compared."""

    agrees: bool
    summary: list[str]
    a: Model
    b: Model
    alignment: AlignmentValue
    kinematics: KinematicsValue
    parameters: list[LinkPairValue]
    torques: list[JointTorque]
    attribution: AttributionValue
    same_torques: bool
    tolerance: Vector
    others: list[OtherNumberValue]
    uncertainty: UncertaintyValue | None
    faults_a: list[FindingValue]
    faults_b: list[FindingValue]


class ChangeValue(msgspec.Struct, frozen=True, kw_only=True):
    """What a commit changes beside the torques; masses of the whole robot [kg]."""

    revision: str
    mass_before: Number | None
    mass_after: Number | None
    new: list[FindingValue]
    gone: list[FindingValue]


class DiffReport(Report, frozen=True, kw_only=True, tag="ur5check.diff/2"):
    """Two models compared, and the difference explained."""

    comparison: Comparison
    summary: list[str]
    explanation: ExplanationValue | None
    by_parameter: list[ContributionValue] | None
    since_commit: ChangeValue | None


def diff_json(
    d: Difference,
    explanation: Explanation | None = None,
    *,
    parameters: Attribution | None = None,
    change: RevisionChange | None = None,
    command: str = "",
) -> DiffReport:
    """The report of `ur5check diff`.

    explanation : of d; None with --quick
    parameters : d attributed to each parameter, where that was wanted
    change : since a commit, where a file was compared with itself
    """
    comparison = comparison_value(d)
    summary: Sequence[str] = (
        comparison.summary if explanation is None else summarize_explanation(explanation)
    )
    return DiffReport(
        **head([d.pair.a, d.pair.given_b], command, seed=d.seed, samples=len(d.states)),
        comparison=comparison,
        summary=list(summary),
        explanation=None if explanation is None else explanation_value(explanation),
        by_parameter=None if parameters is None else _contributions(parameters),
        since_commit=None if change is None else _change(change),
    )


def _change(change: RevisionChange) -> ChangeValue:
    before, after = change.masses
    return ChangeValue(
        revision=change.revision,
        mass_before=before,
        mass_after=after,
        new=[finding_value(finding) for finding in change.new],
        gone=[finding_value(finding) for finding in change.gone],
    )


def comparison_value(d: Difference) -> Comparison:
    """Two models compared."""
    return Comparison(
        agrees=d.agrees,
        summary=list(summarize_difference(d)),
        a=model_value(d.pair.a),
        b=model_value(d.pair.given_b),
        alignment=alignment_value(d.pair.alignment),
        kinematics=KinematicsValue(d.tool.position, d.tool.angle, state(d.states[d.tool.worst])),
        parameters=_parameters(d),
        torques=_torques(d),
        attribution=AttributionValue(
            contributions=_contributions(d.attribution),
            residual_max=float(np.abs(d.attribution.remainder).max()),
        ),
        same_torques=d.same_torques,
        tolerance=vector(d.tolerance),
        others=[_other(other) for other in d.others],
        uncertainty=None if d.band is None else _uncertainty(d, d.band),
        faults_a=[finding_value(fault) for fault in d.faults["a"]],
        faults_b=[finding_value(fault) for fault in d.faults["b"]],
    )


def _other(other: OtherNumber) -> OtherNumberValue:
    a, b = (list(x) if isinstance(x, tuple) else x for x in (other.a, other.b))
    return OtherNumberValue(
        quantity=other.quantity,
        unit=other.unit,
        joint=other.joint or None,
        a=a,
        b=b,
        place_a=str(other.place_a),
        place_b=str(other.place_b),
        moves_joints=other.moves_joints,
    )


def _uncertainty(d: Difference, band: TorqueBand) -> UncertaintyValue:
    return UncertaintyValue(
        sentence=uncertainty_in_words(d, band),
        allowed_ratio=band.allowed,
        joints=[
            JointBand(
                joint=joint.name,
                sigma_rms=float(band.sigma[i]),
                max_ratio=float(band.ratio[i]),
                share_beyond=float(band.share[i]),
                worst_state=state(d.states[int(band.worst[i])]),
                exceeds=i + 1 in band.exceeded,
            )
            for i, joint in enumerate(d.pair.a.joints)
        ],
    )


def _parameters(d: Difference) -> list[LinkPairValue]:
    return [
        LinkPairValue(
            link=link.link,
            name_a=link.name_a,
            name_b=link.name_b,
            a=inertia_value(link.a, link.tensors_known),
            b=inertia_value(link.b, link.tensors_known),
            link_vector_a=vector(link.reach_a),
            link_vector_b=vector(link.reach_b),
            centre_distance=link.centre_distance(),
            moment_ratio=link.moment_ratio(),
        )
        for link in d.parameters
    ]


def _torques(d: Difference) -> list[JointTorque]:
    share = d.torques.share_of_effort()
    return [
        JointTorque(
            joint=joint.name,
            rms=float(d.torques.rms[i]),
            max=float(d.torques.maximum[i]),
            worst_state=state(d.states[int(d.torques.worst[i])]),
            rms_of_a=float(d.torques.scale[i]),
            effort_limit=float(d.torques.effort[i]),
            max_share_of_effort=float(share[i]),
        )
        for i, joint in enumerate(d.pair.a.joints)
    ]


def _contributions(attribution: Attribution) -> list[ContributionValue]:
    rms, share, weight = attribution.rms(), attribution.share(), attribution.weight()
    return [
        ContributionValue(
            kind=contribution.kind,
            link=contribution.link,
            rms=vector(rms[k]),
            share=float(share[k]),
            weight=float(weight[k]),
        )
        for k, contribution in enumerate(attribution.contributions)
    ]
