"""Verdicts on many models, and whether two of them agree.

A model passes if no finding at or above the fail level is open, after what the project accepts, and
no law of the computation failed.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from glob import glob, has_magic
from pathlib import Path

from .._comparison.difference import Difference
from .._errors import EngineError, InputError
from .._finding import SEVERITIES, Finding, Severity
from .._robot.labels import labelled
from .._rules.finding_log import finding_of
from .configuration import Configuration, Sorted
from .judgement import Judgement, judge
from .validation import PairValidation, validate_pair

__all__ = [
    "PairVerdict",
    "Request",
    "Verdict",
    "VerdictSet",
    "compare_verdicts",
    "files_under",
    "verdicts",
]

#: What a folder is searched for.
_PATTERNS = ("*.urdf", "*.urdf.xacro")


@dataclass(frozen=True)
class Request:
    """How one model is to be judged: the arguments of `judge`."""

    model: str
    base: str | None = None
    tip: str | None = None
    arm: str | None = None
    hold: tuple[tuple[str, float], ...] = ()
    packages: tuple[tuple[str, str], ...] = ()
    arguments: tuple[tuple[str, str], ...] = ()
    samples: int = 1000
    seed: int = 0
    payload: float = 0.0
    expected_mass: float | None = None
    meshes: bool = True
    engines: tuple[str, ...] = ()

    def with_settings(self, configuration: Configuration) -> Request:
        """The request with what the configuration says of the file, where it says more.

        What the request has itself counts first.
        """
        settings = configuration.settings_of(self.model)
        chosen = (self.base, self.tip, self.arm) != (None, None, None)
        base, tip, arm = (
            (self.base, self.tip, self.arm)
            if chosen
            else (settings.base, settings.tip, settings.arm)
        )
        arguments = dict(settings.arguments) | dict(self.arguments)
        mass = settings.expected_mass if self.expected_mass is None else self.expected_mass
        return replace(
            self,
            base=base,
            tip=tip,
            arm=arm,
            arguments=tuple(arguments.items()),
            expected_mass=mass,
        )

    def judge(self) -> Judgement:
        """Raises UsageError as `judge` does."""
        return judge(
            self.model,
            base=self.base,
            tip=self.tip,
            arm=self.arm,
            hold=dict(self.hold),
            packages=dict(self.packages),
            arguments=dict(self.arguments),
            samples=self.samples,
            seed=self.seed,
            payload=self.payload,
            expected_mass=self.expected_mass,
            meshes=self.meshes,
            engines=self.engines,
        )


@dataclass(frozen=True, eq=False)
class Verdict:
    """judgement : of one model;  findings : as the project's configuration sorts them"""

    judgement: Judgement
    findings: Sorted
    fail_level: Severity

    @property
    def passed(self) -> bool:
        """Whether nothing open is at or above the fail level, and no law failed."""
        worst = SEVERITIES.index(self.fail_level)
        open_ones = (SEVERITIES.index(f.severity) for f in self.findings.open)
        return self.judgement.laws_hold and all(severity > worst for severity in open_ones)


def files_under(paths: Sequence[str]) -> list[str]:
    """The models that paths stand for: a folder or a pattern for the files in it, sorted."""
    found: list[str] = []
    for path in paths:
        folder = Path(path)
        if folder.is_dir():
            inside = {str(file) for pattern in _PATTERNS for file in folder.rglob(pattern)}
            found += sorted(inside)
        elif has_magic(path) and not folder.exists():
            matching = glob(path, recursive=True)  # noqa: PTH207 - absolute patterns too
            found += sorted(name for name in matching if Path(name).is_file())
        else:
            found.append(path)
    return found


def verdicts(
    requests: Sequence[Request],
    configuration: Configuration,
    fail_level: Severity,
    *,
    jobs: int = 1,
    progress: Callable[[str], None] | None = None,
) -> Iterator[Verdict]:
    """A verdict for each request, in order; with several jobs in as many processes.

    Raises UsageError as `judge` does.
    """
    say = progress or (lambda line: None)
    if jobs <= 1 or len(requests) <= 1:
        for request in requests:
            say(f"reading {request.model}")
            yield _verdict(request.judge(), configuration, fail_level)
        return
    with ProcessPoolExecutor(min(jobs, len(requests), os.cpu_count() or 1)) as pool:
        for k, judgement in enumerate(pool.map(Request.judge, requests), 1):
            say(f"{k} of {len(requests)}: {judgement.file}")
            yield _verdict(judgement, configuration, fail_level)


