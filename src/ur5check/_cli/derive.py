"""Derive an arm's equations of motion in closed form: torques, mass matrix, Coriolis
matrix or gravity torques, simplified, as code or as formulas, with the number of
operations.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from .options import (
    MODELS,
    ModelOptions,
    add_model_options,
    add_output_options,
    command_line,
    progress,
)
from .output import check_output, emit

if TYPE_CHECKING:
    from .._dynamics.symbolic.derivation import Derivation
    from .._robot.serial_arm import SerialArm

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check derive appendix --to c -o tau.c
  ur5check derive robot.urdf --quantity M --parameters symbolic --to latex
"""

_QUANTITIES = ("tau", "M", "C", "g")
_TARGETS = ("python", "c", "sympy", "latex", "json")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Arguments of `derive`."""
    parser.add_argument("model", metavar="MODEL", help="model whose dynamics are derived")
    parser.add_argument(
        "--quantity",
        choices=_QUANTITIES,
        default="tau",
        help="tau: torques (default), M: mass matrix, C: Coriolis matrix, g: gravity torques",
    )
    parser.add_argument(
        "--to", choices=_TARGETS, default="python", help="language of the result (default: python)"
    )
    parser.add_argument(
        "--parameters",
        choices=("numeric", "symbolic"),
        default="numeric",
        help="numeric: the model's values (default); symbolic: names such as m2, cx2, Izz2, a2, d4",
    )
    add_model_options(parser, ("",))
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Derive and print; operation counts and time go to stderr."""
    options = ModelOptions.of(args, (args.model,))
    check_output(args.output, ())
    (arm,) = options.load(quiet=args.quiet)
    check_output(args.output, options.files([arm]))

    from .._dynamics.symbolic.derivation import derive

    derivation = derive(arm, args.quantity, parameters=args.parameters)
    for stage, operations in derivation.stages:
        progress(args.quiet, f"{operations}: {stage}")
    progress(args.quiet, f"derived in {derivation.seconds:.1f} s")
    command = command_line("derive", args, (args.model,))
    emit(_text(args.to, arm, derivation, command), args.output)
    return 0


def _text(target: str, arm: SerialArm, derivation: Derivation, command: str) -> str:
    from .._dynamics.symbolic.to_c import to_c
    from .._dynamics.symbolic.to_latex import to_latex
    from .._dynamics.symbolic.to_python import to_python
    from .._dynamics.symbolic.to_sympy import to_sympy
    from .._reports.derive_json import derive_json
    from .._reports.json_report import json_text

    if target == "json":
        return json_text(derive_json(arm, derivation, command=command))
    printers = {"python": to_python, "c": to_c, "sympy": to_sympy, "latex": to_latex}
    return printers[target](derivation.program, head=_head(arm, derivation, command))


def _head(arm: SerialArm, derivation: Derivation, command: str) -> Sequence[str]:
    """The provenance of the text: command, inputs, versions, operation counts."""
    from .._reports.provenance import Provenance, inputs_of

    made = Provenance(inputs_of([arm]), command=command)
    return [
        f"Command: {command}",
        *(f"from {name}, SHA-256 {digest}" for name, digest in made.inputs),
        f"with {made.made_by}",
        *(f"{operations}: {stage}" for stage, operations in derivation.stages),
    ]
