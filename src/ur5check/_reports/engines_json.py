"""`ur5check engines MODEL` as JSON."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import msgspec

from .._engines.audit.engine_comparison import SAME_ROBOT, EngineReport
from .._engines.audit.engine_reading import Reading
from .._engines.audit.import_difference import Bearing, Kind
from .._engines.registry import REFERENCE, REGISTRY
from .engines_summary import summarize
from .json_report import Report, head
from .json_values import Model, Number, State, Vector3, model_value, state, vector

__all__ = ["AgreementVerdict", "EnginesReport", "engines_json", "verdict_value"]

StageName = Literal["as read", "repaired"]


class AgreementVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """Whether the engines agree, and the largest torque difference at each stage [N m]."""

    agree: bool
    limit: float
    judged: StageName
    as_read: Number
    repaired: Number
    explained: bool


class EngineValue(msgspec.Struct, frozen=True, kw_only=True):
    """One engine at one stage."""

    engine: str
    title: str
    version: str
    stage: StageName
    route: str | None
    refused: str | None
    warnings: list[str]
    explained: bool
    unexplained: Number
    follows: list[Kind]


class PairOfEngines(msgspec.Struct, frozen=True, kw_only=True):
    """The largest differences between two engines over all states."""

    a: str
    b: str
    stage: StageName
    torque: Number
    mass_matrix: Number
    bias_torque: Number
    acceleration: Number
    tool: Number
    joint: str
    state: State


class ImportDifferenceValue(msgspec.Struct, frozen=True, kw_only=True):
    """One difference between the file and the model that an engine imported."""

    engine: str
    stage: StageName
    kind: Kind
    where: str | None
    written: str
    imported: str
    bears_on: Bearing
    torque_effect: Number
    known_issue: str | None
    fix: str | None


class EnginesReport(Report, frozen=True, kw_only=True, tag="ur5check.engines/2"):
    """One model in several engines: an arm, or a whole robot.

    coordinates: the joints of the states and torques, in order
    mimic: joints that follow one of them
    """

    verdict: AgreementVerdict
    summary: list[str]
    model: Model
    whole: bool
    coordinates: list[str]
    mimic: list[str]
    gravity: Vector3
    states: int
    engines: list[EngineValue]
    absent: list[str]
    pairs: list[PairOfEngines]
    imports: list[ImportDifferenceValue]


def engines_json(
    report: EngineReport,
    *,
    model: str = "",
    limit: float = SAME_ROBOT,
    as_read: bool = False,
    command: str = "",
) -> EnginesReport:
    """The report of `ur5check engines MODEL`; limit, as_read : as for `engines_document`."""
    stages = report.stages()
    return EnginesReport(
        **head([report.arm], command, seed=report.seed, samples=report.samples),
        verdict=verdict_value(report, limit, as_read),
        summary=list(summarize(report, model, limit)),
        model=model_value(report.arm),
        whole=report.whole,
        coordinates=list(report.arm.joint_names),
        mimic=list(report.mimic),
        gravity=vector(report.gravity),
        states=len(report.states),
        engines=[_engine(name, reading) for name, stage in stages for reading in stage.readings],
        absent=[REGISTRY[key].title for key in report.absent],
        pairs=_pairs(report),
        imports=[
            difference
            for name, stage in stages
            for reading in stage.readings
            for difference in _imports(name, reading)
        ],
    )


def verdict_value(report: EngineReport, limit: float, as_read: bool) -> AgreementVerdict:
    """Whether the engines agree within `limit`, at the stage that is judged."""
    return AgreementVerdict(
        agree=(report.as_read if as_read else report.final).agrees(limit),
        limit=limit,
        judged="as read" if as_read else "repaired",
        as_read=report.as_read.matrix.worst,
        repaired=None if report.repaired is None else report.repaired.matrix.worst,
        explained=report.explained,
    )


def _engine(stage: StageName, reading: Reading) -> EngineValue:
    explanation = reading.explanation
    return EngineValue(
        engine=reading.key,
        title=reading.title,
        version=reading.version,
        stage=stage,
        route=reading.route or None,
        refused=reading.refused,
        warnings=list(reading.warnings),
        explained=explanation is not None and explanation.explained,
        unexplained=None if explanation is None else explanation.gap,
        follows=[] if explanation is None else list(explanation.follows),
    )


def _pairs(report: EngineReport) -> list[PairOfEngines]:
    return [
        PairOfEngines(
            a=pair.a,
            b=pair.b,
            stage=name,
            torque=pair.torque,
            mass_matrix=pair.mass,
            bias_torque=pair.bias,
            acceleration=pair.acceleration,
            tool=pair.tool,
            joint=report.arm.joint_names[pair.joint],
            state=state(report.states[pair.state]),
        )
        for name, stage in report.stages()
        for pair in stage.matrix.pairs
    ]


def _imports(stage: StageName, reading: Reading) -> Iterator[ImportDifferenceValue]:
    if reading.imported is None or reading.key == REFERENCE:
        return
    for one in reading.imported.differences:
        yield ImportDifferenceValue(
            engine=reading.key,
            stage=stage,
            kind=one.kind,
            where=one.where or None,
            written=one.written,
            imported=one.imported,
            bears_on=one.bears_on,
            torque_effect=one.torque_effect,
            known_issue=None if one.known_issue is None else one.known_issue.id,
            fix=None if one.known_issue is None else one.known_issue.fix,
        )
