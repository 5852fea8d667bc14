"""What `engines --fleet` shows: a row an arm."""

from __future__ import annotations

from .._engines.audit.engine_comparison import SAME_ROBOT, EngineReport, Stage
from .._engines.audit.fleet_comparison import FleetReport
from .document import Column, Document, Row, Section, Table, Verdict
from .engines_summary import deed
from .provenance import Provenance, inputs_of
from .wording import joined, residue

__all__ = ["engines_fleet_document"]


def engines_fleet_document(
    fleet: FleetReport, *, limit: float = SAME_ROBOT, as_read: bool = False, command: str = ""
) -> Document:
    """The report of `ur5check engines --fleet`; limit, as_read : as for `engines_document`.

    Held together are, arm by arm, the engines that can read it.
    """
    stages = [report.as_read if as_read else report.final for report in fleet.reports]
    good = all(stage.matrix.worst <= limit for stage in stages)
    return Document(
        f"{len(fleet.reports)} arms: do all engines mean the same robots?",
        Verdict("AGREE" if good else "DIFFER", _verdict(fleet, limit), good),
        _refusals(fleet),
        (Section("Arm by arm", (), (_table(fleet, limit),)),),
        Provenance(inputs_of(r.arm for r in fleet.reports), fleet.seed, fleet.samples, command),
    )


def _verdict(fleet: FleetReport, limit: float) -> str:
    n = len(fleet.reports)
    same = sum(report.as_read.matrix.worst <= limit for report in fleet.reports)
    said = f"as read, the engines hold the same robot for {same} of {n} arms"
    if same < n:
        repaired = sum(report.final.matrix.worst <= limit for report in fleet.reports)
        said += f"; with the fixes for {repaired if repaired < n else 'all'}"
        said += f" of {n}" if repaired < n else ""
    return f"{said}, to {fleet.worst(as_read=False):.1e} N m."


def _refusals(fleet: FleetReport) -> tuple[str, ...]:
    """An arm that an engine cannot read is no disagreement, and is said."""
    return tuple(
        f"{report.arm.name} is not held against {reading.title}: {reading.refused}"
        for report in fleet.reports
        for reading in report.final.refusals
    )


def _table(fleet: FleetReport, limit: float) -> Table:
    columns = (
        Column("arm"),
        Column("joints", number=True),
        Column("as read [N m]", number=True),
        Column("with fixes [N m]", number=True),
        Column("why"),
    )
    return Table(
        columns,
        tuple(_row(report, limit) for report in fleet.reports),
        note="The worst |Δτ| of any two engines. Each arm is a file of example-robot-data.",
    )


def _row(report: EngineReport, limit: float) -> Row:
    why = []
    for reading in report.as_read.readings:
        if reading.key != "own" and _deviates(report.as_read, reading.key, limit):
            why.append(f"{reading.title} {deed(reading)}")
    if not report.explained:
        why.append("not all of it is explained")
    return Row(
        (
            report.arm.name,
            str(report.arm.n),
            residue(report.as_read.matrix.worst),
            residue(report.final.matrix.worst),
            joined(why) if why else "",
        ),
        bad=report.final.matrix.worst > limit,
    )


def _deviates(stage: Stage, key: str, limit: float) -> bool:
    if key not in stage.matrix.keys:
        return True
    return stage.matrix.between("own", key).torque > limit
