"""Judge models: what is wrong in their files, in bodies, joints and shapes, worst first, each with
its place and what to do.  Then check the computation of each arm against Pinocchio.

Two models are also compared.  Many files, or folders, give a table; each is compared with a model
that --against names.  Without a model the paper's tables and its appendix URDF are judged;
models/ur5check.toml accepts their known difference.

Exit code 0 if all pass and agree, 1 if there is a finding at or above --fail-level or a difference
that is not accepted, 2 for wrong usage.
"""

from __future__ import annotations

import argparse
import os
import shlex
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import UsageError
from .._reports.report_formats import Contents
from .options import (
    MODELS,
    add_model_options,
    add_state_options,
    chain_options,
    command_line,
    name_value_pairs,
    progress,
)
from .output import check_output, emit
from .report_output import add_report_options, check_reports, write_reports

if TYPE_CHECKING:
    from .._reports.document import Document
    from .._reports.report_formats import Target
    from .._validation.baseline import Baseline
    from .._validation.configuration import Configuration
    from .._validation.validation import Validation
    from .._validation.verdict import Request, VerdictSet

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check validate my_arm.urdf
  ur5check validate my_arm.urdf.xacro --arg prefix:=left_ --expect-mass 18.4
  ur5check validate old.urdf new.urdf --full -o report.md
  ur5check validate descriptions/ --format json -o findings.json
  ur5check validate build/*.urdf --against vendor.urdf
"""

#: States at which the computation is checked: of one or two models, and of each of many.
_SAMPLES, _SAMPLES_OF_MANY = 1_000, 100


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `validate` takes."""
    parser.add_argument(
        "models",
        nargs="*",
        metavar="MODEL",
        help="models, folders or patterns (default: paper appendix)",
    )
    parser.add_argument("--full", action="store_true", help="show all findings and all tables")
    parser.add_argument(
        "--against", metavar="MODEL", help="compare each model's torques with this one's"
    )
    parser.add_argument(
        "--each", action="store_true", help="judge each by itself: do not compare two models"
    )
    parser.add_argument(
        "--fail-level",
        choices=("error", "warning", "note"),
        help="least severity that fails a model (default: error, or the configuration's)",
    )
    parser.add_argument(
        "--config", metavar="FILE", help="accepted findings (default: nearest ur5check.toml)"
    )
    parser.add_argument(
        "--baseline", metavar="FILE", help="findings that are known; only others count"
    )
    parser.add_argument(
        "--update-baseline",
        action="store_true",
        help="write today's findings to the file of --baseline",
    )
    parser.add_argument(
        "--expect-mass", type=float, metavar="KG", help="mass of the whole robot, to 5 %%"
    )
    parser.add_argument(
        "--payload", type=float, default=0.0, metavar="KG", help="held at the tip (default 0)"
    )
    parser.add_argument(
        "--hold",
        action="append",
        default=[],
        metavar="JOINT=VALUE",
        help="position of a joint beside the arm [rad] or [m] (default 0); repeatable",
    )
    parser.add_argument(
        "--engines",
        metavar="ENGINES",
        help="audit what these import, as a,b,c or all (default: the configuration's)",
    )
    parser.add_argument("--no-meshes", action="store_true", help="do not read mesh files")
    parser.add_argument(
        "--jobs", type=int, metavar="N", help="processes for many files (default: one a core)"
    )
    add_state_options(parser, many=True)
    add_model_options(parser, ("", "a", "b"))
    add_report_options(parser, findings=True)


def run(args: argparse.Namespace) -> int:
    """Judge, report, and say whether all passed."""
    from .._validation.configuration import find_configuration, read_configuration
    from .._validation.verdict import compare_verdicts, files_under, verdicts
    from .input_files import input_files

    paper = not args.models
    models = ["paper", "appendix"] if paper else files_under(args.models)
    if not models:
        raise UsageError(
            f"{', '.join(args.models)}: no file is there, no .urdf or .urdf.xacro in a folder"
        )
    if args.config is not None:
        configuration = read_configuration(Path(args.config))
    elif paper:
        configuration = _papers_configuration()
    else:
        configuration = find_configuration(_folder_of(models[0]))
    if args.against is None and not paper:
        args.against = configuration.against
    named = [*models, *([] if args.against is None else [args.against])]
    packages = name_value_pairs(args.package, "--package", "=")
    check_reports(args, [file for m in named for file in input_files(m, (), packages)])
    baseline = _baseline(args)
    if args.samples is None:
        args.samples = _SAMPLES if len(models) <= 2 else _SAMPLES_OF_MANY
    if args.engines is None:
        args.engines = ",".join(configuration.engines)
    if args.fail_level is None:
        args.fail_level = configuration.fail_level
    requests = [request.with_settings(configuration) for request in _requests(args, models)]
    jobs = (os.cpu_count() or 1) if args.jobs is None else args.jobs
    if jobs < 1:
        raise UsageError(f"--jobs {jobs}: give one or more")

    def say(line: str) -> None:
        progress(args.quiet, line)

    jobs = jobs if len(requests) > 2 else 1
    results = list(verdicts(requests, configuration, args.fail_level, jobs=jobs, progress=say))
    reference = None
    if args.against is not None:
        asked = replace(_requests(args, models)[0], model=args.against, hold=())
        asked = replace(asked, base=None, tip=None, arm=None).with_settings(configuration)
        (reference,) = verdicts([asked], configuration, args.fail_level, progress=say)
    verdict_set = compare_verdicts(
        results, reference, configuration, pair=paper or _two_named(args), progress=say
    )
    read = [(j.model, j.robot) for j in verdict_set.read]
    check_reports(
        args,
        [file for m, x in read if x is not None for file in input_files(m, x.inputs, packages)],
    )
    if baseline is not None:
        verdict_set = _against_baseline(args, verdict_set, baseline)
    write_reports(args, _contents(args, verdict_set, configuration))
    return 0 if verdict_set.passed else 1


def _baseline(args: argparse.Namespace) -> Baseline | None:
    """What --baseline holds.  Raises UsageError for a file that is none, or cannot be written."""
    from .._validation.baseline import Baseline, read_baseline

    if args.baseline is None:
        if args.update_baseline:
            raise UsageError("--update-baseline needs the file: --baseline FILE")
        return None
    file = Path(args.baseline)
    if not args.update_baseline:
        return read_baseline(file)
    check_output(args.baseline, (), option="--baseline")
    return read_baseline(file) if file.exists() else Baseline(file.resolve().parent)


def _against_baseline(
    args: argparse.Namespace, verdicts: VerdictSet, baseline: Baseline
) -> VerdictSet:
    from .._validation.baseline import baseline_of, with_baseline

    if args.update_baseline:
        baseline = baseline_of(verdicts, baseline)
        emit(baseline.text(), args.baseline, option="--baseline")
        progress(args.quiet, f"{args.baseline} holds {len(baseline.entries)} findings")
    elif gone := baseline.gone(verdicts):
        count = f"{len(gone)} of its findings no longer occur"
        progress(args.quiet, f"{args.baseline}: {count}; --update-baseline takes them out")
    return with_baseline(verdicts, baseline)


def _two_named(args: argparse.Namespace) -> bool:
    """Whether two models are compared: two files that are named, not two found in a folder."""
    return (
        not args.each
        and len(args.models) == 2
        and not any(Path(name).is_dir() for name in args.models)
    )


def _requests(args: argparse.Namespace, models: list[str]) -> list[Request]:
    from .._arguments import integer
    from .._validation.verdict import Request

    integer("samples", args.samples, least=1)
    integer("seed", args.seed, least=0)
    chains = chain_options(args, len(models))
    hold = {}
    for name, value in name_value_pairs(args.hold, "--hold", "=").items():
        try:
            hold[name] = float(value)
        except ValueError:
            raise UsageError(f"--hold {name}={value}: give a number") from None
    packages = tuple(name_value_pairs(args.package, "--package", "=").items())
    arguments = tuple(name_value_pairs(args.arg, "--arg", ":=").items())
    return [
        Request(
            model,
            chain["base"],
            chain["tip"],
            chain["arm"],
            tuple(hold.items()),
            packages,
            arguments,
            args.samples,
            args.seed,
            args.payload,
            args.expect_mass,
            not args.no_meshes,
            tuple(name.strip() for name in args.engines.split(",") if name.strip()),
        )
        for model, chain in zip(models, chains, strict=True)
    ]


def _command(args: argparse.Namespace) -> str:
    """The command of this report; the file of --config as it was given."""
    words = [command_line("validate", args, tuple(args.models)), "--fail-level", args.fail_level]
    if args.against is not None:
        words += ["--against", shlex.quote(args.against)]
    if args.config is not None:
        words += ["--config", shlex.quote(args.config)]
    if args.baseline is not None:
        words += ["--baseline", shlex.quote(args.baseline)]
    if args.expect_mass is not None:
        words += ["--expect-mass", repr(args.expect_mass)]
    words += ["--payload", repr(args.payload)]
    words += ["--engines", args.engines] if args.engines else []
    words += [f"--hold {shlex.quote(held)}" for held in args.hold]
    words += ["--each"] * args.each
    return " ".join(words + ["--no-meshes"] * args.no_meshes)


def _folder_of(model: str) -> Path:
    file = Path(model)
    return file.parent if file.exists() else Path.cwd()


def _papers_configuration() -> Configuration:
    from .._io.ros_packages import models_directory
    from .._validation.configuration import read_configuration

    return read_configuration(models_directory() / "ur5check.toml", "models/ur5check.toml")


def _contents(
    args: argparse.Namespace, verdicts: VerdictSet, configuration: Configuration
) -> Contents:
    """What the reports are rendered from: text is a screen, and with --full or in a file all."""
    from .._reports.terminal import render_text
    from .._reports.validate_json import validate_json
    from .._reports.verdict_document import verdict_document
    from .._reports.verdict_text import verdicts_text

    laws, command = _laws(args, verdicts), _command(args)

    def document(target: Target) -> Document:
        return verdict_document(verdicts, laws, configuration, command=command)

    def text(target: Target) -> str:
        if not args.full and target.file is None:
            return verdicts_text(verdicts)
        tables = render_text(document(target), width=target.width, colour=target.colour)
        return f"{verdicts_text(verdicts, full=True)}\n{tables}"

    return Contents(
        document=document,
        report=lambda: validate_json(
            laws, verdicts=verdicts, configuration=configuration, command=command
        ),
        text=text,
        verdicts=verdicts,
        configuration=configuration,
        command=command,
    )


def _laws(args: argparse.Namespace, verdicts: VerdictSet) -> Validation:
    """The laws of every arm that was computed, as one result."""
    from .._validation.validation import Validation

    checked = tuple(v.judgement.laws for v in verdicts.models if v.judgement.laws is not None)
    pairs = tuple(pair.comparison for pair in verdicts.pairs if pair.comparison is not None)
    return Validation(checked, pairs, verdicts.models[0].judgement.samples, args.seed)
