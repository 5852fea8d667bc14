"""Options that several commands share, and the models that they select."""

from __future__ import annotations

import argparse
import shlex
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypedDict

from .._errors import UsageError
from .._io.formats import FORMATS as MODEL_FORMATS
from .._io.formats import format_by_suffix, suffixes_in_words

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .._robot.robot_tree import ArmOrTree
    from .._robot.serial_arm import SerialArm

__all__ = [
    "MODELS",
    "ModelOptions",
    "add_gravity_option",
    "add_model_options",
    "add_output_options",
    "add_state_options",
    "chain_options",
    "command_line",
    "count",
    "name_value_pairs",
    "progress",
]

MODELS = f"MODEL is paper, paper-listing, appendix, erd-ur5,\nor a file: {suffixes_in_words()}."


# What chooses the chain of a model.
_CHAIN = ("base", "tip", "arm")

# Options without a value that change what a report says.
_FLAGS = ("quick", "as_written", "by_parameter")


def add_output_options(parser: argparse.ArgumentParser) -> None:
    """-o, --quiet, for a command that makes one text; one with reports: `add_report_options`."""
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="write to this file instead of stdout"
    )
    parser.add_argument("--quiet", action="store_true", help="show no progress on stderr")


def add_state_options(parser: argparse.ArgumentParser, *, many: bool = False) -> None:
    """--samples, --seed.

    many : for a command that takes many models, which chooses their number of states itself
    """
    parser.add_argument(
        "--samples",
        type=count,
        default=None if many else 10_000,
        metavar="N",
        help="number of random states "
        f"(default: {'1000; 100 of each of many models' if many else '10000'})",
    )
    parser.add_argument(
        "--seed", type=int, default=0, metavar="N", help="seed of the random states (default: 0)"
    )


def add_gravity_option(parser: argparse.ArgumentParser) -> None:
    """--gravity."""
    parser.add_argument(
        "--gravity",
        type=float,
        nargs=3,
        metavar=("X", "Y", "Z"),
        help="gravity in the base frame of each model [m/s²] (default: the model's own)",
    )


def add_model_options(parser: argparse.ArgumentParser, sides: tuple[str, ...]) -> None:
    """--base, --tip and --arm for each of `sides` ("" for the only model), --package, --arg."""
    for side in sides:
        suffix, of = (f"-{side}", f"{side.upper()}'s") if side else ("", "the model's")
        for end, what in (("base", "first"), ("tip", "last")):
            parser.add_argument(
                f"--{end}{suffix}",
                metavar="LINK",
                help=f"{of} {what} link (default: of its only chain)",
            )
        parser.add_argument(
            f"--arm{suffix}",
            metavar="NAME",
            help=f"{of} arm, of several: left, right_arm, its last link",
        )
    parser.add_argument(
        "--package",
        action="append",
        default=[],
        metavar="NAME=DIR",
        help="folder of a ROS package, for $(find NAME) and package://NAME; repeatable",
    )
    parser.add_argument(
        "--arg",
        action="append",
        default=[],
        metavar="NAME:=VALUE",
        help="value of a xacro argument; repeatable",
    )


class ChainOptions(TypedDict):
    """Which chain of a robot is the arm."""

    base: str | None
    tip: str | None
    arm: str | None


@dataclass(frozen=True)
class ModelOptions:
    """How to read the models of one command line.

    chains : base, tip and arm of each model
    """

    models: tuple[str, ...]
    chains: tuple[ChainOptions, ...]
    packages: dict[str, str]
    arguments: dict[str, str]

    @classmethod
    def of(cls, args: argparse.Namespace, models: tuple[str, ...]) -> ModelOptions:
        """Raises UsageError for ends of a model that is not there, and pairs that are none."""
        chains = chain_options(args, len(models))
        arguments = name_value_pairs(args.arg, "--arg", ":=")
        if arguments and not any(_is_xacro(model) for model in models):
            raise UsageError("--arg has no meaning here: none of the models is a xacro")
        return cls(models, chains, name_value_pairs(args.package, "--package", "="), arguments)

    def load(self, *, quiet: bool, strict: bool = True) -> list[SerialArm]:
        """Every arm, in order.  strict : refuse bodies that cannot exist, as `load` does"""
        from .._io.loading import load

        arms = []
        for model, chain in zip(self.models, self.chains, strict=True):
            progress(quiet, f"reading {model}")
            arguments = self.arguments_of(model)
            packages = self.packages
            arms.append(load(model, **chain, packages=packages, arguments=arguments, strict=strict))
        return arms

    def arguments_of(self, model: str) -> dict[str, str] | None:
        """Arguments for a xacro; None for another file."""
        return self.arguments if _is_xacro(model) else None

    def load_arm_or_tree(self, *, whole: bool, quiet: bool) -> ArmOrTree:
        """The arm of the only model, or the whole robot (see `_io.arm_or_tree`)."""
        from .._io.arm_or_tree import load_arm_or_tree

        (model,), (chain,) = self.models, self.chains
        progress(quiet, f"reading {model}")
        arguments = self.arguments_of(model)
        packages = self.packages
        return load_arm_or_tree(model, whole=whole, **chain, packages=packages, arguments=arguments)

    def files(self, arms: Sequence[ArmOrTree]) -> list[Path]:
        """What was read: the models' own files, and those that a xacro included."""
        from .input_files import input_files

        return [
            file
            for model, arm in zip(self.models, arms, strict=True)
            for file in input_files(model, arm.source.inputs, self.packages)
        ]


