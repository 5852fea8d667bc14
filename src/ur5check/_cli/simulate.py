"""Test 9 of the paper: apply the torques that balance gravity in one model to another
model, the plant, and report whether the plant stays at rest.

Exit code 0: it stays at rest.  1: it moves.
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
    add_model_options,
    command_line,
    progress,
)
from .output import check_output, emit_files
from .report_output import add_report_options, check_reports, is_report, write_reports

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check simulate --plant appendix --torque paper-listing --engine mujoco
  ur5check simulate --torque paper --pose 0 0.9 -1 1 3.5 -1.9 --recompute
"""

_PICTURES = (".svg", ".png")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `simulate`."""
    parser.add_argument(
        "--plant",
        default="appendix",
        metavar="MODEL",
        help="the simulated arm, A (default: appendix)",
    )
    parser.add_argument(
        "--torque",
        default="appendix",
        metavar="MODEL",
        help="model that the gravity torques are computed from, B (default: appendix)",
    )
    parser.add_argument(
        "--pose",
        nargs="+",
        default=["case9"],
        metavar="Q",
        help="initial configuration, at rest: joint positions of the plant [rad, m], or case9 of "
        "the paper (default)",
    )
    parser.add_argument(
        "--engine",
        default="ur5check",
        metavar="ENGINE",
        help="engine that integrates the motion: ur5check (default), mujoco, dart",
    )
    parser.add_argument(
        "--seconds", type=float, default=5.0, metavar="T", help="duration [s] (default: 5)"
    )
    parser.add_argument(
        "--step",
        type=float,
        default=1e-3,
        metavar="S",
        help="time step of the engine [s] (default: 0.001)",
    )
    parser.add_argument(
        "--integrator", metavar="NAME", help="integrator of the engine (default: the engine's)"
    )
    torque = parser.add_mutually_exclusive_group()
    torque.add_argument(
        "--hold",
        action="store_true",
        help="keep the torques of the initial configuration, as the paper does (default)",
    )
    torque.add_argument(
        "--recompute",
        action="store_true",
        help="compute the torques anew at the configuration of each step",
    )
    parser.add_argument(
        "--figure",
        metavar="FILE",
        help="also plot the drift, as .svg or .png (needs ur5check[figures])",
    )
    add_model_options(parser, ("a", "b"))
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """Simulate, report and draw; exit code 0 if the arm stands."""
    options = ModelOptions.of(args, (args.plant, args.torque))
    _check_outputs(args, ())
    _check_figure(args)
    plant, model = arms = options.load(quiet=args.quiet)
    _check_outputs(args, options.files(arms))

    from .._reports.simulate_document import simulate_document
    from .._reports.simulate_json import simulate_json
    from .._simulation.static_hold import stand

    def say(line: str) -> None:
        progress(args.quiet, line)

    say(f"simulating {args.plant} under the torques of {args.torque}, engine {args.engine}")
    s = stand(
        plant,
        model,
        _pose(args.pose),
        engine=args.engine,
        held=not args.recompute,
        seconds=args.seconds,
        dt=args.step,
        integrator=args.integrator,
        progress=say,
    )
    command = _command(args)
    contents = Contents(
        document=lambda target: simulate_document(s, command=command),
        report=lambda: simulate_json(s, command=command),
    )
    if args.figure is not None:
        from .._paper.figures.figure_files import as_png, as_svg
        from .._paper.figures.static_hold_figure import draw_static_hold

        drawn = draw_static_hold(s)
        target = Path(args.figure)
        picture = as_png(drawn) if target.suffix.lower() == ".png" else as_svg(drawn)
        emit_files({target.name: picture}, str(target.parent), option="--figure")
        say(f"drew {args.figure}")
    write_reports(args, contents)
    return 0 if s.stands else 1


def _pose(words: list[str]) -> list[float]:
    """Raises UsageError for anything but a case's name or numbers."""
    from .._paper.cases import CASES

    named = {f"case{case.number}": case for case in CASES if case.swept is None}
    if len(words) == 1 and words[0] in named:
        return [q for q in named[words[0]].posture if q is not None]
    try:
        return [float(word) for word in words]
    except ValueError:
        raise UsageError(
            f"--pose {' '.join(words)}: give {', '.join(named)}, or one angle a joint [rad]"
        ) from None


def _check_figure(args: argparse.Namespace) -> None:
    if args.figure is None:
        return
    if Path(args.figure).suffix.lower() not in _PICTURES:
        raise UsageError(
            f"--figure {args.figure}: is drawn as {' or '.join(_PICTURES)}; end its name in one"
        )
    if is_report(args, args.figure):
        raise UsageError(f"--figure {args.figure}: the report goes there (-o); name another file")
    from .._paper.figures.figure_style import matplotlib

    matplotlib()


def _check_outputs(args: argparse.Namespace, inputs: Iterable[Path]) -> None:
    inputs = tuple(inputs)
    check_reports(args, inputs)
    check_output(args.figure, inputs, option="--figure")


def _command(args: argparse.Namespace) -> str:
    """The command that produces this report, with its defaults spelled out."""
    words = ["--plant", args.plant, "--torque", args.torque, "--pose", *args.pose]
    words += ["--engine", args.engine, "--seconds", f"{args.seconds:g}"]
    if args.engine != "ur5check":
        words += ["--step", f"{args.step:g}"]
    if args.integrator is not None:
        words += ["--integrator", args.integrator]
    words.append("--recompute" if args.recompute else "--hold")
    return f"{command_line('simulate', args, ())} {shlex.join(words)}"
