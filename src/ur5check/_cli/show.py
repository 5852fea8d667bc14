"""Show a model as it is read: joints, limits, geometry, masses, centres of mass and
inertia tensors, in the link frames of its own file.
"""

from __future__ import annotations

import argparse

from .._reports.report_formats import Contents
from .options import MODELS, ModelOptions, add_model_options, command_line
from .report_output import add_report_options, check_reports, write_reports

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check show appendix --arg limited:=true
  ur5check show robot.urdf --base base_link --tip tool0 --format json
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `show` takes."""
    parser.add_argument("model", metavar="MODEL", help="model to show")
    add_model_options(parser, ("",))
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """Read and show."""
    options = ModelOptions.of(args, (args.model,))
    check_reports(args)
    arms = options.load(quiet=True)
    check_reports(args, options.files(arms))

    from .._reports.show_document import show_document
    from .._reports.show_json import show_json

    (arm,) = arms
    command = command_line("show", args, (args.model,))
    contents = Contents(
        document=lambda target: show_document(arm, command=command),
        report=lambda: show_json(arm, command=command),
    )
    write_reports(args, contents)
    return 0
