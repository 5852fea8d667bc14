"""Compare a model with a recording of the robot, joint by joint: measured and
predicted torque, friction and rotor inertia of each drive, and what would
explain the rest: a drive's gain, a payload, tilted gravity, a joint's zero or
sign.

Exit code 0: the model explains the recording as well as the best parameters of
its geometry would.  1: it does not, or the recording cannot say.
"""

from __future__ import annotations

import argparse
import shlex
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import UsageError
from .options import (
    MODELS,
    ModelOptions,
    add_model_options,
    command_line,
    progress,
)
from .output import check_output
from .report_output import add_report_options, check_reports, write_reports

if TYPE_CHECKING:
    from .._logs.options import RecordingOptions
    from .._reports.document import Document
    from .._reports.report_formats import Target

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check log run.db3 --model ur10.urdf
  ur5check log run.csv --model my_arm.urdf --columns t,q,qd,tau
  ur5check log loaded.csv --unloaded empty.csv --model my_arm.urdf
  ur5check log run.csv --model my_arm.urdf --repair corrected.urdf
  ur5check log position.csv velocity.csv effort.csv --model my_arm.urdf
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Arguments of `log`."""
    parser.add_argument(
        "recording",
        nargs="+",
        metavar="RECORDING",
        help="a ROS bag (.db3, .mcap, .bag) or tables (.csv, .parquet) of the same rows",
    )
    parser.add_argument(
        "--model",
        required=True,
        action="append",
        metavar="MODEL",
        help="the model to compare; repeated: others, compared with the first",
    )
    what = parser.add_argument_group("what the recording does not say")
    what.add_argument(
        "--columns",
        default="",
        metavar="LIST",
        help="without header: blocks in order, t,q,qd,tau ('-': leave out); with header: "
        "'q=actual_q_{i} tau=effort_{i}'",
    )
    what.add_argument("--topic", default="", help="topic of a bag with several of joint states")
    what.add_argument("--rate", type=float, metavar="HZ", help="samples a second, without a clock")
    what.add_argument("--degrees", action="store_true", help="angles are in degrees")
    what.add_argument(
        "--gains",
        default="",
        metavar="LIST",
        help="N m for each unit of torque or current, one a joint or one for all; negative turns "
        "the sign",
    )
    what.add_argument(
        "--match-order",
        action="store_true",
        help="take the joints in the model's order, whatever their names",
    )
    what.add_argument(
        "--recording-config", metavar="FILE", help="TOML file with these (docs/recordings.md)"
    )
    how = parser.add_argument_group("analysis")
    how.add_argument(
        "--cutoff", type=float, metavar="HZ", help="of the low-pass (default: from the motion)"
    )
    how.add_argument("--stribeck", action="store_true", help="friction has an excess at low speed")
    how.add_argument(
        "--asymmetric", action="store_true", help="friction differs between the directions"
    )
    more = parser.add_argument_group("other recordings of the robot")
    more.add_argument(
        "--unloaded", metavar="FILE", help="the same robot without its load: says what it carried"
    )
    more.add_argument("--validate", metavar="FILE", help="a recording to try the fit on")
    parser.add_argument(
        "--repair", metavar="FILE", help="write the model corrected by this recording, as URDF"
    )
    parser.add_argument("--full", action="store_true", help="print all tables")
    add_model_options(parser, ("",))
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """Read, compare, report; the exit code says whether the model explains the recording."""
    models = ModelOptions.of(args, tuple(args.model))
    reading = _reading(args)
    names = [*args.recording, *(name for name in (args.unloaded, args.validate) if name)]
    files = [Path(name) for name in names]
    _check_outputs(args, files)
    arm, *others = models.load(quiet=args.quiet)
    _check_outputs(args, [*models.files([arm, *others]), *files])

    from .._logs.comparison import compare_recording
    from .._logs.friction import FrictionModel
    from .._reports.log_document import log_document
    from .._reports.log_json import log_json
    from .._reports.log_text import log_text
    from .._reports.report_formats import Contents
    from .._reports.terminal import render_text

    progress(args.quiet, f"reading {', '.join(args.recording)}")
    found = compare_recording(
        arm,
        args.recording,
        options=reading,
        cutoff=args.cutoff,
        friction=FrictionModel(args.stribeck, args.asymmetric),
        unloaded=args.unloaded,
        validate=args.validate,
        others=others,
    )
    if args.repair is not None:
        from .corrected_model import write_corrected

        write_corrected(found, args.repair, lambda line: progress(False, line))
    command = _command(args)

    def document(target: Target) -> Document:
        return log_document(found, command=command)

    def text(target: Target) -> str:
        if not args.full and target.file is None:
            return log_text(found)
        return render_text(document(target), width=target.width, colour=target.colour)

    write_reports(args, Contents(document, lambda: log_json(found, command=command), text))
    return 0 if found.passed else 1


def _check_outputs(args: argparse.Namespace, inputs: list[Path]) -> None:
    check_reports(args, inputs)
    if args.repair is not None:
        if Path(args.repair).suffix.lower() != ".urdf":
            raise UsageError(f"--repair {args.repair}: a URDF is written; end its name in .urdf")
        check_output(args.repair, inputs, option="--repair")


def _reading(args: argparse.Namespace) -> RecordingOptions:
    """Raises UsageError for an option that is given twice."""
    from dataclasses import replace

    from .._logs.options import RecordingOptions, options_from_toml

    options = RecordingOptions()
    if args.recording_config is not None:
        options = options_from_toml(Path(args.recording_config))
    given = {
        "columns": args.columns,
        "topic": args.topic,
        "rate": args.rate,
        "degrees": args.degrees,
        "gains": _numbers(args.gains),
        "by_order": args.match_order,
    }
    return replace(options, **{key: value for key, value in given.items() if value})


def _numbers(text: str) -> tuple[float, ...]:
    try:
        return tuple(float(number) for number in text.split(",")) if text else ()
    except ValueError:
        raise UsageError(f"--gains {text}: give numbers with commas between them") from None


def _command(args: argparse.Namespace) -> str:
    words = ["ur5check log", *map(shlex.quote, args.recording)]
    words += [word for model in args.model for word in ("--model", shlex.quote(model))]
    words.append(command_line("", args, ()).removeprefix("ur5check ''").strip())
    for option in ("columns", "topic", "rate", "gains", "recording_config", "cutoff", "unloaded",
                   "validate"):  # fmt: skip
        value = getattr(args, option)
        if value:
            words += [f"--{option.replace('_', '-')}", shlex.quote(str(value))]
    words += [
        f"--{flag.replace('_', '-')}"
        for flag in ("degrees", "match_order", "stribeck", "asymmetric")
        if getattr(args, flag)
    ]
    return " ".join(word for word in words if word)
