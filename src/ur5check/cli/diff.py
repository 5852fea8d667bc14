"""Say what differs between two models, by how many newton metres, at which posture it matters most,
and whose every newton metre is.

Exit code 0 if no torque differs by more than a millionth of the largest, 1 if one does.
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
  ur5check diff paper appendix
  ur5check diff old.urdf new.urdf --tip-a tool0 --tip-b tool0 --format json -o diff.json
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `diff` takes."""
    parser.add_argument("a", metavar="A", help="a model")
    parser.add_argument("b", metavar="B", help="another, held against it")
    add_state_options(parser)
    add_model_options(parser, ("a", "b"))
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Compare, report, and say whether they agree."""
    models = (args.a, args.b)
    options = ModelOptions.of(args, models)
    check_output(args.output, ())
    arms = options.load(quiet=args.quiet)
    check_output(args.output, options.files(arms))

    from ..comparison.difference import diff
    from ..reports.difference_document import difference_document
    from ..reports.json_report import difference_json

    progress(args.quiet, f"comparing them at {args.samples:,} states")
    difference = diff(*arms, samples=args.samples, seed=args.seed, gravity=args.gravity)
    command = command_line("diff", args, models)
    text = rendered(
        format_of(args.format, args.output),
        args.output,
        document=lambda: difference_document(difference, command=command),
        report=lambda: difference_json(difference, command=command),
    )
    emit(text, args.output)
    return 0 if difference.agrees else 1
