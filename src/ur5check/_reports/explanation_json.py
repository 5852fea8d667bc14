"""An explanation as plain values for JSON.  Every field is documented in docs/json.md."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict

import numpy as np

from .._comparison.arm_pair import Side
from .._comparison.attribution import Attribution
from .._comparison.diagnosis.diagnosis import Diagnosis
from .._comparison.explanation import Explanation
from .._comparison.plausibility.plausible_body import Plausibility
from .._comparison.rounding.error_budget import ErrorBudget
from .._comparison.worst_case.worst_case import WorstCase
from .explanation_summary import equivalence_in_words, removed, summarize
from .json_values import Report
from .mistake_sentences import advice, details, remark, sentence

__all__ = ["attribution_value", "explanation_value"]


def explanation_value(e: Explanation) -> Report:
    """What `ur5check.difference/1` gains when it is explained, and the story that tells it."""
    terms = {
        "gravity": e.terms.gravity,
        "coriolis": e.terms.coriolis,
        "inertial": e.terms.inertial,
    }
    return {
        "summary": summarize(e),
        "attribution": attribution_value(e.difference.attribution),
        "terms": {name: np.sqrt((part.delta**2).mean(axis=0)) for name, part in terms.items()},
        "identifiability": _identifiability(e),
        "error_budget": _budget(e.budget),
        "worst_case": [_worst(e, case) for case in e.worst],
        "diagnosis": _mistakes(e.diagnosis),
        "unexplained": [
            {
                "link": mismatch.link + 1,
                "quantity": mismatch.quantity,
                "gap": mismatch.gap,
                "sentence": remark(mismatch, e.diagnosis),
            }
            for mismatch in e.diagnosis.unexplained
        ],
        "plausibility": [*_plausibility("a", e.plausible_a), *_plausibility("b", e.plausible_b)],
    }


def attribution_value(attribution: Attribution) -> list[Report]:
    """Every owner with its part."""
    rms, share, weight = attribution.rms(), attribution.share(), attribution.weight()
    return [
        {
            "kind": contribution.kind,
            "link": contribution.link,
            "rms": rms[k],
            "share": share[k],
            "weight": weight[k],
        }
        for k, contribution in enumerate(attribution.contributions)
    ]


def _identifiability(e: Explanation) -> Report:
    seen = e.identifiability
    return {
        "columns": seen.columns,
        "rank": seen.rank,
        "certain": seen.certain,
        "doubt": seen.doubt,
        "gap": seen.gap,
        "identifiable": seen.names_of("identifiable"),
        "in_combination": seen.names_of("in combination"),
        "invisible": seen.names_of("invisible"),
        "combinations": seen.combinations(),
        "equivalent": e.equivalence.dynamically_equivalent,
        "sentence": equivalence_in_words(e.equivalence),
    }


def _budget(budget: ErrorBudget) -> Report:
    return {
        "items": [
            {
                "cause": item.cause,
                "side": item.side,
                "where": item.where,
                "exact": item.exact,
                "rms": item.rms,
                "maximum": item.maximum,
            }
            for item in budget.items
        ],
        "total": budget.total,
        "explained": budget.explained,
        "remainder": budget.remainder,
        "digits_suffice": budget.digits_suffice,
    }


def _worst(e: Explanation, case: WorstCase) -> Report:
    joints = e.difference.pair.a.joints
    value = asdict(case)
    return {**value, "joint": None if case.joint is None else joints[case.joint - 1].name}


def _mistakes(diagnosis: Diagnosis) -> list[Report]:
    return [
        {
            "id": found.id,
            "rules": [mistake.rule_id for mistake in found.mistakes],
            "side": found.side,
            "where": found.links,
            "sentence": sentence(found, diagnosis.pair),
            "details": details(found),
            "advice": advice(found),
            "before": found.before,
            "after": found.after,
            "removes": removed(found, diagnosis),
            "choices": found.choices,
            "equals": found.equals,
        }
        for found in diagnosis.mistakes
    ]


def _plausibility(arm: Side, found: Iterable[Plausibility]) -> list[Report]:
    return [{"arm": arm, **asdict(finding)} for finding in found]
