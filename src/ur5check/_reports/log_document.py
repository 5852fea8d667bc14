"""What `log` shows: residuals joint by joint, drives, causes, faults of the recording."""

from __future__ import annotations

import math

from .._finding import Finding
from .._logs.causes import EVIDENCE
from .._logs.comparison import RecordingComparison
from .._logs.parameters import BETWEEN_RUNS
from .document import Column, Document, Row, Section, Table, Verdict
from .log_summary import (
    cause_in_words,
    floor_in_words,
    summarize_log,
    verdict_of_log,
    word_of_log,
)
from .provenance import Provenance, inputs_of
from .wording import MISSING, figures, titled

__all__ = ["log_document"]


#: What a half width is, and how far to trust it: docs/recordings-benchmark.md.
_INTERVAL = (
    "± is nominally 95 %, by the scatter between blocks of this recording; in simulated runs with "
    "dry friction it held the truth in 50 to 83 %"
)


def log_document(c: RecordingComparison, *, command: str = "") -> Document:
    """The report of `ur5check log`."""
    return Document(
        f"{titled(c.arm)} against {c.recording.file}",
        Verdict(word_of_log(c), verdict_of_log(c), c.passed),
        summarize_log(c),
        (_recording(c), _residuals(c), _drives(c), _causes(c), _parameters(c), *_gains(c)),
        Provenance((*inputs_of((c.arm,)), *c.recording.inputs), command=command),
    )


def _recording(c: RecordingComparison) -> Section:
    r, s = c.recording, c.signals
    lines = (
        f"{r.count:,} of {c.rows:,} rows, {r.duration:.4g} s at {r.rate:.4g} Hz; low-pass at "
        f"{s.cutoff:.3g} Hz, zero phase; {s.count:,} samples kept.",
        "Velocity from position." if s.velocity_from_position else "Velocity as recorded.",
        *r.columns,
    )
    tables = (_findings(c.findings),) if c.findings else ()
    return Section("The recording", lines, tables)


def _findings(findings: tuple[Finding, ...]) -> Table:
    return Table(
        (Column("rule"), Column("severity"), Column("where"), Column("what")),
        tuple(
            Row((f.rule, f.severity, str(f.place) or MISSING, f"{f.subject} {f.message}"))
            for f in findings
        ),
    )


def _residuals(c: RecordingComparison) -> Section:
    rows = [
        Row(
            (
                joint.name,
                figures(joint.measured),
                figures(joint.model),
                figures(joint.alone),
                figures(joint.with_friction),
                figures(joint.with_rotor),
                figures(joint.floor),
                f"{joint.above_floor:.2f}" if joint.stands_out else MISSING,
                _interval(joint.scale, joint.scale_half_width),
            )
        )
        for joint in c.joints
    ]
    columns = ("measured", "model", "difference", "+ friction", "+ rotor", "floor", "÷ floor")
    return Section(
        "Residuals",
        (floor_in_words(),),
        (
            Table(
                (
                    Column("joint"),
                    *(Column(name, number=True) for name in columns),
                    Column("scale", number=True),
                ),
                tuple(rows),
                note="Standard deviations [N m]. Scale: of the model's torque, that fits best. "
                f"{MISSING}: the model's torque does not stand out.",
            ),
        ),
    )


def _drives(c: RecordingComparison) -> Section:
    names = c.friction.names
    rows = [
        Row(
            (
                joint.name,
                *(
                    _interval(value, width)
                    for value, width in zip(joint.drive.value, joint.drive.half_width, strict=True)
                ),
            )
        )
        for joint in c.joints
    ]
    return Section(
        "Friction and rotor inertia",
        tables=(
            Table(
                (Column("joint"), *(Column(name, number=True) for name in names)),
                tuple(rows),
                note="Viscous [N m s/rad], Coulomb, offset and transition [N m], rotor [kg m²]; "
                f"{_INTERVAL}. Between recordings such values scatter about three times as much.",
            ),
        ),
    )


def _causes(c: RecordingComparison) -> Section:
    rows = [
        Row((cause_in_words(cause, c), f"{cause.evidence:.0f}", "yes" if cause in c.named else ""))
        for cause in c.causes[:8]
    ]
    return Section(
        "Single causes, each alone",
        tables=(
            Table(
                (Column("cause"), Column("evidence", number=True), Column("named")),
                tuple(rows),
                note="Evidence: the fall of the weighted sum of squares, less what chance would "
                f"take. A cause is named above {EVIDENCE:g}, where the model is not at the floor "
                "and the cause removes most of what free parameters remove; others within "
                f"{EVIDENCE:g} of the best are possible too.",
            ),
        ),
    )


def _parameters(c: RecordingComparison) -> Section:
    rows = [
        Row(
            (
                parameter.combination,
                figures(parameter.given),
                _interval(parameter.change, parameter.half_width),
                "yes" if parameter.differs else "" if parameter.excited else "not excited",
            )
        )
        for parameter in c.parameters
    ]
    validation: tuple[Table, ...] = ()
    if c.validation is not None:
        v = c.validation
        validation = (
            Table(
                (
                    Column("joint"),
                    Column("given", number=True),
                    Column("fitted", number=True),
                    Column("floor", number=True),
                ),
                tuple(
                    Row((joint.name, *map(figures, sizes)))
                    for joint, *sizes in zip(c.joints, v.given, v.fitted, v.floor, strict=True)
                ),
                note=f"Residuals on {v.file} [N m]: the given model and the fitted parameters, "
                "both with drives fitted here; its own floor.",
            ),
        )
    return Section(
        "Base parameters",
        (
            f"{sum(p.excited for p in c.parameters)} of {len(c.parameters)} are determined by this "
            "recording to better than their own size.",
        ),
        (
            Table(
                (
                    Column("combination"),
                    Column("model", number=True),
                    Column("change", number=True),
                    Column("differs"),
                ),
                tuple(rows),
                note=f"SI units, in the links' own frames i. {_INTERVAL}; a change counts beyond "
                f"{BETWEEN_RUNS:g} times that, the scatter "
                "between recordings. Masses of single links are not among what torques determine.",
            ),
            *validation,
        ),
    )


def _gains(c: RecordingComparison) -> tuple[Section, ...]:
    if not c.gains:
        return ()
    rows = [Row((gain.joint, _interval(gain.value, gain.half_width))) for gain in c.gains]
    return (
        Section(
            "Drive gains from current and the controller's torque",
            tables=(Table((Column("joint"), Column("gain [N m/A]", number=True)), tuple(rows)),),
        ),
    )


def _interval(value: float, half_width: float) -> str:
    if math.isnan(value):
        return MISSING
    if math.isnan(half_width) or half_width == 0.0:
        return figures(value)
    digits = max(0, 1 - math.floor(math.log10(half_width)))
    return f"{value:.{digits}f} ± {half_width:.{digits}f}"
