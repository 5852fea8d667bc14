"""`ur5check paper` as JSON."""

from __future__ import annotations

from collections import Counter
from typing import Annotated

import msgspec
from msgspec import Meta

from .._paper.case_runs import Run
from .._paper.claim import Bound, Claim, ClaimOutcome, Verdict
from .._paper.inertia_formulas import TensorFormula
from .._paper.listing_mistakes import MistakeEffect
from .._paper.paper_models import Form
from .._paper.reproduction import Reproduction
from .json_report import Report, head
from .json_values import Number, Vector, vector
from .mistake_sentences import sentence
from .paper_summary import summarize, summary

__all__ = ["PaperReport", "paper_json"]

CaseNumber = Annotated[int, Meta(ge=1, le=9)]


class PaperVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """Whether two engines agree on the appendix [N m], and the count of each verdict."""

    trustworthy: bool
    engines_apart: float
    confirmed: int
    confirmed_after_repair: int
    refuted: int


class ClaimOutcomeValue(msgspec.Struct, frozen=True, kw_only=True):
    """A claim judged on one model."""

    id: str
    claim: str
    model: str
    form: Form
    value: Number
    unit: str
    limit: Number
    bound: Bound
    verdict: Verdict
    why: str


class ClaimVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """A claim and its verdict."""

    id: str
    claim: str
    test: str
    source: str
    verdict: Verdict


class CaseValue(msgspec.Struct, frozen=True, kw_only=True):
    """One of the nine cases computed with one model [N m], [rad]."""

    case: CaseNumber
    claim: str
    posture: list[Number]
    watched: int | None
    model: str
    amplitude: Number
    phase: Number
    offset: Number
    residual: Number
    peak: float
    expected_peak: float
    error: float
    torque: Vector | None


class FormulaValue(msgspec.Struct, frozen=True, kw_only=True):
    """The formula that gives a printed inertia [kg m²]."""

    link: int
    printed: float
    half_unit: float
    radius: Number
    length: Number
    formula: str | None
    eq3_value: float
    eq3_error: float
    eq3_length: Number


class ListingMistake(msgspec.Struct, frozen=True, kw_only=True):
    """A mistake that diagnosis found in the listing."""

    id: str
    links: list[int]
    sentence: str
    before: float
    after: float


class MistakeEffectValue(msgspec.Struct, frozen=True, kw_only=True):
    """The effect of the listing's mistakes on the watched torque of a case [N m]."""

    case: CaseNumber
    joint: int
    printed: float
    repaired: float
    literal: float
    table: float
    ratio: float
    gap: float
    left: float
    literal_gap: float
    literal_peak: float


class PaperReport(Report, frozen=True, kw_only=True, tag="ur5check.paper/2"):
    """The paper's claims judged, and the computations behind the verdicts."""

    verdict: PaperVerdict
    summary: list[str]
    claims: list[ClaimOutcomeValue]
    verdicts: list[ClaimVerdict]
    cases: list[CaseValue]
    formulas: list[FormulaValue]
    listing_mistakes: list[ListingMistake]
    mistake_effects: list[MistakeEffectValue]


def paper_json(r: Reproduction, *, command: str = "") -> PaperReport:
    """The report of `ur5check paper`."""
    count = Counter(r.verdicts.values())
    found = r.listing_mistakes
    return PaperReport(
        **head(r.arms, command, seed=found.seed, samples=found.samples),
        verdict=PaperVerdict(
            trustworthy=r.trustworthy,
            engines_apart=r.engines_apart,
            confirmed=count["confirmed"],
            confirmed_after_repair=count["confirmed after repair"],
            refuted=count["refuted"],
        ),
        summary=[summary(r), *summarize(r)],
        claims=[_outcome(outcome) for outcome in r.claims],
        verdicts=[_verdict(claim, verdict) for claim, verdict in r.verdicts.items()],
        cases=[_case(run) for run in r.cases],
        formulas=[_formula(formula) for formula in r.formulas],
        listing_mistakes=[
            ListingMistake(
                id=one.id,
                links=list(one.links),
                sentence=sentence(one, found.diagnosis.pair),
                before=one.before,
                after=one.after,
            )
            for one in found.diagnosis.mistakes
        ],
        mistake_effects=[_effect(effect) for effect in r.effects],
    )


def _outcome(o: ClaimOutcome) -> ClaimOutcomeValue:
    return ClaimOutcomeValue(
        id=o.id,
        claim=o.claim.text,
        model=o.model,
        form=o.form,
        value=o.value,
        unit=o.unit,
        limit=o.limit,
        bound=o.bound,
        verdict=o.verdict,
        why=o.why,
    )


def _verdict(claim: Claim, verdict: Verdict) -> ClaimVerdict:
    return ClaimVerdict(
        id=claim.id, claim=claim.text, test=claim.test, source=claim.source, verdict=verdict
    )


def _case(run: Run) -> CaseValue:
    fit = run.harmonic
    return CaseValue(
        case=run.case.number,
        claim=run.case.claim,
        posture=list(run.case.posture),
        watched=run.case.watched,
        model=run.model.name,
        amplitude=None if fit is None else fit.amplitude,
        phase=None if fit is None else fit.phase,
        offset=None if fit is None else fit.offset,
        residual=None if fit is None else fit.residual,
        peak=run.peak,
        expected_peak=run.expected_peak,
        error=run.error,
        torque=vector(run.watched) if fit is None else None,
    )


def _formula(f: TensorFormula) -> FormulaValue:
    return FormulaValue(
        link=f.link,
        printed=f.across,
        half_unit=f.half_unit,
        radius=f.radius,
        length=f.length,
        formula=None if f.formula is None else f.formula.text,
        eq3_value=f.honest,
        eq3_error=f.honest_error,
        eq3_length=f.honest_length,
    )


def _effect(e: MistakeEffect) -> MistakeEffectValue:
    return msgspec.convert(e, MistakeEffectValue, from_attributes=True)
