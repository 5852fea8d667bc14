"""The comparison of engines in a few sentences, the verdict first."""

from __future__ import annotations

from collections.abc import Sequence

from .._engines.audit.engine_comparison import SAME_ROBOT, EngineReport
from .._engines.audit.engine_reading import Reading
from .._engines.audit.fleet_comparison import FleetReport
from .._engines.audit.import_difference import ImportDifference, Kind
from .._engines.registry import REFERENCE, REGISTRY
from .wording import joined

__all__ = ["fleet_verdict", "import_clause", "summarize"]

_LOST: dict[Kind, str] = {
    "position-limit": "position limits",
    "velocity-limit": "velocity limits",
    "effort-limit": "effort limits",
    "damping": "damping",
    "friction": "friction",
}
_NOTHING = ("none", "0")
_NOTES: dict[Kind, str] = {
    "order": "has its joints in another order",
    "gravity": "has another default gravity",
    "tool": "has the tool frame elsewhere",
}


def summarize(report: EngineReport, model: str = "", limit: float = SAME_ROBOT) -> tuple[str, ...]:
    """The verdict, what the repairs leave, what is not explained, what users must know.

    model : as the user named it;  limit : largest torque difference that counts as agreement [N m]
    """
    lines = [_verdict(report, model or report.arm.name, limit), _repairs(report, limit)]
    for name, stage in report.stages():
        lines += [
            f"Not explained: {r.title} {name} is {_force(r.explanation.gap)} away from what it "
            "imported."
            for r in stage.unexplained
            if r.explanation is not None
        ]
    lines += [f"{r.refused}." for r in report.as_read.readings if r.refused is not None]
    lines += [_use(reading) for reading in report.as_read.readings]
    lines.append(_mimic(report))
    return tuple(line for line in lines if line)


def import_clause(reading: Reading) -> str:
    """What an engine did to the arm, as a clause: "has added 2 kg"."""
    if reading.refused is not None:
        return "refuses the model"
    follows = reading.explanation.follows if reading.explanation else ()
    if "order" in follows:
        return "uses its own joint order"
    if "gravity" in follows:
        return "uses its own gravity"
    harmful = reading.imported.harmful if reading.imported else ()
    if not harmful:
        return "computes other torques"
    worst = max(harmful, key=lambda one: one.torque_effect or 0.0)
    alike = [one for one in harmful if one.kind == worst.kind]
    return _CLAUSES.get(worst.kind, _other)(alike)


def fleet_verdict(fleet: FleetReport, limit: float) -> str:
    """On how many arms the engines agree, as read and repaired; refusals are counted apart."""
    n = len(fleet.reports)
    text = f"as read, all engines agree on {fleet.agreeing(limit, as_read=True)} of {n} arms"
    differ = fleet.differing(limit, as_read=True)
    if differ:
        left = fleet.differing(limit, as_read=False)
        text += f" and differ on {differ}; with the repairs they agree on "
        text += f"{fleet.agreeing(limit, as_read=False)} and differ on {left or 'none'}"
    refused = fleet.refused(as_read=False)
    if refused:
        text += f"; {refused} {'is' if refused == 1 else 'are'} refused by at least one engine"
    return text


def _added(alike: Sequence[ImportDifference]) -> str:
    return f"has added {_mass(sum(one.mass for one in alike))}"


def _lost(alike: Sequence[ImportDifference]) -> str:
    return f"has lost {_mass(-sum(one.mass for one in alike))}"


def _unrotated(alike: Sequence[ImportDifference]) -> str:
    return f"has left {_count(alike, 'tensor')} unrotated"


def _motors(alike: Sequence[ImportDifference]) -> str:
    return f"has another motor inertia at {_count(alike, 'joint')}"


def _axes(alike: Sequence[ImportDifference]) -> str:
    return "has another axis of a joint" if len(alike) == 1 else "has other axes of joints"


def _other(alike: Sequence[ImportDifference]) -> str:
    what = {"mass-changed": "mass", "com-moved": "centre of mass", "tensor-changed": "tensor"}
    place = alike[0].where if len(alike) == 1 else f"{len(alike)} links"
    return f"has another {what.get(alike[0].kind, alike[0].kind)} of {place}"


