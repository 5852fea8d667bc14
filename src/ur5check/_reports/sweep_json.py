"""A sweep as plain values for JSON.  Every field is documented in docs/json.md."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._sweep.magnitude_histogram import RELATIVE_ERROR, bin_edges
from .._sweep.reach_map import HEIGHTS, RADII
from .._sweep.state_sample import BLOCK
from .._sweep.sweep_result import QUANTILES, Sweep
from .json_head import json_head
from .json_values import Report, alignment_value, model_value, strict
from .sweep_summary import summarize

__all__ = ["sweep_json"]


def sweep_json(s: Sweep, *, command: str = "") -> Report:
    """`sweep` as ur5check.sweep/1."""
    head = json_head("sweep", (s.pair.a, s.pair.given_b), command)
    log = [{"name": name, "sha256": digest} for name, digest in s.log]
    return strict(
        {
            **head,
            "inputs": [*head["inputs"], *log],
            "states": s.count,
            "sample": _sample(s),
            "engine": s.plan.engine,
            "agrees": s.agrees,
            "summary": summarize(s),
            "a": model_value(s.pair.a),
            "b": model_value(s.pair.given_b),
            "alignment": alignment_value(s.pair.alignment),
            "quantile_error": RELATIVE_ERROR,
            "joints": [_joint(s, j) for j in range(s.pair.a.n)],
            "reach_map": _reach_map(s),
        }
    )


def _sample(s: Sweep) -> Report:
    """Every kind with the same fields; null where one has no meaning."""
    blank: dict[str, Any] = dict.fromkeys(("seed", "box", "levels", "file", "sha256"))
    return {**blank, **s.plan.sample.description(), "block": BLOCK}


def _joint(s: Sweep, j: int) -> Report:
    tolerance, limits = s.share_over(), s.plan.tolerance
    return {
        "joint": s.pair.a.joints[j].name,
        "rms": s.rms[j],
        "max": s.maximum[j],
        "worst_index": s.statistics.worst[j],
        "worst_state": s.worst_state(j),
        "quantiles": [{"share": p, "value": s.quantile(p)[j]} for p in QUANTILES],
        "limit": None if limits is None else limits[j],
        "share_over": None if tolerance is None else tolerance[j],
        "effort_limit": s.effort[j],
        "max_share_of_effort": s.share_of_effort()[j],
        "rms_of_a": s.scale_rms[j],
        "histogram": _histogram(s, j),
    }


def _histogram(s: Sweep, j: int) -> Report:
    """The bins that are not empty."""
    edges, counts = bin_edges(), s.statistics.bins[j]
    (full,) = np.nonzero(counts)
    return {"lower": edges[full], "upper": edges[full + 1], "count": counts[full]}


def _reach_map(s: Sweep) -> Report:
    grid, n = s.plan.grid, s.pair.a.n
    return {
        "every": s.plan.map_every,
        "radius": grid.radii(),
        "height": grid.heights(),
        "visits": s.statistics.visits.reshape(RADII, HEIGHTS),
        "largest": s.statistics.reach.reshape(n, RADII, HEIGHTS),
    }
