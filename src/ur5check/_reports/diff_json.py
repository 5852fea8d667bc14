"""Results as plain values for JSON.  Every field is documented in docs/json.md."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._comparison.attribution import Attribution
from .._comparison.difference import Difference
from .difference_summary import summarize as summarize_difference
from .json_head import json_head
from .json_values import Report, alignment_value, inertia_value, model_value, strict
from .validate_summary import summarize as summarize_validation

if TYPE_CHECKING:
    from .._comparison.explanation import Explanation
    from .._validation.law import Outcome
    from .._validation.validation import Validation

__all__ = ["diff_json", "validate_json"]


def validate_json(v: Validation, *, command: str = "") -> Report:
    """`validate` as ur5check.validation/1."""
    arms = [model.arm for model in v.models]
    return strict(
        {
            **json_head("validation", arms, command, v.seed, v.samples),
            "verdict": {
                "passed": v.passed,
                "algorithm": v.algorithm_right,
                "bodies": v.bodies_possible,
                "accounted": v.accounted,
            },
            "summary": summarize_validation(v),
            "models": [
                {**model_value(model.arm), "reference": model.reference, "route": model.route}
                for model in v.models
            ],
            "checks": [_check(outcome) for outcome in v.outcomes],
            "differences": [_difference(pair.difference) for pair in v.pairs],
        }
    )


def diff_json(
    d: Difference,
    explanation: Explanation | None = None,
    *,
    parameters: Attribution | None = None,
    command: str = "",
) -> Report:
    """`diff` as ur5check.difference/1; its explanation and finer attribution where given."""
    # Here, not above: `validate` has no explanation, and should not load what makes one.
    from .explanation_json import attribution_value, explanation_value

    arms = [d.pair.a, d.pair.given_b]
    head = json_head("difference", arms, command, d.seed, len(d.states))
    explained = {} if explanation is None else explanation_value(explanation)
    finer = {} if parameters is None else {"by_parameter": attribution_value(parameters)}
    return strict({**head, **_difference(d), **explained, **finer})


def _check(o: Outcome) -> Report:
    return {
        "id": o.id,
        "about": o.about,
        "subject": o.subject,
        "statement": o.statement,
        "formula": o.formula,
        "status": o.status,
        "value": o.value,
        "tolerance": o.tolerance,
        "bound": "above" if o.positive else "at most",
        "unit": o.unit,
        "samples": o.samples,
        "worst_state": o.worst_state,
        "details": o.details,
    }


def _difference(d: Difference) -> Report:
    return {
        "agrees": d.agrees,
        "summary": summarize_difference(d),
        "a": model_value(d.pair.a),
        "b": model_value(d.pair.given_b),
        "alignment": alignment_value(d.pair.alignment),
        "kinematics": {
            "position_max": d.tool.position,
            "angle_max": d.tool.angle,
            "worst_state": d.states[d.tool.worst],
        },
        "parameters": [
            {
                "link": link.link,
                "name_a": link.name_a,
                "name_b": link.name_b,
                "a": inertia_value(link.a),
                "b": inertia_value(link.b),
                "reach_a": link.reach_a,
                "reach_b": link.reach_b,
                "centre_distance": link.centre_distance(),
                "moment_ratio": link.moment_ratio(),
            }
            for link in d.parameters
        ],
        "torques": _torques(d),
        "account": _account(d),
    }


def _torques(d: Difference) -> list[Report]:
    share = d.torques.share_of_effort()
    return [
        {
            "joint": joint.name,
            "rms": d.torques.rms[i],
            "max": d.torques.maximum[i],
            "worst_state": d.states[int(d.torques.worst[i])],
            "rms_of_a": d.torques.scale[i],
            "effort_limit": d.torques.effort[i],
            "max_share_of_effort": share[i],
        }
        for i, joint in enumerate(d.pair.a.joints)
    ]


def _account(d: Difference) -> Report:
    share, rms = d.attribution.share(), d.attribution.rms()
    return {
        "contributions": [
            {"kind": contribution.kind, "link": contribution.link, "rms": rms[k], "share": share[k]}
            for k, contribution in enumerate(d.attribution.contributions)
        ],
        "remainder_max": np.abs(d.attribution.remainder).max(),
    }
