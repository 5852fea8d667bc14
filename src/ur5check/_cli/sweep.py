"""Compare the torques of two models at millions of states, in bounded memory.

Per joint: RMS and maximum of the difference, its quantiles and histogram, the
share of states above a tolerance; and the positions of the tool where the
difference occurs.  The results do not depend on the number of threads, batches
or machines, nor on interruptions.

Exit code 0: no torque differs by more than a millionth of the largest torque.
1: one does.
"""

from __future__ import annotations

import argparse
import shlex
from pathlib import Path

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
from .output import check_output
from .report_output import add_report_options, check_reports, write_reports

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check sweep paper appendix --states 1e9 --checkpoint sweep.json
  ur5check sweep vendor.urdf mine.urdf --sample run.parquet -o sweep.md
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Arguments of `sweep`."""
    parser.add_argument("a", metavar="A", help="the reference model")
    parser.add_argument("b", metavar="B", help="the model that is compared with it")
    what = parser.add_argument_group("states")
    what.add_argument(
        "--states", type=count, metavar="N", help="number of states (default: 1e6; of a log: all)"
    )
    what.add_argument(
        "--sample",
        default="random",
        metavar="HOW",
        help="random (default), sobol, grid (positions at rest), or a log FILE.csv, FILE.parquet",
    )
    what.add_argument(
        "--seed",
        type=int,
        default=0,
        metavar="N",
        help="seed of random and sobol states (default: 0)",
    )
    what.add_argument(
        "--within-limits",
        action="store_true",
        help="draw positions and velocities within the joint limits",
    )
    what.add_argument(
        "--tolerance",
        type=float,
        nargs="+",
        metavar="NM",
        help="report the share of larger differences [N m]; one value, or one per joint",
    )
    what.add_argument(
        "--gravity",
        type=float,
        nargs=3,
        metavar=("X", "Y", "Z"),
        help="gravity in each base frame [m/s²] (default: each model's own)",
    )
    how = parser.add_argument_group("execution (changes no digit of the result)")
    how.add_argument(
        "--threads", type=int, default=1, metavar="N", help="threads of this process (default: 1)"
    )
    how.add_argument("--batch", type=int, metavar="N", help="blocks of 16,384 states per task")
    how.add_argument(
        "--scheduler", metavar="ADDRESS", help="address of a Dask scheduler, tcp://HOST:8786"
    )
    how.add_argument(
        "--checkpoint", metavar="FILE", help="save intermediate results; resume from the file"
    )
    how.add_argument(
        "--checkpoint-every",
        type=float,
        default=30.0,
        metavar="S",
        help="seconds between checkpoints (default: 30)",
    )
    parser.add_argument(
        "--parquet",
        metavar="FILE",
        help="write the histograms, and the reach map to FILE.map.parquet",
    )
    add_model_options(parser, ("a", "b"))
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """Sweep and report; the exit code says whether the models agree."""
    models = (args.a, args.b)
    options = ModelOptions.of(args, models)
    _check_options(args)
    arms = options.load(quiet=args.quiet)
    _check_outputs(args, options.files(arms))

    from .._reports.sweep_document import sweep_document
    from .._reports.sweep_json import sweep_json
    from .._sweep.sweep import sweep

    found = sweep(
        *arms,
        states=args.states,
        sample=args.sample,
        seed=args.seed,
        within_limits=args.within_limits,
        tolerance=args.tolerance,
        gravity=args.gravity,
        threads=args.threads,
        batch=args.batch,
        scheduler=args.scheduler,
        checkpoint=args.checkpoint,
        checkpoint_every=args.checkpoint_every,
        progress=lambda line: progress(args.quiet, line),
    )
    command = _command(args, models, found.count)
    contents = Contents(
        document=lambda target: sweep_document(found, command=command),
        report=lambda: sweep_json(found, command=command),
    )
    if args.parquet is not None:
        from .._reports.sweep_parquet import write_parquet

        write_parquet(found, Path(args.parquet))
    write_reports(args, contents)
    return 0 if found.agrees else 1


def _command(args: argparse.Namespace, models: tuple[str, ...], states: int) -> str:
    """The command of this report, without options that change no digit."""
    from .._sweep.state_log import is_log

    words = [command_line("sweep", args, models), "--sample", shlex.quote(args.sample)]
    if not is_log(args.sample):
        words += ["--states", str(states)]
    if args.within_limits:
        words.append("--within-limits")
    if args.tolerance is not None:
        words += ["--tolerance", *map(repr, args.tolerance)]
    return " ".join(words)


def _check_options(args: argparse.Namespace) -> None:
    """Raises UsageError for options that exclude each other."""
    if args.scheduler is not None and args.threads != 1:
        raise UsageError(
            "--threads does not apply with --scheduler; set the threads of its workers"
        )
    if args.checkpoint_every < 0.0:
        raise UsageError(f"--checkpoint-every {args.checkpoint_every}: must not be negative")
    if args.parquet is not None and Path(args.parquet).suffix != ".parquet":
        raise UsageError(f"--parquet {args.parquet}: the name must end in .parquet")


def _check_outputs(args: argparse.Namespace, inputs: list[Path]) -> None:
    """Raises UsageError, before any work, for outputs that cannot or must not be written."""
    taken = [*inputs, Path(args.sample)]
    check_reports(args, taken)
    check_output(args.checkpoint, taken, option="--checkpoint")
    if args.parquet is not None:
        from .._reports.sweep_parquet import map_file
        from .._sweep.parquet_log import import_parquet

        import_parquet()
        check_output(args.parquet, taken, option="--parquet")
        check_output(str(map_file(Path(args.parquet))), taken, option="--parquet")
    written = [*args.outputs, args.checkpoint, args.parquet]
    files = [Path(name).resolve() for name in written if name is not None]
    if len(set(files)) < len(files):
        raise UsageError(
            "-o, --checkpoint and --parquet name the same file; choose different files"
        )
