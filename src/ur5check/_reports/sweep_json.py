"""`ur5check sweep` as JSON."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec
import numpy as np
from msgspec import Meta

from .._sweep.magnitude_histogram import RELATIVE_ERROR, bin_edges
from .._sweep.reach_map import HEIGHTS, RADII
from .._sweep.state_sample import BLOCK
from .._sweep.sweep_result import QUANTILES, Sweep
from .json_report import Report, head
from .json_values import (
    AlignmentValue,
    Matrix,
    Model,
    Number,
    State,
    Vector,
    alignment_value,
    model_value,
    state,
    vector,
)
from .sweep_summary import summarize

__all__ = ["SweepReport", "sweep_json"]


class BoxValue(msgspec.Struct, frozen=True, kw_only=True):
    """Bounds of the states, per joint."""

    lower: Vector
    upper: Vector
    rate: Vector
    acceleration: Vector


class SampleValue(msgspec.Struct, frozen=True, kw_only=True):
    """The states; null where a field does not apply to a kind of sample."""

    kind: Literal["random", "sobol", "grid", "csv", "parquet"]
    seed: int | None = None
    box: BoxValue | None = None
    levels: int | None = None
    file: str | None = None
    sha256: str | None = None
    block: int = BLOCK


class Quantile(msgspec.Struct, frozen=True):
    """The value that a share of the states does not exceed [N m or N]."""

    share: float
    value: float


class HistogramValue(msgspec.Struct, frozen=True, kw_only=True):
    """The bins that are not empty: edges [N m or N] and counts."""

    lower: Vector
    upper: list[Number]
    count: list[Annotated[int, Meta(ge=1)]]


class JointSweep(msgspec.Struct, frozen=True, kw_only=True):
    """τ_a − τ_b of one joint over all states [N m or N]."""

    joint: str
    rms: float
    max: float
    worst_index: int
    worst_state: State
    quantiles: list[Quantile]
    limit: Number
    share_over: Number
    effort_limit: Number
    max_share_of_effort: Number
    rms_of_a: float
    histogram: HistogramValue


class ReachMapValue(msgspec.Struct, frozen=True, kw_only=True):
    """The largest difference by place of the tool."""

    every: int
    radius: Vector
    height: Vector
    visits: list[list[int]]
    largest: list[Matrix]


class SweepReport(Report, frozen=True, kw_only=True, tag="ur5check.sweep/2"):
    """Two models compared at many states."""

    states: int
    sample: SampleValue
    engine: str
    agrees: bool
    summary: list[str]
    a: Model
    b: Model
    alignment: AlignmentValue
    quantile_error: float
    joints: list[JointSweep]
    reach_map: ReachMapValue


def sweep_json(s: Sweep, *, command: str = "") -> SweepReport:
    """The report of `ur5check sweep`."""
    description = s.plan.sample.description()
    seed = description.get("seed")
    return SweepReport(
        **head((s.pair.a, s.pair.given_b), command, seed=seed, samples=s.count, files=s.log),
        states=s.count,
        sample=msgspec.convert(description, SampleValue),
        engine=s.plan.engine,
        agrees=s.agrees,
        summary=list(summarize(s)),
        a=model_value(s.pair.a),
        b=model_value(s.pair.given_b),
        alignment=alignment_value(s.pair.alignment),
        quantile_error=RELATIVE_ERROR,
        joints=[_joint(s, j) for j in range(s.pair.a.n)],
        reach_map=_reach_map(s),
    )


def _joint(s: Sweep, j: int) -> JointSweep:
    share_over, limits = s.share_over(), s.plan.tolerance
    return JointSweep(
        joint=s.pair.a.joints[j].name,
        rms=float(s.rms[j]),
        max=float(s.maximum[j]),
        worst_index=int(s.statistics.worst[j]),
        worst_state=state(s.worst_state(j)),
        quantiles=[Quantile(p, float(s.quantile(p)[j])) for p in QUANTILES],
        limit=None if limits is None else float(limits[j]),
        share_over=None if share_over is None else float(share_over[j]),
        effort_limit=float(s.effort[j]),
        max_share_of_effort=float(s.share_of_effort()[j]),
        rms_of_a=float(s.scale_rms[j]),
        histogram=_histogram(s, j),
    )


def _histogram(s: Sweep, j: int) -> HistogramValue:
    edges, counts = bin_edges(), s.statistics.bins[j]
    (full,) = np.nonzero(counts)
    return HistogramValue(
        lower=vector(edges[full]),
        upper=list(vector(edges[full + 1])),
        count=[int(count) for count in counts[full]],
    )


def _reach_map(s: Sweep) -> ReachMapValue:
    grid, n = s.plan.grid, s.pair.a.n
    largest = s.statistics.reach.reshape(n, RADII, HEIGHTS)
    return ReachMapValue(
        every=s.plan.map_every,
        radius=vector(grid.radii()),
        height=vector(grid.heights()),
        visits=[[int(x) for x in row] for row in s.statistics.visits.reshape(RADII, HEIGHTS)],
        largest=[[vector(row) for row in cells] for cells in largest],
    )
