"""Compare two models of an arm: the largest torque difference, the parameters it is
attributed to, the known mistakes that explain it, and the configuration within
the joint limits where it is largest.

Exit code 0: no torque differs by more than the tolerance, and damping, friction,
limits, motors and gravity are the same. 1: something differs, or a model cannot
exist (it is compared all the same) or has a number that cannot be read.
"""

from __future__ import annotations

import argparse
import shlex
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import ModelError, UsageError
from .options import (
    MODELS,
    ModelOptions,
    add_gravity_option,
    add_model_options,
    add_output_options,
    add_state_options,
    command_line,
    progress,
)
from .output import check_output, emit, format_of, rendered

if TYPE_CHECKING:
    from .._comparison.diagnosis.diagnosis import Diagnosis
    from .._comparison.difference import Difference
    from .._io.robot_limbs import Limbs

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
    parser.add_argument(
        "--full",
        action="store_true",
        help="all tables: numbers, attribution, identifiability, digits, worst case of each joint "
        "(a file has them in any case)",
    )
    add_state_options(parser)
    add_gravity_option(parser)
    add_model_options(parser, ("a", "b"))
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Compare, explain, report, and say whether they agree."""
    models = (args.a, args.b)
    options = ModelOptions.of(args, models)
    _check_options(args)
    _check_outputs(args, ())
    try:
        arms = options.load(quiet=args.quiet, strict=False)
    except ModelError as error:
        limbs = _limbs(options)
        if limbs is not None:
            return _compare_limbs(args, *limbs)
        if error.line is None and error.rule == ModelError.UNSPECIFIED:
            raise  # a file that is not there, a choice of chains: nothing that a file says
        progress(False, f"error: {' '.join(str(error).split())}")
        return 1
    _check_outputs(args, options.files(arms))

    from .._comparison.difference import diff

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
    text, diagnosis = _report(args, d, say)
    if args.repair is not None and diagnosis is not None:
        from .repaired_model import repair

        repair(d, diagnosis, args.repair, say)
    emit(text, args.output)
    return 0 if d.agrees and not any(d.faults.values()) else 1


def _limbs(options: ModelOptions) -> tuple[Limbs, Limbs] | None:
    """Of two files with several chains each, none of which was asked for."""
    from .._io.robot_limbs import read_limbs

    if any(value is not None for chain in options.chains for value in chain.values()):
        return None
    found = [
        read_limbs(model, packages=options.packages, arguments=options.arguments_of(model))
        for model in options.models
    ]
    return (found[0], found[1]) if found[0] is not None and found[1] is not None else None


def _compare_limbs(args: argparse.Namespace, a: Limbs, b: Limbs) -> int:
    """Limb by limb; nothing is explained."""
    from .._comparison.limb_comparison import compare_limbs
    from .._reports.limbs_document import limbs_document, limbs_text

    for option in ("repair", "acceleration", "uncertainty"):
        if getattr(args, option) is not None:
            raise UsageError(f"--{option} is for one arm; choose it with --tip-a and --tip-b")
    _check_outputs(args, (Path(name) for limbs in (a, b) for name, _ in limbs.robot.inputs))
    c = compare_limbs(
        a,
        b,
        samples=args.samples,
        seed=args.seed,
        gravity=args.gravity,
        tolerance=args.tolerance,
        progress=lambda line: progress(args.quiet, line),
    )
    command = command_line("diff", args, (args.a, args.b))
    form = format_of(args.format, args.output)
    if form.name == "text" and args.output is None and not args.full:
        text = limbs_text(c)
    else:
        from .._reports.limbs_json import limbs_json

        text = rendered(
            form,
            args.output,
            document=lambda: limbs_document(c, command=command),
            report=lambda: limbs_json(c, command=command),
        )
    emit(text, args.output)
    return 0 if c.agrees else 1


def _report(
    args: argparse.Namespace, d: Difference, say: Callable[[str], None]
) -> tuple[str, Diagnosis | None]:
    """The report as text, and the known mistakes, where they were looked for."""
    from .._arguments import number
    from .._robot.states import MAX_ACCELERATION

    form = format_of(args.format, args.output)
    explained = not args.quick and not d.gravity_only
    if d.gravity_only:
        say("tensors are unknown: only gravity torques are compared, and not explained")
    if explained:
        given = MAX_ACCELERATION if args.acceleration is None else args.acceleration
        args.acceleration = number("acceleration", given, positive=True)
    if form.name == "text" and args.output is None and not (args.full or args.by_parameter):
        from .._comparison.causes import find_causes
        from .._reports.diff_text import diff_text

        causes = None
        if explained and not (d.same_torques and args.repair is None):
            causes = find_causes(d, acceleration=args.acceleration, progress=say)
        text = diff_text(d, causes, asked_tolerance=args.tolerance is not None)
        return text, None if causes is None else causes.diagnosis

    from .._comparison.attribution_detail import by_parameter
    from .._comparison.explanation import explain
    from .._reports.diff_document import diff_document
    from .._reports.diff_json import diff_json

    explanation = explain(d, acceleration=args.acceleration, progress=say) if explained else None
    parameters = by_parameter(d.pair, d.states) if args.by_parameter else None
    command = command_line("diff", args, (args.a, args.b))
    if args.tolerance is not None:
        command += f" --tolerance {shlex.quote(args.tolerance)}"
    text = rendered(
        form,
        args.output,
        document=lambda: diff_document(
            d,
            explanation,
            parameters=parameters,
            written_out=args.by_parameter or form.all_tables,
            command=command,
        ),
        report=lambda: diff_json(d, explanation, parameters=parameters, command=command),
    )
    return text, None if explanation is None else explanation.diagnosis


def _check_options(args: argparse.Namespace) -> None:
    """Raises UsageError for options that have no meaning together."""
    for option in ("repair", "acceleration"):
        if args.quick and getattr(args, option) is not None:
            raise UsageError(f"--{option} needs the explanation that --quick leaves out; drop one")
    if args.repair is None:
        return
    if Path(args.repair).suffix.lower() != ".urdf":
        raise UsageError(f"--repair {args.repair}: a URDF is written there; end its name in .urdf")
    if args.output is not None and Path(args.output).resolve() == Path(args.repair).resolve():
        raise UsageError(f"--repair {args.repair}: the report goes there (-o); name another file")


def _check_outputs(args: argparse.Namespace, inputs: Iterable[Path]) -> None:
    inputs = tuple(inputs)
    check_output(args.output, inputs)
    check_output(args.repair, inputs, option="--repair")