_CLAUSES = {
    "default-inertia": _added,
    "shape-mass": _added,
    "body-lost": _lost,
    "rotation-dropped": _unrotated,
    "armature": _motors,
    "axis": _axes,
}


def _verdict(report: EngineReport, model: str, limit: float) -> str:
    stage = report.as_read
    groups = stage.matrix.agreeing(limit)
    same = next(group for group in groups if REFERENCE in group)
    others = [r for r in stage.readings if r.key not in same]
    if len(stage.readings) == 1:
        return "Only ur5check has read the model: install another engine to compare."
    names = joined([REGISTRY[key].title for key in same])
    said = f"{names} agree" if len(same) > 1 else f"No engine agrees with {names}"
    said += "; " + "; ".join(_deviant(report, r) for r in others) if others else ""
    repairable = [r.key for r in others if _is_repaired(report, r.key, limit)]
    if not repairable:
        return f"{said}."
    commands = joined([f"`ur5check expand {model} --for {key}`" for key in repairable])
    return f"{said}. {commands} {'repairs it' if len(repairable) == 1 else 'repair it'}."


def _deviant(report: EngineReport, reading: Reading) -> str:
    clause = f"{reading.title} {import_clause(reading)}"
    if reading.refused is not None:
        return clause
    worst = report.as_read.matrix.between(REFERENCE, reading.key)
    name = report.arm.joint_names[worst.joint]
    return f"{clause}: {_force(worst.torque)} at joint {worst.joint + 1} ({name})"


def _is_repaired(report: EngineReport, key: str, limit: float) -> bool:
    if report.repaired is None or report.repaired.reading(key).refused is not None:
        return False
    return report.repaired.matrix.between(REFERENCE, key).torque <= limit


def _repairs(report: EngineReport, limit: float) -> str:
    if report.repaired is None:
        return ""
    worst = report.repaired.matrix.worst
    if report.repaired.agrees(limit):
        return f"Repaired, all engines agree to {_force(worst)}."
    left = [f"{r.title} refuses the model" for r in report.repaired.refusals] + (
        [f"torques differ by up to {_force(worst)}"] if worst > limit else []
    )
    return f"Repaired, {joined(left)}."


def _use(reading: Reading) -> str:
    """Differences that change no torque but matter to users of the engine."""
    if reading.imported is None or reading.key == REFERENCE:
        return ""
    kinds = reading.imported.kinds
    differ = [kind for kind in _LOST if kinds[kind]]
    lost = [k for k in differ if all(one.imported in _NOTHING for one in _alike(reading, k))]
    other = [kind for kind in differ if kind not in lost]
    without = joined([_LOST[kind] for kind in lost]).replace(" and ", " or ") if lost else ""
    notes = [f"keeps no {without}"] if lost else []
    if other:
        notes.append(f"keeps other {joined([_LOST[kind] for kind in other])} than the file")
    notes += [words for kind, words in _NOTES.items() if kinds[kind]]
    return f"{reading.title} {joined(notes)}." if notes else ""


def _mimic(report: EngineReport) -> str:
    """How joints that mimic others take part."""
    count = len(report.mimic)
    if not count:
        return ""
    joints = "1 joint mimics another" if count == 1 else f"{count} joints mimic others"
    return (
        f"{joints}: every engine is asked for all {count + report.arm.n} joints, and its answers "
        "are taken to the coordinates by the same constraint, M = Gᵀ M_joints G."
    )


def _alike(reading: Reading, kind: Kind) -> list[ImportDifference]:
    found = reading.imported.differences if reading.imported else ()
    return [one for one in found if one.kind == kind]


def _mass(mass: float) -> str:
    return f"{mass:.3g} kg" if abs(mass) >= 0.01 else f"{1e3 * mass:.3g} g"


def _force(value: float) -> str:
    return f"{value:.4g} N m" if value >= 1e-3 or value == 0.0 else f"{value:.1e} N m"


def _count(alike: Sequence[ImportDifference], noun: str) -> str:
    return f"1 {noun}" if len(alike) == 1 else f"{len(alike)} {noun}s"
