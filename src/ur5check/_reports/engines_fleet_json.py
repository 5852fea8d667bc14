"""`ur5check engines --fleet` as JSON."""

from __future__ import annotations

import msgspec

from .._engines.audit.engine_comparison import SAME_ROBOT
from .._engines.audit.fleet_comparison import FleetReport
from .engines_json import AgreementVerdict, verdict_value
from .engines_summary import import_clause
from .json_report import Report, head

__all__ = ["EnginesFleetReport", "engines_fleet_json"]


class EngineRemark(msgspec.Struct, frozen=True):
    """What an engine changed in an arm, in words."""

    engine: str
    summary: str


class FleetArmValue(msgspec.Struct, frozen=True, kw_only=True):
    """One arm in all engines."""

    name: str
    joints: int
    verdict: AgreementVerdict
    why: list[EngineRemark]


class EnginesFleetReport(Report, frozen=True, kw_only=True, tag="ur5check.engines-fleet/2"):
    """Every serial arm of example-robot-data in all engines."""

    agree: bool
    arms: list[FleetArmValue]


def engines_fleet_json(
    fleet: FleetReport, *, limit: float = SAME_ROBOT, as_read: bool = False, command: str = ""
) -> EnginesFleetReport:
    """The report of `ur5check engines --fleet`; limit, as_read : as for `engines_document`."""
    arms = [report.arm for report in fleet.reports]
    return EnginesFleetReport(
        **head(arms, command, seed=fleet.seed, samples=fleet.samples),
        agree=fleet.agrees(limit, as_read=as_read),
        arms=[
            FleetArmValue(
                name=report.arm.name,
                joints=report.arm.n,
                verdict=verdict_value(report, limit, as_read),
                why=[
                    EngineRemark(reading.key, import_clause(reading))
                    for reading in report.as_read.readings
                    if reading.refused is not None or reading.harmful
                ],
            )
            for report in fleet.reports
        ],
    )
