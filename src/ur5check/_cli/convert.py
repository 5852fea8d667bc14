"""Write a model as URDF, MJCF (MuJoCo) or DH table, exact to the digit where no frame changes.

What the format cannot say (URDF: gravity and motor inertia; MJCF: velocity limits) is said in a
comment at the top, with where the numbers came from, and on stderr."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import UsageError
from .options import MODELS, ModelOptions, add_model_options, add_output_options, progress
from .output import check_output, emit

if TYPE_CHECKING:
    from .._robot.serial_arm import SerialArm

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check convert paper --to mjcf
  ur5check convert appendix -o ur5.toml
"""

_SUFFIXES = {".urdf": "urdf", ".xml": "mjcf", ".mjcf": "mjcf", ".toml": "dh"}


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `convert` takes."""
    parser.add_argument("model", metavar="MODEL", help="what to convert")
    parser.add_argument(
        "--to",
        choices=("urdf", "mjcf", "dh"),
        help="default: what the suffix of -o says (.urdf, .xml, .toml)",
    )
    add_model_options(parser, ("",))
    add_output_options(parser, formats=False)


def run(args: argparse.Namespace) -> int:
    """Read and write."""
    options = ModelOptions.of(args, (args.model,))
    form = _format(args.to, args.output)
    check_output(args.output, ())
    (arm,) = options.load(quiet=args.quiet)
    check_output(args.output, options.files([arm]))
    text = _written(arm, form)
    for line in _left_out(arm, form):
        progress(args.quiet, line)
    emit(text, args.output)
    return 0


def _format(to: str | None, output: str | None) -> str:
    suffix = Path(output).suffix.lower() if output else ""
    by_suffix = _SUFFIXES.get(suffix)
    if to is None and by_suffix is None:
        raise UsageError("the format is not said; give --to urdf|mjcf|dh, or -o with its suffix")
    if to is not None and by_suffix is not None and to != by_suffix:
        raise UsageError(f"--to {to} and -o {output} ask for two formats; change one of them")
    return to or str(by_suffix)


def _written(arm: SerialArm, form: str) -> str:
    if form == "mjcf":
        from .._io.mjcf.mjcf_writer import mjcf_of

        return mjcf_of(arm)
    if form == "dh":
        from .._io.dh.dh_writer import dh_toml_of

        return dh_toml_of(arm)
    from .._io.urdf.urdf_writer import urdf_of

    return urdf_of(arm)


def _left_out(arm: SerialArm, form: str) -> list[str]:
    """What the format cannot carry, as its writer says in the file's own comments."""
    if form == "mjcf":
        from .._io.mjcf.mjcf_writer import not_said
    elif form == "urdf":
        from .._io.urdf.urdf_writer import not_said
    else:
        return []
    return not_said(arm)
