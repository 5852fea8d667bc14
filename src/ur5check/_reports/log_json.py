"""`ur5check log` as JSON."""

from __future__ import annotations

from typing import Literal

import msgspec

from .._logs.cause import CauseId
from .._logs.comparison import RecordingComparison
from .._logs.least_squares import Fit
from .._logs.point_mass import PointMass
from .finding_json import FindingValue, finding_value
from .json_report import Report, head
from .json_values import Model, Number, Vector, model_value, vector
from .log_summary import cause_in_words, summarize_log, verdict_of_log, word_of_log

__all__ = ["LogReport", "log_json"]


class LogVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """Whether the recording can judge the model, and whether the model explains it."""

    word: Literal["PASS", "FAIL", "UNUSABLE"]
    passed: bool
    usable: bool
    at_floor: bool


class RecordingValue(msgspec.Struct, frozen=True, kw_only=True):
    """The recording: rows of the file and rows used, duration [s], rate and cut-off [Hz]."""

    file: str
    rows: int
    rows_used: int
    duration: float
    rate: float
    cutoff: float
    samples_kept: int
    velocity_from_position: bool
    columns: list[str]


class Interval(msgspec.Struct, frozen=True, kw_only=True):
    """A value; value ± half_width is nominally a 95 % interval, which in simulated runs with dry
    friction held the truth in 50 to 83 % (docs/recordings-benchmark.md).
    """

    name: str
    value: Number
    half_width: Number
    unit: str = ""


class JointValue(msgspec.Struct, frozen=True, kw_only=True):
    """One joint: standard deviations [N m] of each stage, the usual fit of friction, the fit of the
    drive with rotor inertia, the best scale.
    """

    joint: str
    measured: float
    model: float
    difference: float
    with_friction: float
    with_rotor: float
    floor: float
    stands_out: bool
    friction: list[Interval]
    drive: list[Interval]
    scale: Number
    scale_half_width: Number


class CauseValue(msgspec.Struct, frozen=True, kw_only=True):
    """One cause, tested alone."""

    id: CauseId
    joint: int | None
    named: bool
    sentence: str
    values: list[Interval]
    evidence: float
    closes: float
    residuals: Vector
    mistake: str | None
    how: str | None


class ParameterValue(msgspec.Struct, frozen=True, kw_only=True):
    """One base parameter in SI units: the model's value, and the change that the recording asks
    for, with its nominal 95 % interval.
    """

    parameter: str
    combination: str
    given: float
    change: Number
    half_width: Number
    excited: bool
    differs: bool


class ValidationValue(msgspec.Struct, frozen=True, kw_only=True):
    """The fit tried on another recording: its residuals, joint by joint [N m]."""

    file: str
    given: Vector
    fitted: Vector
    floor: Vector
    helps: bool


class RivalValue(msgspec.Struct, frozen=True, kw_only=True):
    """Another model: its mean squared weighted residual less the first one's."""

    label: str
    difference: float
    half_width: float
    clear: bool


class LogReport(Report, frozen=True, kw_only=True, tag="ur5check.log/1"):
    """A model against a recording."""

    verdict: LogVerdict
    summary: list[str]
    model: Model
    recording: RecordingValue
    findings: list[FindingValue]
    joints: list[JointValue]
    causes: list[CauseValue]
    parameters: list[ParameterValue]
    load: list[Interval] | None
    validation: ValidationValue | None
    rivals: list[RivalValue]
    gains: list[Interval]


def log_json(c: RecordingComparison, *, command: str = "") -> LogReport:
    """The report of `ur5check log`."""
    r, s = c.recording, c.signals
    names = c.friction.names
    return LogReport(
        **head([c.arm], command, files=r.inputs),
        verdict=LogVerdict(
            word=word_of_log(c),  # type: ignore[arg-type]
            passed=c.passed,
            usable=c.usable,
            at_floor=c.at_floor,
        ),
        summary=[verdict_of_log(c), *summarize_log(c)],
        model=model_value(c.arm),
        recording=RecordingValue(
            file=r.file,
            rows=c.rows,
            rows_used=r.count,
            duration=r.duration,
            rate=r.rate,
            cutoff=s.cutoff,
            samples_kept=s.count,
            velocity_from_position=s.velocity_from_position,
            columns=list(r.columns),
        ),
        findings=[finding_value(finding) for finding in c.findings],
        joints=[
            JointValue(
                joint=joint.name,
                measured=joint.measured,
                model=joint.model,
                difference=joint.alone,
                with_friction=joint.with_friction,
                with_rotor=joint.with_rotor,
                floor=joint.floor,
                stands_out=joint.stands_out,
                friction=_intervals(c.friction.usual_names, joint.friction),
                drive=_intervals(names, joint.drive),
                scale=joint.scale,
                scale_half_width=joint.scale_half_width,
            )
            for joint in c.joints
        ],
        causes=[
            CauseValue(
                id=cause.id,
                joint=cause.joint or None,
                named=cause in c.named,
                sentence=cause_in_words(cause, c),
                values=[
                    Interval(name=name, value=float(value), half_width=float(width), unit=unit)
                    for name, unit, value, width in zip(
                        cause.names, cause.units, cause.value, cause.half_width, strict=True
                    )
                ],
                evidence=cause.evidence,
                closes=cause.closes,
                residuals=vector(cause.sizes),
                mistake=cause.mistake or None,
                how=cause.how or None,
            )
            for cause in c.causes
        ],
        parameters=[
            ParameterValue(
                parameter=p.name,
                combination=p.combination,
                given=p.given,
                change=p.change,
                half_width=p.half_width,
                excited=p.excited,
                differs=p.differs,
            )
            for p in c.parameters
        ],
        load=None if c.load is None else _load(c.load),
        validation=None
        if c.validation is None
        else ValidationValue(
            file=c.validation.file,
            given=vector(c.validation.given),
            fitted=vector(c.validation.fitted),
            floor=vector(c.validation.floor),
            helps=c.validation.helps,
        ),
        rivals=[
            RivalValue(
                label=rival.label,
                difference=rival.difference,
                half_width=rival.half_width,
                clear=rival.clear,
            )
            for rival in c.rivals
        ],
        gains=[
            Interval(name=g.joint, value=g.value, half_width=g.half_width, unit="N m/A")
            for g in c.gains
        ],
    )


def _load(load: PointMass) -> list[Interval]:
    labels = (("mass", "kg"), ("centre x", "m"), ("centre y", "m"), ("centre z", "m"))
    return [
        Interval(name=name, value=float(value), half_width=float(width), unit=unit)
        for (name, unit), value, width in zip(labels, load.value, load.half_width, strict=True)
    ]


def _intervals(names: tuple[str, ...], fitted: Fit) -> list[Interval]:
    return [
        Interval(name=name, value=float(value), half_width=float(width))
        for name, value, width in zip(names, fitted.value, fitted.half_width, strict=True)
    ]
