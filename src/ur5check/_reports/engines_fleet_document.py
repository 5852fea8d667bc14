"""The report of `engines --fleet`: one row per arm."""

from __future__ import annotations

from .._engines.audit.engine_comparison import SAME_ROBOT, EngineReport, Stage
from .._engines.audit.fleet_comparison import FleetReport
from .._engines.registry import REFERENCE
from .document import Column, Document, Row, Section, Table, Verdict
from .engines_summary import fleet_verdict, import_clause
from .provenance import Provenance, inputs_of
from .wording import joined, residue

__all__ = ["engines_fleet_document"]


def engines_fleet_document(
    fleet: FleetReport, *, limit: float = SAME_ROBOT, as_read: bool = False, command: str = ""
) -> Document:
    """The report of `ur5check engines --fleet`; limit, as_read : as for `engines_document`.

    Compared are, arm by arm, the engines that read it; a refusal is no agreement.
    """
    good = fleet.agrees(limit, as_read=as_read)
    differ = fleet.differing(limit, as_read=as_read) > 0
    word = "AGREE" if good else "DIFFER" if differ else "REFUSED"
    return Document(
        f"Engine agreement on {len(fleet.reports)} arms",
        Verdict(word, f"{fleet_verdict(fleet, limit)}.", good),
        _refusals(fleet),
        (Section("Arm by arm", (), (_table(fleet, limit),)),),
        Provenance(inputs_of(r.arm for r in fleet.reports), fleet.seed, fleet.samples, command),
    )


def _refusals(fleet: FleetReport) -> tuple[str, ...]:
    """One line per arm and engine that refuses it."""
    return tuple(
        f"{report.arm.name} is refused by {reading.title}: {reading.refused}"
        for report in fleet.reports
        for reading in report.final.refusals
    )


def _table(fleet: FleetReport, limit: float) -> Table:
    columns = (
        Column("arm"),
        Column("joints", number=True),
        Column("as read [N m]", number=True),
        Column("repaired [N m]", number=True),
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
        if reading.key != REFERENCE and _deviates(report.as_read, reading.key, limit):
            why.append(f"{reading.title} {import_clause(reading)}")
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
        bad=not report.final.agrees(limit),
    )


def _deviates(stage: Stage, key: str, limit: float) -> bool:
    if key not in stage.matrix.keys:
        return True
    return stage.matrix.between(REFERENCE, key).torque > limit
