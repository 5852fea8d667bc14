"""Hold two models against each other at millions of states, in memory that does not grow.

Per joint: RMS, maximum with its state, quantiles, histogram, share over a limit; and where in the
reach of the tool the difference is met.  The same digits for any number of threads, batches and
machines, in one go or resumed.

Exit code 0 if no torque differs by more than a millionth of the largest, 1 if one does.
"""

from __future__ import annotations

import argparse
import shlex
from pathlib import Path

from .._errors import UsageError
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
  ur5check sweep paper appendix --states 1e9 --threads 2 --checkpoint sweep.json -o sweep.md
  ur5check sweep good.urdf suspect.urdf --sample run.parquet --parquet found.parquet
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `sweep` takes."""
    parser.add_argument("a", metavar="A", help="a model")
    parser.add_argument("b", metavar="B", help="another, held against it")
    what = parser.add_argument_group("which states")
    what.add_argument(
        "--states", type=_count, metavar="N", help="how many (default: 1e6; of a log: all)"
    )
    what.add_argument(
        "--sample",
        default="random",
        metavar="HOW",
        help="random (default), sobol, grid (postures at rest), or a log FILE.csv, FILE.parquet",
    )
    what.add_argument(
        "--seed", type=int, default=0, metavar="N", help="seed that they are drawn from (default 0)"
    )
    what.add_argument(
        "--within-limits", action="store_true", help="keep to joint limits of position and speed"
    )
    what.add_argument(
        "--tolerance",
        type=float,
        nargs="+",
        metavar="NM",
        help="count states that differ by more; one torque, or one a joint [N m]",
    )
    what.add_argument(
        "--gravity",
        type=float,
        nargs=3,
        metavar=("X", "Y", "Z"),
        help="gravity in each base frame [m/s²] (default: what each model says)",
    )
    how = parser.add_argument_group("how (changes no digit)")
    how.add_argument("--threads", type=int, default=1, metavar="N", help="of this process")
    how.add_argument(
        "--batch", type=int, metavar="N", help="blocks of 16,384 states taken at a time"
    )
    how.add_argument("--scheduler", metavar="ADDRESS", help="a Dask scheduler, tcp://HOST:8786")
    how.add_argument("--checkpoint", metavar="FILE", help="keep there what is done; go on from it")
    how.add_argument(
        "--checkpoint-every", type=float, default=30.0, metavar="S", help="seconds (default: 30)"
    )
    parser.add_argument(
        "--parquet", metavar="FILE", help="write histograms there, the reach map beside it"
    )
    add_model_options(parser, ("a", "b"))
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Sweep, report, and say whether they agree."""
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
    text = rendered(
        format_of(args.format, args.output),
        args.output,
        document=lambda: sweep_document(found, command=command),
        report=lambda: sweep_json(found, command=command),
    )
    if args.parquet is not None:
        from .._reports.sweep_parquet import write_parquet

        write_parquet(found, Path(args.parquet))
    emit(text, args.output)
    return 0 if found.agrees else 1


def _count(text: str) -> int:
    """`1e8`, `100000000` or `100_000_000`."""
    try:
        value = float(text)
        if value == int(value):
            return int(text) if text.lstrip("+-").replace("_", "").isdecimal() else int(value)
    except (ValueError, OverflowError):
        pass
    raise argparse.ArgumentTypeError(f"{text!r} is no whole number; write 1e8 or 100000000")


def _command(args: argparse.Namespace, models: tuple[str, ...], count: int) -> str:
    """The command that makes this report again; what changes no digit is left out."""
    from .._sweep.state_log import is_log

    words = [command_line("sweep", args, models), "--sample", shlex.quote(args.sample)]
    if not is_log(args.sample):
        words += ["--states", str(count)]
    if args.within_limits:
        words.append("--within-limits")
    if args.tolerance is not None:
        words += ["--tolerance", *map(repr, args.tolerance)]
    return " ".join(words)


def _check_options(args: argparse.Namespace) -> None:
    """Raises UsageError for options that have no meaning together."""
    if args.scheduler is not None and args.threads != 1:
        raise UsageError("--threads has no meaning with --scheduler: its workers have their own")
    if args.checkpoint_every < 0.0:
        raise UsageError(f"--checkpoint-every {args.checkpoint_every}: must not be negative")
    if args.parquet is not None and Path(args.parquet).suffix != ".parquet":
        raise UsageError(f"--parquet {args.parquet}: end its name in .parquet")


def _check_outputs(args: argparse.Namespace, inputs: list[Path]) -> None:
    """Refuse, before any work is done, what could not or should not be written."""
    taken = [*inputs, Path(args.sample)]
    check_output(args.output, taken)
    check_output(args.checkpoint, taken, option="--checkpoint")
    if args.parquet is not None:
        from .._reports.sweep_parquet import map_file
        from .._sweep.parquet_log import import_parquet

        import_parquet()
        check_output(args.parquet, taken, option="--parquet")
        check_output(str(map_file(Path(args.parquet))), taken, option="--parquet")
    written = [args.output, args.checkpoint, args.parquet]
    files = [Path(name).resolve() for name in written if name is not None]
    if len(set(files)) < len(files):
        raise UsageError("-o, --checkpoint and --parquet name the same file; give each its own")
