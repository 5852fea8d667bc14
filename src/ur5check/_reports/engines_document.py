"""The report of `engines MODEL`."""

from __future__ import annotations

from collections.abc import Sequence

from .._engines.audit.engine_comparison import SAME_ROBOT, EngineReport, Stage
from .._engines.audit.engine_reading import Reading
from .._engines.audit.import_difference import ImportDifference
from .._engines.registry import REFERENCE, REGISTRY
from .._robot.robot_tree import tree_links
from .document import Column, Document, Row, Section, Table, Verdict
from .engines_summary import summarize
from .provenance import Provenance, inputs_of
from .wording import MISSING, figures, residue

__all__ = ["engines_document"]

_MOST_NAMES = 2


def engines_document(
    report: EngineReport,
    *,
    model: str = "",
    limit: float = SAME_ROBOT,
    as_read: bool = False,
    command: str = "",
) -> Document:
    """The report of `ur5check engines MODEL`.

    model : what the user called it;  limit : fail over this [N m]
    as_read : whether the plain import is judged, not that with fixes
    """
    verdict, *lines = summarize(report, model, limit)
    good = (report.as_read if as_read else report.final).agrees(limit)
    word = "AGREE" if good else "DIFFER"
    if good and not report.as_read.agrees(limit):
        word = "AGREE ONCE REPAIRED"
    return Document(
        f"{report.arm.name}{', whole robot' if report.whole else ''}: engine agreement",
        Verdict(word, verdict, good),
        tuple(lines),
        (_agreement(report, limit), _imports(report), _engines(report)),
        Provenance(inputs_of([report.arm]), report.seed, report.samples, command),
    )


def _agreement(report: EngineReport, limit: float) -> Section:
    if len(report.final.matrix.keys) < 2:
        return Section("Differences between the engines", ("There is one engine only.",))
    tables = (_torques(report), _answers(report, limit))
    return Section("Differences between the engines", (), tables)


def _torques(report: EngineReport) -> Table:
    """Above the diagonal as read, below it repaired."""
    keys = [reading.key for reading in report.as_read.readings]
    columns = [Column(REGISTRY[key].title, number=True) for key in keys]
    rows = []
    for i, a in enumerate(keys):
        above = [_torque(report.as_read, a, b) if i < j else "" for j, b in enumerate(keys)]
        below = [_torque(report.final, a, b) if i > j else "" for j, b in enumerate(keys)]
        cells = [x or y or "·" for x, y in zip(above, below, strict=True)]
        rows.append(Row((REGISTRY[a].title, *cells)))
    note = f"The largest of {len(report.states):,} states"
    extra = len(report.states) - report.samples
    note += f", {extra} of them found by gradient ascent." if extra else "."
    if report.repaired is not None:
        note = f"Above the diagonal: as read. Below it: repaired. {note}"
    return Table((Column("|Δτ| [N m]"), *columns), tuple(rows), note=note)


def _torque(stage: Stage, a: str, b: str) -> str:
    if a not in stage.matrix.keys or b not in stage.matrix.keys:
        return MISSING
    return residue(stage.matrix.between(a, b).torque)


def _answers(report: EngineReport, limit: float) -> Table:
    """Torque, M, h, accelerations and tool of every engine against the reference."""
    rows = []
    for name, stage in report.stages():
        for key in stage.matrix.keys[1:]:
            if (
                name == "repaired"
                and stage.reading(key).engine is report.as_read.reading(key).engine
            ):
                continue  # it needed no repair: the same answers
            p = stage.matrix.between(REFERENCE, key)
            numbers = (p.torque, p.mass, p.bias, p.acceleration, p.tool)
            joint = report.arm.joint_names[p.joint] if p.torque > limit else MISSING
            cells = (REGISTRY[key].title, name, *map(residue, numbers), joint)
            rows.append(Row(cells, bad=p.torque > limit))
    return Table(
        (
            Column("engine"),
            Column("model"),
            Column("|Δτ| [N m]", number=True),
            Column("|ΔM| [kg m²]", number=True),
            Column("|Δh| [N m]", number=True),
            Column("|Δq̈| [of q̈]", number=True),
            Column("last link [m]" if report.whole else "tool [m]", number=True),
            Column("worst joint"),
        ),
        tuple(rows),
        title="Each engine against the hand-written recursion",
        note="h = C q̇ + g. Accelerations under equal torques, relative to the largest.",
    )


