"""Write a model as URDF, MJCF (MuJoCo) or DH table.  Numbers whose frame does not
change are written unchanged.

What the format cannot hold (URDF: gravity and motor inertia; MJCF: velocity
limits) is listed in a comment at the top of the file and on stderr.
"""

from __future__ import annotations

import argparse

from .._errors import UsageError
from .._io.formats import WRITABLE, format_by_suffix
from .._io.model_format import ModelFormat
from .options import MODELS, ModelOptions, add_model_options, add_output_options, progress
from .output import check_output, emit

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check convert paper --to mjcf
  ur5check convert appendix -o ur5.toml
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `convert` takes."""
    parser.add_argument("model", metavar="MODEL", help="model to convert")
    parser.add_argument(
        "--to",
        choices=tuple(WRITABLE),
        help="format to write (default: by the suffix of -o, "
        f"{', '.join(form.suffixes[0] for form in WRITABLE.values())})",
    )
    add_model_options(parser, ("",))
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Read and write."""
    options = ModelOptions.of(args, (args.model,))
    form = _format(args.to, args.output)
    check_output(args.output, ())
    (arm,) = options.load(quiet=args.quiet)
    check_output(args.output, options.files([arm]))
    text = form.write(arm)
    for line in form.left_out(arm):
        progress(args.quiet, line)
    emit(text, args.output)
    return 0


def _format(to: str | None, output: str | None) -> ModelFormat:
    by_suffix = format_by_suffix(output) if output else None
    if by_suffix is not None and by_suffix.kind not in WRITABLE:
        by_suffix = None
    if to is None and by_suffix is None:
        kinds = "|".join(WRITABLE)
        raise UsageError(f"the format is not given; give --to {kinds}, or -o with its suffix")
    if to is not None and by_suffix is not None and to != by_suffix.kind:
        raise UsageError(f"--to {to} and -o {output} ask for two formats; change one of them")
    return by_suffix or WRITABLE[str(to)]
