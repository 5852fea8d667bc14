"""Compare two models of an arm: the largest torque difference, the parameters it is
attributed to, the known mistakes that explain it, and the configuration within
the joint limits where it is largest.

Exit code 0: no torque differs by more than the tolerance, and damping, friction,
limits, motors and gravity are the same. 1: something differs.
"""

from __future__ import annotations

import argparse
import shlex
from collections.abc import Iterable
from pathlib import Path

from .._errors import UsageError
from .._reports.report_formats import Contents
from .options import (
    MODELS,
    ModelOptions,
    add_gravity_option,
    add_model_options,
    add_state_options,
    command_line,
    progress,
)
from .output import check_output
from .report_output import add_report_options, check_reports, is_report, write_reports

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check diff paper appendix
  ur5check diff vendor.urdf mine.urdf --tip-a tool0 --tip-b tool0 -o diff.md
  ur5check diff vendor.urdf mine.urdf --repair repaired.urdf
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `diff` takes."""
    parser.add_argument("a", metavar="A", help="the reference model")
    parser.add_argument("b", metavar="B", help="the model that is compared with it")
    parser.add_argument(
        "--quick",
        action="store_true",
        help="differences and attribution only; no diagnosis of mistakes",
    )
    parser.add_argument(
        "--repair", metavar="FILE", help="write B with its diagnosed mistakes repaired, as URDF"
    )
    parser.add_argument(
        "--by-parameter",
        action="store_true",
        help="attribute torques to each of a link's ten parameters",
    )
    parser.add_argument(
        "--acceleration",
        type=float,
        metavar="A",
        help="largest acceleration in the search for the worst state [rad/s²] (default: 10)",
    )
    parser.add_argument(
        "--tolerance",
        metavar="T",
        help="torque difference that counts as agreement: [N m], or 2%% of the effort limits "
        "(default: a millionth of the largest torque)",
    )
    parser.add_argument(
        "--uncertainty",
        metavar="FILE",
        help="standard deviations of the models' numbers: mass=1%%,centre=3%%,tensor=10%%, or a "
        ".toml file",
    )
    add_state_options(parser)
    add_gravity_option(parser)
    add_model_options(parser, ("a", "b"))
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """Compare, explain, report, and say whether they agree."""
    models = (args.a, args.b)
    options = ModelOptions.of(args, models)
    _check_options(args)
    _check_outputs(args, ())
    arms = options.load(quiet=args.quiet)
    _check_outputs(args, options.files(arms))

    from .._comparison.attribution_detail import by_parameter
    from .._comparison.difference import diff
    from .._comparison.explanation import explain
    from .._reports.diff_document import diff_document
    from .._reports.diff_json import diff_json
    from .._robot.states import MAX_ACCELERATION

    def say(line: str) -> None:
        progress(args.quiet, line)

    say(f"comparing them at {args.samples:,} states")
    d = diff(
        *arms,
        samples=args.samples,
        seed=args.seed,
        gravity=args.gravity,
        tolerance=args.tolerance,
        uncertainty=args.uncertainty,
    )
    explanation = None
    if d.gravity_only:
        say("tensors are unknown: only gravity torques are compared, and not explained")
    elif not args.quick:
        if args.acceleration is None:
            args.acceleration = MAX_ACCELERATION
        explanation = explain(d, acceleration=args.acceleration, progress=say)
    parameters = by_parameter(d.pair, d.states) if args.by_parameter else None
    command = command_line("diff", args, models)
    if args.tolerance is not None:
        command += f" --tolerance {shlex.quote(args.tolerance)}"
    contents = Contents(
        document=lambda target: diff_document(
            d,
            explanation,
            parameters=parameters,
            written_out=args.by_parameter or target.form.all_tables,
            command=command,
        ),
        report=lambda: diff_json(d, explanation, parameters=parameters, command=command),
    )
    if args.repair is not None and explanation is not None:
        from .repaired_model import repair

        repair(explanation, args.repair, say)
    write_reports(args, contents)
    return 0 if d.agrees else 1


def _check_options(args: argparse.Namespace) -> None:
    """Raises UsageError for options that have no meaning together."""
    for option in ("repair", "acceleration"):
        if args.quick and getattr(args, option) is not None:
            raise UsageError(f"--{option} needs the explanation that --quick leaves out; drop one")
    if args.repair is None:
        return
    if Path(args.repair).suffix.lower() != ".urdf":
        raise UsageError(f"--repair {args.repair}: a URDF is written there; end its name in .urdf")
    if is_report(args, args.repair):
        raise UsageError(f"--repair {args.repair}: the report goes there (-o); name another file")


def _check_outputs(args: argparse.Namespace, inputs: Iterable[Path]) -> None:
    inputs = tuple(inputs)
    check_reports(args, inputs)
    check_output(args.repair, inputs, option="--repair")
