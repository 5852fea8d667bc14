"""`paper` as ur5check.paper/1.  Every field is documented in docs/json.md."""

from __future__ import annotations

from collections import Counter

from .._paper.case_runs import Run
from .._paper.claim import ClaimOutcome
from .._paper.inertia_formulas import TensorFormula
from .._paper.reproduction import Reproduction
from .json_head import json_head
from .json_values import Report, strict
from .mistake_sentences import sentence
from .paper_summary import summarize, summary

__all__ = ["paper_json"]


def paper_json(r: Reproduction, *, command: str = "") -> Report:
    """The report of `ur5check paper`."""
    count = Counter(r.verdicts.values())
    return strict(
        {
            **json_head(
                "paper", r.arms, command, r.listing_mistakes.seed, r.listing_mistakes.samples
            ),
            "verdict": {
                "trustworthy": r.trustworthy,
                "engines_apart": r.engines_apart,
                "confirmed": count["confirmed"],
                "confirmed_after_repair": count["confirmed after repair"],
                "refuted": count["refuted"],
            },
            "summary": [summary(r), *summarize(r)],
            "claims": [_claim(outcome) for outcome in r.claims],
            "verdicts": [
                {"id": claim.id, "claim": claim.text, "test": claim.test, "source": claim.source,
                 "verdict": verdict}
                for claim, verdict in r.verdicts.items()
            ],
            "cases": [_case(run) for run in r.cases],
            "formulas": [_formula(formula) for formula in r.formulas],
            "listing_mistakes": [
                {"id": f.id, "links": f.links, "before": f.before, "after": f.after,
                 "sentence": sentence(f, r.listing_mistakes.diagnosis.pair)}
                for f in r.listing_mistakes.diagnosis.mistakes
            ],
            "mistake_effects": [
                {"case": e.case, "joint": e.joint, "printed": e.printed, "repaired": e.repaired,
                 "literal": e.literal, "table": e.table, "ratio": e.ratio, "gap": e.gap,
                 "left": e.left, "literal_gap": e.literal_gap, "literal_peak": e.literal_peak}
                for e in r.effects
            ],
        }
    )  # fmt: skip


def _claim(o: ClaimOutcome) -> Report:
    return {
        "id": o.id,
        "claim": o.claim.text,
        "model": o.model,
        "form": o.form,
        "value": o.value,
        "unit": o.unit,
        "limit": o.limit,
        "bound": o.bound,
        "verdict": o.verdict,
        "why": o.why,
    }


def _case(run: Run) -> Report:
    fit = run.harmonic
    return {
        "case": run.case.number,
        "claim": run.case.claim,
        "posture": run.case.posture,
        "watched": run.case.watched,
        "model": run.model.name,
        "amplitude": None if fit is None else fit.amplitude,
        "phase": None if fit is None else fit.phase,
        "offset": None if fit is None else fit.offset,
        "residual": None if fit is None else fit.residual,
        "peak": run.peak,
        "expected_peak": run.expected_peak,
        "error": run.error,
        "torque": run.watched if fit is None else None,
    }


def _formula(f: TensorFormula) -> Report:
    return {
        "link": f.link,
        "printed": f.across,
        "half_unit": f.half_unit,
        "radius": f.radius,
        "length": f.length,
        "formula": None if f.formula is None else f.formula.text,
        "honest": f.honest,
        "honest_error": f.honest_error,
        "honest_length": f.honest_length,
    }
