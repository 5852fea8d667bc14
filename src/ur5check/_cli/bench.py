"""How fast this machine computes torques, and next to whom: Pinocchio, MuJoCo, Drake and JAX at the
same states in the same minutes.

Also matrices, longer arms, one state and many, the limit that memory sets, what a kernel's first
call costs, start-up, and where `validate` and `diff` spend their time.  Takes some minutes.

Exit code 0 whatever comes of it: a slow machine is no fault.
"""

from __future__ import annotations

import argparse
import shlex

from .options import (
    MODELS,
    ModelOptions,
    add_model_options,
    add_output_options,
    command_line,
    progress,
)
from .output import check_output, emit, format_of, rendered

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check bench -o speed.md
  ur5check bench robot.urdf --only torques memory --threads 8
"""

#: States that are asked for in one call, at most.
_UP_TO, _LARGE = 10**6, 10**7


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `bench` takes."""
    parser.add_argument(
        "model", metavar="MODEL", nargs="?", default="appendix", help="whose (default: appendix)"
    )
    parser.add_argument(
        "--only",
        nargs="+",
        default=[],
        metavar="WHAT",
        help="torques, memory, matrices, states, joints, first-use, start-up, operations, commands "
        "(default: all)",
    )
    parser.add_argument(
        "--states", type=int, default=10**6, metavar="N", help="for torques (default: 1000000)"
    )
    parser.add_argument(
        "--rounds", type=int, default=5, metavar="N", help="whose median is taken (default: 5)"
    )
    parser.add_argument(
        "--threads", type=int, default=2, metavar="N", help="beside one (default: 2)"
    )
    parser.add_argument(
        "--lengths",
        type=int,
        nargs="+",
        default=[6, 12, 24, 48],
        metavar="N",
        help="joints of longer arms (default: 6 12 24 48)",
    )
    parser.add_argument(
        "--large", action="store_true", help="up to 1e7 states in one call (needs 8 GB)"
    )
    parser.add_argument(
        "--seed", type=int, default=0, metavar="N", help="of states and longer arms (default: 0)"
    )
    add_model_options(parser, ("",))
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Measure and report."""
    options = ModelOptions.of(args, (args.model,))
    check_output(args.output, ())
    (arm,) = options.load(quiet=args.quiet)
    check_output(args.output, options.files([arm]))

    from .._benchmarking.benchmark import bench
    from .._reports.benchmark_document import benchmark_document
    from .._reports.benchmark_json import benchmark_json

    found = bench(
        arm,
        only=args.only,
        states=args.states,
        rounds=args.rounds,
        threads=args.threads,
        lengths=args.lengths,
        up_to=_LARGE if args.large else min(_UP_TO, args.states),
        seed=args.seed,
        progress=lambda line: progress(args.quiet, line),
    )
    command = _command(args)
    text = rendered(
        format_of(args.format, args.output),
        args.output,
        document=lambda: benchmark_document(found, command=command),
        report=lambda: benchmark_json(found, command=command),
    )
    emit(text, args.output)
    return 0


def _command(args: argparse.Namespace) -> str:
    """The command that measures the same again."""
    words = [command_line("bench", args, (args.model,))]
    words += [f"--{name} {getattr(args, name)}" for name in ("states", "rounds", "threads")]
    words.append(f"--lengths {' '.join(map(str, args.lengths))}")
    if args.only:
        words.append(f"--only {shlex.join(args.only)}")
    if args.large:
        words.append("--large")
    return " ".join(words)
