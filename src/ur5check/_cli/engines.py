"""Compare physics engines on one model: which parameters each engine imports from
the file, how far apart their torques are, and how to repair the file for an
engine that misreads it.  A file with several chains is compared whole, on a
fixed base.  Without a model: list the engines.

Exit code 0: all torques agree within --tolerance, with files repaired for known
issues unless --as-read is given.  1: they do not, or an engine refuses the
model.
"""

from __future__ import annotations

import argparse
import math

from .._errors import UsageError
from .._reports.report_formats import Contents
from .options import (
    MODELS,
    ModelOptions,
    add_model_options,
    command_line,
    count,
    progress,
)
from .report_output import add_report_options, check_reports, write_reports

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check engines my.urdf.xacro --with mujoco,drake --as-read --tolerance 1e-6
  ur5check engines humanoid.urdf --with pinocchio,mujoco
  ur5check engines --fleet -o fleet.md
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `engines`."""
    parser.add_argument(
        "model",
        metavar="MODEL",
        nargs="?",
        help="model that every engine imports; none: list the engines",
    )
    parser.add_argument(
        "--whole",
        action="store_true",
        help="compare the whole robot, also of a file with one arm (default: its arm)",
    )
    parser.add_argument("--list", action="store_true", help="list the engines, with versions")
    parser.add_argument(
        "--fleet", action="store_true", help="compare on every serial arm of example-robot-data"
    )
    parser.add_argument(
        "--with",
        dest="engines",
        metavar="ENGINES",
        help="engines to compare, as a,b,c (default: all that are installed)",
    )
    parser.add_argument(
        "--tolerance",
        type=float,
        metavar="N_M",
        help="largest torque difference that counts as agreement [N m] (default: 1e-10)",
    )
    parser.add_argument(
        "--as-read",
        action="store_true",
        help="judge the files as read, without repairs for known issues",
    )
    parser.add_argument(
        "--samples",
        type=count,
        metavar="N",
        help="number of random states (default: 200; 20 with --fleet)",
    )
    parser.add_argument(
        "--seed", type=int, default=0, metavar="N", help="seed of the states (default 0)"
    )
    parser.add_argument(
        "--gravity",
        type=float,
        nargs=3,
        metavar=("X", "Y", "Z"),
        help="gravity in the base frame, for all engines [m/s²] (default: the model's)",
    )
    add_model_options(parser, ("",))
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """List the engines, or compare them on one arm or on all arms of example-robot-data."""
    _check(args)
    if args.fleet:
        return _fleet(args)
    return _list(args) if args.list or args.model is None else _model(args)


def _list(args: argparse.Namespace) -> int:
    from .._reports.engines_list_document import engines_list_document
    from .._reports.engines_list_json import engines_list_json

    check_reports(args)
    contents = Contents(
        document=lambda target: engines_list_document(command="ur5check engines --list"),
        report=lambda: engines_list_json(command="ur5check engines --list"),
    )
    write_reports(args, contents)
    return 0


def _model(args: argparse.Namespace) -> int:
    options = ModelOptions.of(args, (args.model,))
    check_reports(args)
    arm = options.load_arm_or_tree(whole=args.whole, quiet=args.quiet)
    check_reports(args, options.files([arm]))

    from .._engines.audit.engine_comparison import SAME_ROBOT, SAMPLES, compare_engines
    from .._reports.engines_document import engines_document
    from .._reports.engines_json import engines_json

    args.samples = SAMPLES if args.samples is None else args.samples
    args.tolerance = SAME_ROBOT if args.tolerance is None else args.tolerance
    report = compare_engines(
        arm,
        engines=_engines(args),
        samples=args.samples,
        seed=args.seed,
        gravity=args.gravity,
        progress=lambda line: progress(args.quiet, line),
    )
    shown = {
        "model": args.model,
        "limit": args.tolerance,
        "as_read": args.as_read,
        "command": _command(args, (args.model,)),
    }
    contents = Contents(
        document=lambda target: engines_document(report, **shown),
        report=lambda: engines_json(report, **shown),
    )
    write_reports(args, contents)
    stage = report.as_read if args.as_read else report.final
    return 0 if stage.agrees(args.tolerance) else 1


def _fleet(args: argparse.Namespace) -> int:
    check_reports(args)

    from .._engines.audit.engine_comparison import SAME_ROBOT
    from .._engines.audit.fleet_comparison import FLEET_SAMPLES, compare_fleet
    from .._reports.engines_fleet_document import engines_fleet_document
    from .._reports.engines_fleet_json import engines_fleet_json

    args.samples = FLEET_SAMPLES if args.samples is None else args.samples
    args.tolerance = SAME_ROBOT if args.tolerance is None else args.tolerance
    fleet = compare_fleet(
        engines=_engines(args),
        samples=args.samples,
        seed=args.seed,
        repairs=not args.as_read,
        progress=lambda line: progress(args.quiet, line),
    )
    shown = {
        "limit": args.tolerance,
        "as_read": args.as_read,
        "command": _command(args, ()),
    }
    contents = Contents(
        document=lambda target: engines_fleet_document(fleet, **shown),
        report=lambda: engines_fleet_json(fleet, **shown),
    )
    write_reports(args, contents)
    return 0 if fleet.agrees(args.tolerance, as_read=args.as_read) else 1


def _engines(args: argparse.Namespace) -> list[str] | None:
    return None if args.engines is None else [key.strip() for key in args.engines.split(",")]


def _command(args: argparse.Namespace, models: tuple[str, ...]) -> str:
    words = [command_line("engines", args, models)]
    words += ["--fleet"] if args.fleet else []
    words += [f"--with {','.join(_engines(args) or ())}"] if args.engines is not None else []
    words += ["--tolerance", repr(args.tolerance)]
    words += ["--as-read"] if args.as_read else []
    words += ["--whole"] if args.whole else []
    return " ".join(words)


def _check(args: argparse.Namespace) -> None:
    """Raises UsageError for options that exclude each other, and for an invalid tolerance."""
    if args.model is not None and (args.fleet or args.list):
        option = "--fleet" if args.fleet else "--list"
        raise UsageError(f"{option} takes no model; leave {args.model} out")
    if args.fleet and args.list:
        raise UsageError("--list and --fleet do not go together; drop one")
    if args.whole and (args.base is not None or args.tip is not None):
        raise UsageError("--base and --tip choose an arm; leave them out, or --whole")
    given = {
        "--gravity": args.gravity, "--base": args.base, "--tip": args.tip,
        "--arg": args.arg, "--package": args.package, "--whole": args.whole,
    }  # fmt: skip
    if args.model is None:
        if not args.fleet:
            given |= {
                "--with": args.engines, "--tolerance": args.tolerance,
                "--as-read": args.as_read, "--samples": args.samples,
            }  # fmt: skip
        for option, value in given.items():
            if value is not None and value is not False and value != []:
                raise UsageError(f"{option} needs a model: ur5check engines MODEL {option} …")
    limit = args.tolerance
    if limit is not None and not (math.isfinite(limit) and limit >= 0.0):
        raise UsageError(f"--tolerance {limit}: give a torque of zero or more [N m]")
