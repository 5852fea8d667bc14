"""`engines MODEL` and `engines --fleet` as plain values for JSON (docs/json.md)."""

from __future__ import annotations

from .._engines.audit.engine_comparison import SAME_ROBOT, EngineReport
from .._engines.audit.engine_reading import Reading
from .._engines.audit.fleet_comparison import FleetReport
from .._engines.registry import REFERENCE, REGISTRY
from .engines_summary import import_clause, summarize
from .json_head import json_head
from .json_values import Report, model_value, strict

__all__ = ["engines_fleet_json", "engines_json"]


def engines_json(
    report: EngineReport,
    *,
    model: str = "",
    limit: float = SAME_ROBOT,
    as_read: bool = False,
    command: str = "",
) -> Report:
    """`engines MODEL` as ur5check.engines/1; limit, as_read : as for `engines_document`."""
    return strict(
        {
            **json_head("engines", [report.arm], command, report.seed, report.samples),
            "verdict": _verdict(report, limit, as_read),
            "summary": summarize(report, model, limit),
            "model": model_value(report.arm),
            "gravity": report.gravity,
            "states": len(report.states),
            "engines": [
                _engine(name, reading)
                for name, stage in report.stages()
                for reading in stage.readings
            ],
            "absent": [REGISTRY[key].title for key in report.absent],
            "parity": _parity(report),
            "imports": [
                difference
                for name, stage in report.stages()
                for reading in stage.readings
                for difference in _imports(name, reading)
            ],
        }
    )


def engines_fleet_json(
    fleet: FleetReport, *, limit: float = SAME_ROBOT, as_read: bool = False, command: str = ""
) -> Report:
    """`engines --fleet` as ur5check.fleet/1."""
    arms = [report.arm for report in fleet.reports]
    return strict(
        {
            **json_head("fleet", arms, command, fleet.seed, fleet.samples),
            "agree": fleet.agrees(limit, as_read=as_read),
            "arms": [
                {
                    "name": report.arm.name,
                    "joints": report.arm.n,
                    "verdict": _verdict(report, limit, as_read),
                    "why": [
                        {"engine": r.key, "says": import_clause(r)}
                        for r in report.as_read.readings
                        if r.refused is not None or r.harmful
                    ],
                }
                for report in fleet.reports
            ],
        }
    )


def _verdict(report: EngineReport, limit: float, as_read: bool) -> Report:
    return {
        "agree": _judged(report, limit, as_read),
        "limit": limit,
        "judged": "as read" if as_read else "repaired",
        "as_read": report.as_read.matrix.worst,
        "repaired": None if report.repaired is None else report.repaired.matrix.worst,
        "explained": report.explained,
    }


def _judged(report: EngineReport, limit: float, as_read: bool) -> bool:
    return (report.as_read if as_read else report.final).agrees(limit)


def _engine(stage: str, reading: Reading) -> Report:
    explanation = reading.explanation
    return {
        "engine": reading.key,
        "title": reading.title,
        "version": reading.version,
        "stage": stage,
        "route": reading.route or None,
        "refused": reading.refused,
        "said": reading.warnings,
        "explained": explanation is not None and explanation.explained,
        "unexplained": None if explanation is None else explanation.gap,
        "follows": [] if explanation is None else explanation.follows,
    }


def _parity(report: EngineReport) -> list[Report]:
    return [
        {
            "a": pair.a,
            "b": pair.b,
            "stage": name,
            "torque": pair.torque,
            "mass_matrix": pair.mass,
            "bias_torque": pair.bias,
            "acceleration": pair.acceleration,
            "tool": pair.tool,
            "joint": report.arm.joints[pair.joint].name,
            "state": report.states[pair.state],
        }
        for name, stage in report.stages()
        for pair in stage.matrix.pairs
    ]


def _imports(stage: str, reading: Reading) -> list[Report]:
    if reading.imported is None or reading.key == REFERENCE:
        return []
    return [
        {
            "engine": reading.key,
            "stage": stage,
            "kind": one.kind,
            "where": one.where or None,
            "written": one.written,
            "held": one.imported,
            "bears_on": one.bears_on,
            "cost": one.torque_effect,
            "known_issue": None if one.known_issue is None else one.known_issue.id,
            "fix": None if one.known_issue is None else one.known_issue.fix,
        }
        for one in reading.imported.differences
    ]
