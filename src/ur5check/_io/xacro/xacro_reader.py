"""xacro to URDF, for files from untrusted sources.

xacro's `${…}` is code, so a file is expanded in a process of its own (`xacro_process`) with bounded
time, memory and output, an empty environment, and no way to read anything but its own folder and
the packages (`xacro_confinement`).  What comes back is the URDF text, or one ModelError.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

from ..._errors import ModelError
from ..._files import read_regular
from ..bounded_process import EndedError, answer_of
from ..package_search import with_linked_sources
from ..ros_packages import PackageMap
from ..xml.xml_tree import checked_xml
from .xacro_places import FileNames, SourcePlaces

__all__ = ["Expansion", "expand_xacro"]

_NOTE_BYTES = 4096
_OUTPUT_BYTES = 16 * 2**20
_MEMORY_BYTES = 512 * 2**20


@dataclass(frozen=True)
class Expansion:
    """The result of expanding a xacro file.

    text : the URDF
    inputs : (name, SHA-256) of every file that was read, the robot file first; a file in a package
        is named by its package:// URI, which is the same on every machine
    places : where its elements were written
    warnings : those of xacro
    """

    text: str
    inputs: tuple[tuple[str, str], ...]
    places: SourcePlaces
    warnings: tuple[str, ...] = ()


def expand_xacro(
    path: str | os.PathLike[str],
    *,
    arguments: Mapping[str, str],
    packages: PackageMap,
    seconds: float = 20.0,
    label: str | None = None,
) -> Expansion:
    """Expand a xacro file.

    arguments : values for its <xacro:arg>s; one that the file does not know is an error
    packages : answers $(find …), and says which folders may be read besides the file's own
    seconds : wall-clock time that the expansion may take [s]
    label : what places call the file (default: its path)

    Raises ModelError, with file and line wherever they can be told.
    """
    robot = Path(path)
    if not robot.is_file():
        raise ModelError(
            "this is not a file" if robot.exists() else "no such file",
            fix="give the path of a xacro file",
            file=str(path),
            rule="XAC101",
        )
    robot = robot.resolve()
    packages = with_linked_sources(packages)
    folders = [str(robot.parent), *(str(f) for fs in packages.folders.values() for f in fs)]
    request = {
        "robot": str(robot),
        "arguments": dict(arguments),
        "packages": {name: [str(f) for f in fs] for name, fs in packages.folders.items()},
        "folders": folders,
        "seconds": seconds + 1,  # of processor time: wall-clock time ends it first
        "memory_bytes": _MEMORY_BYTES,
        "note_bytes": _NOTE_BYTES,
        "output_bytes": _OUTPUT_BYTES,
    }
    shown = {str(robot): str(path)}
    try:
        data = answer_of(
            "ur5check._io.xacro.xacro_process",
            json.dumps(request).encode(),
            what="the expansion",
            folder=robot.parent,
            seconds=seconds,
        )
    except EndedError as ended:
        raise _ended_error(ended, shown) from None
    try:
        answer = json.loads(data[_NOTE_BYTES:])
        if "error" in answer:
            raise _error(answer["error"], answer["files"], answer["snippet"], shown)
        names = FileNames(str(robot), label or str(path), packages)
        checked_xml(str(answer["text"]).encode(), f"{path} (expanded)")
        return Expansion(
            str(answer["text"]),
            tuple((names.of_input(str(file)), str(digest)) for file, digest in answer["inputs"]),
            SourcePlaces(answer["origins"], names),
            tuple(map(str, answer["warnings"])),
        )
    except (ValueError, TypeError, LookupError):
        # Only an expression that escaped the confinement can cause this.
        raise _ended_error(
            EndedError("the expansion ended without a result", data), shown
        ) from None


def _ended_error(ended: EndedError, shown: Mapping[str, str]) -> ModelError:
    try:
        note = json.loads(ended.output[:_NOTE_BYTES].rstrip(b"\0 "))
        snippet, files = str(note["snippet"]), list(map(str, note["files"]))
    except (ValueError, TypeError, KeyError):
        snippet, files = "", list(shown)
    error = {
        "problem": ended.problem,
        "fix": "simplify what it computes, or allow it more time",
        "element": snippet or None,
        "rule": "XAC104",
    }
    return _error(error, files, snippet, shown)


def _error(
    fields: Mapping[str, Any], files: Sequence[str], snippet: str, shown: Mapping[str, str]
) -> ModelError:
    file, line = fields.get("file"), fields.get("line")
    if file is None:
        file, line = _place(files, snippet)
    return ModelError(
        fields["problem"],
        fix=fields["fix"],
        file=shown.get(file, file),
        line=line,
        element=fields.get("element"),
        value=fields.get("value"),
        rule=fields.get("rule", "XAC100"),
    )


def _place(files: Sequence[str], snippet: str) -> tuple[str, int | None]:
    """The file and line in which the text stands first; xacro itself keeps no lines.

    In an attribute, XML turns line breaks into spaces and some characters into entities.
    """
    words = snippet.split()
    for file in files:
        try:
            text = read_regular(file).decode("utf-8", "replace")
        except OSError:
            continue
        for quote in (str, escape, lambda word: escape(word, {'"': "&quot;"})):
            found = re.search(r"\s+".join(re.escape(quote(word)) for word in words), text)
            if words and found:
                return file, text.count("\n", 0, found.start()) + 1
    return files[0], None