def _verdict(j: Judgement, configuration: Configuration, fail_level: Severity) -> Verdict:
    found = configuration.sort(j.findings, j.file, engines=bool(j.engines))
    return Verdict(j, found, fail_level)


@dataclass(frozen=True, eq=False)
class PairVerdict:
    """Whether two models agree.

    file : of the second
    comparison : None where their arms cannot be compared
    findings : as the configuration sorts them
    """

    label: str
    file: str
    comparison: PairValidation | None
    findings: Sorted

    @property
    def passed(self) -> bool:
        """Whether nothing is open and every difference is explained."""
        explained = self.comparison is None or self.comparison.explained
        return explained and not self.findings.open


@dataclass(frozen=True, eq=False)
class VerdictSet:
    """What one call judged.

    pairs : of two models; of each model and the `reference`, where there is one
    against_baseline : whether findings were compared with a baseline
    """

    models: tuple[Verdict, ...]
    pairs: tuple[PairVerdict, ...] = ()
    reference: Verdict | None = None
    against_baseline: bool = False

    @property
    def passed(self) -> bool:
        """Whether every model passes, and every pair agrees or is accepted."""
        return all(v.passed for v in self.models) and all(pair.passed for pair in self.pairs)

    @property
    def read(self) -> tuple[Judgement, ...]:
        """Of every model that was read, the reference last."""
        last = () if self.reference is None else (self.reference,)
        return tuple(v.judgement for v in (*self.models, *last))


def compare_verdicts(
    models: Sequence[Verdict],
    reference: Verdict | None,
    configuration: Configuration,
    *,
    pair: bool = True,
    progress: Callable[[str], None] | None = None,
) -> VerdictSet:
    """Each model compared with the reference; without one, two models with each other.

    pair : whether two models are meant to be compared
    Samples and seed are those of the judgements.
    """
    if reference is not None:
        others = [(reference, v) for v in models if v.judgement.file != reference.judgement.file]
    else:
        others = [(models[0], models[1])] if pair and len(models) == 2 else []
    pairs = []
    for a, b in others:
        if progress is not None:
            progress(f"comparing {a.judgement.model} with {b.judgement.model}")
        pairs.append(_pair(a.judgement, b.judgement, configuration))
    return VerdictSet(tuple(models), tuple(pairs), reference)


def _pair(a: Judgement, b: Judgement, configuration: Configuration) -> PairVerdict:
    """Whether two models need the same torques."""
    from .._engines.adapters.pinocchio import PinocchioEngine

    if a.arm is None or b.arm is None:
        label = f"{a.file} and {b.file}"
        missing = a if a.arm is None else b
        found = finding_of("CMP002", label, f"{missing.file} has no arm: {missing.arm_note}")
        return PairVerdict(label, b.file, None, configuration.sort([found], label, pair=True))
    arm_a, arm_b = labelled([a.arm, b.arm])
    label = f"{arm_a.label} and {arm_b.label}"
    try:
        pair = validate_pair(arm_a, arm_b, PinocchioEngine(arm_b), b.samples, b.seed)
    except (InputError, EngineError) as error:
        found = finding_of("CMP002", label, str(error))
        return PairVerdict(label, b.file, None, configuration.sort([found], label, pair=True))
    if pair.difference.agrees:
        return PairVerdict(label, b.file, pair, configuration.sort([], label, pair=True))
    fix = f"ur5check diff {a.model} {b.model} says which numbers differ"
    found = _difference(pair.difference, label, b.samples, fix)
    return PairVerdict(label, b.file, pair, configuration.sort([found], label, pair=True))


def _difference(d: Difference, label: str, samples: int, fix: str) -> Finding:
    """What differs: the torques, or the other numbers where the torques agree."""
    if d.same_torques:
        moving = [other for other in d.others if other.moves_joints]
        names = ", ".join(dict.fromkeys(other.quantity for other in moving))
        places = [p for other in moving for p in (other.place_a, other.place_b) if str(p)]
        message = f"the same torques, but other numbers differ: {names}"
        return finding_of("CMP003", label, message, *places, fix=fix)
    joint = int(d.torques.maximum.argmax())
    largest = float(d.torques.maximum[joint])
    return finding_of(
        "CMP001",
        label,
        f"torques differ by up to {largest:.4g} N m at joint {joint + 1} over {samples:,} random "
        f"states (RMS {float(d.torques.rms[joint]):.4g} N m)",
        value=largest,
        bound=float(d.tolerance[joint]),
        unit="N m",
        effect=largest,
        fix=fix,
    )
