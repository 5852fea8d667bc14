"""JSON of the reports: what all of them have, how they are written, and their schema.

Each command has one type of report, in the file `<command>_json.py`.  The fields of these types are
the JSON's fields, and the schema is derived from the types (docs/json.md).
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from typing import Annotated, Any, TypedDict

import msgspec
import numpy as np

from .._robot.robot_tree import ArmOrTree
from .provenance import Provenance, inputs_of

__all__ = ["Input", "Report", "Tool", "head", "json_line", "json_text"]


class Tool(msgspec.Struct, frozen=True):
    """The program that made the report, and the libraries that it used."""

    name: str
    version: str
    libraries: dict[str, str]


class Input(msgspec.Struct, frozen=True):
    """A file that was read."""

    name: str
    sha256: Annotated[str, msgspec.Meta(pattern="^[0-9a-f]{64}$")]


class Report(msgspec.Struct, frozen=True, kw_only=True, tag_field="schema"):
    """What every report begins with; the tag of each type is "ur5check.<command>/<version>"."""

    tool: Tool
    command: str | None
    inputs: list[Input]
    seed: int | None
    samples: int | None


class Head(TypedDict):
    """The fields of `Report`."""

    tool: Tool
    command: str | None
    inputs: list[Input]
    seed: int | None
    samples: int | None


def head(
    arms: Iterable[ArmOrTree],
    command: str,
    *,
    seed: int | None = None,
    samples: int | None = None,
    files: Iterable[tuple[str, str]] = (),
) -> Head:
    """What made a report.

    arms : whose files were read;  files : (name, SHA-256) of other files
    seed, samples : of the random states; None where there were none
    """
    made = Provenance((*inputs_of(arms), *files), seed, samples, command)
    return {
        "tool": Tool("ur5check", made.version, made.libraries),
        "command": made.command or None,
        "inputs": [Input(name, digest) for name, digest in made.inputs],
        "seed": seed,
        "samples": samples,
    }


def json_text(report: Report) -> str:
    """The report as strict JSON: all digits, null for what is no finite number."""
    return _dumped(report, indent=2)


def json_line(value: msgspec.Struct) -> str:
    """A part of a report as one line of strict JSON."""
    return _dumped(value, indent=None)


def _dumped(value: msgspec.Struct, indent: int | None) -> str:
    plain = _strict(msgspec.to_builtins(value, enc_hook=_builtin))
    return json.dumps(plain, indent=indent, ensure_ascii=False, allow_nan=False) + "\n"


def _builtin(value: Any) -> Any:
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, float):  # a number that knows how it was printed
        return float(value)
    raise NotImplementedError(f"a {type(value).__name__} has no JSON")


def _strict(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _strict(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_strict(item) for item in value]
    if isinstance(value, float):
        # Adding 0.0 turns −0.0 into 0.0.
        return value + 0.0 if math.isfinite(value) else None
    return value
