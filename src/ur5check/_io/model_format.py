"""What the program knows about one file format; each format's folder declares its own record."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._errors import UsageError

if TYPE_CHECKING:
    from .._robot.serial_arm import SerialArm

__all__ = ["ModelFile", "ModelFormat"]


@dataclass(frozen=True, eq=False)
class ModelFile:
    """A file to read.

    path, data : where it is and its bytes;  label : what errors and reports call it
    base, tip : links between which the arm is taken, None for the format's default
    packages : ROS package names and their folders;  arguments : of a xacro
    strict : whether bodies that cannot exist are refused
    """

    path: Path
    label: str
    data: bytes
    base: str | None = None
    tip: str | None = None
    packages: Mapping[str, str | Path] | None = None
    arguments: Mapping[str, str] | None = None
    strict: bool = True


@dataclass(frozen=True)
class ModelFormat:
    """A format.

    kind : short name, in commands (`--to urdf`), reports and JSON
    title : for tables and messages;  noun : with its article
    suffixes : of file names, in lower case, the usual one first
    purpose : what the format is for
    options : arguments of `load` that have a meaning for it, out of base, tip, arguments
    reader, writer, omissions : "module:function", imported when called.  A reader takes a
        `ModelFile` and returns a `SerialArm`; a writer takes a `SerialArm` and returns text;
        `omissions` takes a `SerialArm` and lists what the text leaves out.  "" where there is none
    xml_root : root element by which a file called .xml is recognised, "" where it is not
    tensors_needed : whether every link must have a tensor
    """

    kind: str
    title: str
    noun: str
    suffixes: tuple[str, ...]
    purpose: str
    options: tuple[str, ...]
    reader: str
    writer: str = ""
    omissions: str = ""
    xml_root: str = ""
    tensors_needed: bool = True

    def read(self, file: ModelFile) -> SerialArm:
        """The arm in a file.

        Raises ModelError for what is wrong in it, UsageError for an option without a meaning.
        """
        for option in ("base", "tip", "arguments"):
            if getattr(file, option) and option not in self.options:
                raise UsageError(f"{option}= has no meaning for {self.noun}; leave it out")
        arm: SerialArm = _function(self.reader)(file)
        return arm

    def write(self, arm: SerialArm) -> str:
        """The text of a file that describes the arm.

        Raises ModelError for unknown tensors, where the format must have them.
        """
        if self.tensors_needed:
            arm.require_tensors(f"a model in {self.title}")
        return str(_function(self.writer)(arm))

    def left_out(self, arm: SerialArm) -> list[str]:
        """What the written text does not carry, a sentence each."""
        return list(_function(self.omissions)(arm)) if self.omissions else []


def _function(reference: str) -> Callable[..., Any]:
    module, _, name = reference.partition(":")
    function: Callable[..., Any] = getattr(import_module(module, __package__), name)
    return function