def _imports(report: EngineReport) -> Section:
    rows = [
        row
        for reading in report.as_read.readings
        if reading.key != REFERENCE and reading.imported is not None
        for row in _differences(reading)
    ]
    if not rows:
        return Section("Import differences", ("None.",))
    explained = "They explain all torque differences." if report.explained else ""
    table = Table(
        (
            Column("engine"),
            Column("what"),
            Column("where"),
            Column("the file"),
            Column("the engine"),
            Column("effect [N m]", number=True),
        ),
        tuple(rows),
        note=f"Effect: the largest |Δτ| of this difference alone. {MISSING}: no torque changes. "
        f"{explained}".strip(),
    )
    repairs = tuple(
        f"{reading.title}: {known_issue.title}. {known_issue.explanation} Fix: {known_issue.fix}."
        for reading in report.as_read.readings
        if reading.imported is not None
        for known_issue in dict.fromkeys(one.known_issue for one in reading.imported.harmful)
        if known_issue is not None
    )
    return Section("Import differences", repairs, (table,))


def _differences(reading: Reading) -> list[Row]:
    """One row per kind."""
    if reading.imported is None:
        return []
    by_kind: dict[str, list[ImportDifference]] = {}
    for one in reading.imported.differences:
        by_kind.setdefault(one.kind, []).append(one)
    return [_row(reading.title, alike) for alike in by_kind.values()]


def _row(title: str, alike: Sequence[ImportDifference]) -> Row:
    first = alike[0]
    costs = [one.torque_effect for one in alike if one.torque_effect is not None]
    imported = {one.imported for one in alike}
    written = {one.written for one in alike}
    return Row(
        (
            title,
            first.kind,
            _places(alike),
            _short(first.written if len(written) == 1 else f"{first.written}, …"),
            _short(first.imported if len(imported) == 1 else f"{first.imported}, …"),
            figures(max(costs)) if costs else MISSING,
        ),
        bad=first.harmful,
    )


def _places(alike: Sequence[ImportDifference]) -> str:
    names = [one.where for one in alike if one.where]
    if len(names) > _MOST_NAMES:
        return f"{len(names)} {names[0].partition(' ')[0]}s"
    return ", ".join(names) or "the whole model"


def _short(text: str, most: int = 40) -> str:
    return text if len(text) <= most else f"{text[: most - 1].rstrip(', ')} …"


def _engines(report: EngineReport) -> Section:
    rows = [
        Row(
            (r.title, r.version, r.route or "–", r.refused or _imported_bodies(r)),
            bad=r.refused is not None,
        )
        for r in report.as_read.readings
    ]
    table = Table(
        (Column("engine"), Column("version"), Column("route"), Column("imported")), tuple(rows)
    )
    lines = [
        f"{reading.title} warns: {_short(reading.warnings[0], 160)}"
        + (f" ({len(reading.warnings) - 1} more)" if len(reading.warnings) > 1 else "")
        for reading in report.as_read.readings
        if reading.warnings
    ]
    lines += [
        f"{REGISTRY[key].title} is not installed: pip install 'ur5check[{REGISTRY[key].extra}]'"
        for key in report.absent
    ]
    return Section("The engines", tuple(lines), (table,))


def _imported_bodies(reading: Reading) -> str:
    if reading.imported is None:
        return MISSING
    mass = sum(body.inertia.mass for body in reading.imported.imported_model.bodies)
    links = tree_links(reading.imported.imported_arm)
    moving = sum(each.link.inertia.mass for each in links)
    bodies = len(reading.imported.imported_model.bodies)
    return f"{bodies} bodies, {mass:.6g} kg, {moving:.6g} kg of them moving"