def count(text: str) -> int:
    """`1e8`, `100000000` or `100_000_000`."""
    try:
        value = float(text)
        if value == int(value):
            return int(text) if text.lstrip("+-").replace("_", "").isdecimal() else int(value)
    except (ValueError, OverflowError):
        pass
    raise argparse.ArgumentTypeError(f"{text!r} is not a whole number; write 1e8 or 100000000")


def chain_options(args: argparse.Namespace, count: int) -> tuple[ChainOptions, ...]:
    """base, tip and arm of each of `count` models; --base-a … of two, none of many.

    Raises UsageError for an option of a model that is not there.
    """
    sides = {1: ("",), 2: ("_a", "_b")}.get(count, ())
    for end in _CHAIN:
        for side in ("", "_a", "_b"):
            if getattr(args, end + side, None) is not None and side not in sides:
                option = f"--{end}{side.replace('_', '-')}"
                wanted = {1: f"--{end}", 2: f"--{end}-a or --{end}-b"}
                raise UsageError(
                    f"{option} has no meaning with {count} model{'s' if count > 1 else ''}; "
                    f"use {wanted.get(count, 'one or two models')}"
                )
    chosen = sides or ("",) * count
    return tuple(
        ChainOptions(
            base=getattr(args, f"base{side}", None),
            tip=getattr(args, f"tip{side}", None),
            arm=getattr(args, f"arm{side}", None),
        )
        for side in chosen
    )


def name_value_pairs(given: list[str], option: str, sign: str) -> dict[str, str]:
    """NAME=VALUE of a repeatable option.  Raises UsageError for what is none, or said twice."""
    pairs: dict[str, str] = {}
    for text in given:
        name, found, value = text.partition(sign)
        if not found or not name.strip():
            raise UsageError(f"{option} {text}: write {option} NAME{sign}VALUE")
        if name in pairs:
            raise UsageError(f"{option} {name}{sign}… is given twice; give it once")
        pairs[name] = value
    return pairs


def command_line(command: str, args: argparse.Namespace, models: tuple[str, ...]) -> str:
    """The command that makes this report again, with its defaults spelled out."""
    words = ["ur5check", command, *models]
    chain = [end + side for side in ("", "_a", "_b") for end in _CHAIN]
    for option in (*chain, "samples", "seed"):
        value = getattr(args, option, None)
        if value is not None:
            words += [f"--{option.replace('_', '-')}", str(value)]
    for option in ("quantity", "to", "parameters", "uncertainty"):
        value = getattr(args, option, None)
        if value is not None:
            words += [f"--{option}", value]
    if getattr(args, "gravity", None) is not None:
        words += ["--gravity", *map(repr, args.gravity)]
    if getattr(args, "acceleration", None) is not None:
        words += ["--acceleration", repr(args.acceleration)]
    words += [f"--{flag.replace('_', '-')}" for flag in _FLAGS if getattr(args, flag, False)]
    for option in ("package", "arg"):
        for text in getattr(args, option, ()):
            words += [f"--{option}", text]
    return shlex.join(words)


def progress(quiet: bool, line: str) -> None:
    """One plain line on stderr."""
    if not quiet:
        print(f"ur5check: {line}", file=sys.stderr, flush=True)  # noqa: T201


def _is_xacro(model: str) -> bool:
    from .._io.shipped_models import SHIPPED_MODELS

    shipped = SHIPPED_MODELS.get(model)
    form = format_by_suffix(model) if shipped is None else MODEL_FORMATS[shipped.kind]
    return form is not None and "arguments" in form.options
