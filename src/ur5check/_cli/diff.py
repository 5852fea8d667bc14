"""Compare two models of an arm: the largest torque difference, the parameters it is
attributed to, the known mistakes that explain it, and the configuration within
the joint limits where it is largest.

Exit code 0: no torque differs by more than the tolerance, and damping, friction,
limits, motors and gravity are the same. 1: something differs, or a model cannot
exist (it is compared all the same) or has a number that cannot be read, or a finding is
new since the commit of --against-git.
The tolerance is a millionth of the largest torque, or a ten-thousandth where rounded
digits such as 1.5708 for π/2 explain the difference, unless --tolerance gives another.
"""

from __future__ import annotations

import argparse
import shlex
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import ModelError, UsageError
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
from .report_output import (
    add_report_options,
    check_reports,
    is_report,
    report_targets,
    write_reports,
)

if TYPE_CHECKING:
    from .._comparison.diagnosis.diagnosis import Diagnosis
    from .._comparison.difference import Difference
    from .._io.robot_limbs import Limbs
    from .._reports.document import Document
    from .._reports.report_formats import Target
    from .._validation.revision_change import RevisionChange

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check diff paper appendix
  ur5check diff vendor.urdf mine.urdf --tip-a tool0 --tip-b tool0 -o diff.md
  ur5check diff vendor.urdf mine.urdf --repair repaired.urdf
  ur5check diff arm.urdf.xacro --against-git main
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `diff` takes."""
    parser.add_argument("a", metavar="A", help="the reference model")
    parser.add_argument("b", metavar="B", nargs="?", help="the model that is compared with it")
    parser.add_argument(
        "--against-git",
        metavar="REF",
        help="compare file A as commit REF has it with the file as it is: torques, mass, findings",
    )
    parser.add_argument(
        "--quick",
        action="store_true",
        help="differences and attribution only; no diagnosis of mistakes",
    )
    parser.add_argument(
        "--as-written",
        action="store_true",
        help="compare joint angles as they are written; reverse and shift no joint",
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
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """Compare, explain, report, and say whether they agree."""
    models = _models(args)
    options = ModelOptions.of(args, models)
    _check_options(args)
    _check_outputs(args, ())

    def say(line: str) -> None:
        progress(args.quiet, line)

    change = None
    try:
        if args.against_git is None:
            arms = options.load(quiet=args.quiet, strict=False)
        else:
            from .git_comparison import arms_and_change

            arms, change = arms_and_change(args.against_git, options, say)
    except ModelError as error:
        limbs = _limbs(options) if args.against_git is None else None
        if limbs is not None:
            return _compare_limbs(args, *limbs)
        if error.line is None and error.rule == ModelError.UNSPECIFIED:
            raise  # a file that is not there, a choice of chains: nothing that a file says
        progress(False, f"error: {' '.join(str(error).split())}")
        return 1
    _check_outputs(args, options.files(arms))

    from .._comparison.difference import diff

    say(f"comparing them at {args.samples:,} states")
    d = diff(
        *arms,
        samples=args.samples,
        seed=args.seed,
        gravity=args.gravity,
        tolerance=args.tolerance,
        uncertainty=args.uncertainty,
        as_written=args.as_written,
    )
    contents, diagnosis = _contents(args, d, change, say)
    if args.repair is not None and diagnosis is not None:
        from .repaired_model import repair

        repair(d, diagnosis, args.repair, say)
    write_reports(args, contents)
    new = change is not None and bool(change.new)
    return 0 if d.agrees and not any(d.faults.values()) and not new else 1


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
    from .._reports.limbs_json import limbs_json
    from .._reports.terminal import render_text

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
        as_written=args.as_written,
        progress=lambda line: progress(args.quiet, line),
    )
    command = _command(args, None)

    def document(target: Target) -> Document:
        return limbs_document(c, command=command)

    def text(target: Target) -> str:
        if not args.full and target.file is None:
            return limbs_text(c)
        return render_text(document(target), width=target.width, colour=target.colour)

    write_reports(args, Contents(document, lambda: limbs_json(c, command=command), text))
    return 0 if c.agrees else 1


def _contents(
    args: argparse.Namespace,
    d: Difference,
    change: RevisionChange | None,
    say: Callable[[str], None],
) -> tuple[Contents, Diagnosis | None]:
    """What the reports show, and the known mistakes, where they were looked for."""
    from .._arguments import number
    from .._robot.states import MAX_ACCELERATION

    explained = not args.quick and not d.gravity_only
    if d.gravity_only:
        say("tensors are unknown: only gravity torques are compared, and not explained")
    if explained:
        given = MAX_ACCELERATION if args.acceleration is None else args.acceleration
        args.acceleration = number("acceleration", given, positive=True)
    if _first_screen_only(args):
        from .._comparison.causes import find_causes
        from .._reports.diff_text import diff_text
        from .._reports.revision_section import change_in_words

        causes = None
        if explained and not (d.same_torques and args.repair is None):
            causes = find_causes(d, acceleration=args.acceleration, progress=say)
        text = diff_text(
            d,
            causes,
            asked_tolerance=args.tolerance is not None,
            since_commit=() if change is None else change_in_words(change),
        )
        return Contents.of_text(text), None if causes is None else causes.diagnosis

    from .._comparison.attribution_detail import by_parameter
    from .._comparison.explanation import explain
    from .._reports.diff_document import diff_document
    from .._reports.diff_json import diff_json
    from .._reports.revision_section import with_change

    explanation = explain(d, acceleration=args.acceleration, progress=say) if explained else None
    parameters = by_parameter(d.pair, d.states) if args.by_parameter else None
    command = _command(args, change)

    def document(target: Target) -> Document:
        made = diff_document(
            d,
            explanation,
            parameters=parameters,
            written_out=args.by_parameter or target.form.all_tables,
            command=command,
        )
        return made if change is None else with_change(made, change)

    contents = Contents(
        document=document,
        report=lambda: diff_json(
            d, explanation, parameters=parameters, change=change, command=command
        ),
    )
    return contents, None if explanation is None else explanation.diagnosis


def _first_screen_only(args: argparse.Namespace) -> bool:
    """Whether the answer goes to the screen alone, without --full or --by-parameter."""
    to_screen = all(t.file is None and t.form.name == "text" for t in report_targets(args))
    return to_screen and not (args.full or args.by_parameter)


def _command(args: argparse.Namespace, change: RevisionChange | None) -> str:
    """The command of this report."""
    models = (args.a,) if change is not None else (args.a, args.b)
    command = command_line("diff", args, models)
    if change is not None:
        command += f" --against-git {shlex.quote(change.revision)}"
    for option in ("tolerance", "uncertainty"):
        value = getattr(args, option)
        if value is not None:
            command += f" --{option} {shlex.quote(value)}"
    return command


def _models(args: argparse.Namespace) -> tuple[str, str]:
    """A and B, or one file twice.  Raises UsageError for a model too few or too many."""
    if args.against_git is not None and args.b is not None:
        raise UsageError("--against-git compares one file with itself; give no second model")
    b = args.a if args.against_git is not None else args.b
    if b is None:
        raise UsageError("a model is required: B; see `ur5check diff --help`")
    return args.a, b


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
