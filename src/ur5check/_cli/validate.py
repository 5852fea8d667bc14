"""Check models: whether each link's inertia is physically consistent, whether the
dynamics computed here and by Pinocchio agree and satisfy the laws of rigid body
dynamics, and, for several models, which parameters explain the torque
differences from the first.

Exit code 0: all checks pass; models may differ if the difference is attributed
to parameters without a residual.  1: a check fails.
"""

from __future__ import annotations

import argparse

from .options import (
    MODELS,
    ModelOptions,
    add_model_options,
    add_output_options,
    add_state_options,
    command_line,
    progress,
)
from .output import check_output, emit, format_of, rendered

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check validate
  ur5check validate my_arm.urdf
  ur5check validate my_arm.urdf.xacro --package my_robot=. --arg prefix:=left_
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `validate` takes."""
    parser.add_argument(
        "models", nargs="*", metavar="MODEL", help="models to check (default: paper appendix)"
    )
    add_state_options(parser)
    add_model_options(parser, ("", "a", "b"))
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Validate, report, and say whether it passed."""
    models = tuple(args.models) or ("paper", "appendix")
    options = ModelOptions.of(args, models)
    check_output(args.output, ())
    arms = options.load(quiet=args.quiet)
    check_output(args.output, options.files(arms))

    from .._reports.validate_document import validate_document
    from .._reports.validate_json import validate_json
    from .._validation.validation import validate

    validation = validate(
        *arms,
        samples=args.samples,
        seed=args.seed,
        gravity=args.gravity,
        progress=lambda line: progress(args.quiet, line),
    )
    command = command_line("validate", args, models)
    text = rendered(
        format_of(args.format, args.output),
        args.output,
        document=lambda: validate_document(validation, command=command),
        report=lambda: validate_json(validation, command=command),
    )
    emit(text, args.output)
    return 0 if validation.passed else 1
