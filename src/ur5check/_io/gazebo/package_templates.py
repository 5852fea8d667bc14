"""The files of a package before their blanks are filled: `templates/ros2/package.xml.in` and so on.

A blank is written @{name}, since $ has meanings of its own in xacro, launch files and CMake.
"""

from __future__ import annotations

import string
from collections.abc import Iterator, Mapping, Sequence
from importlib import resources
from importlib.resources.abc import Traversable

__all__ = ["fill", "names_under"]

_SUFFIX = ".in"
_XML = (".launch", ".md", ".sdf", ".urdf", ".world", ".xacro", ".xml")


class _Template(string.Template):
    delimiter = "@"


def names_under(folder: str) -> list[str]:
    """The templates of a folder, each by the path of the file that it becomes."""
    return sorted(_walk(_root() / folder, ""))


def fill(name: str, blanks: Mapping[str, str], provenance: Sequence[str] = ()) -> str:
    """One template's text with its blanks filled.

    name : its path under `templates/`, without the suffix
    provenance : lines for its first comment, written as this kind of file writes comments

    Raises KeyError for a blank without a value.
    """
    text = _root().joinpath(f"{name}{_SUFFIX}").read_text(encoding="utf-8")
    return _Template(text).substitute(blanks, provenance=comment_body(name, provenance))


def comment_body(name: str, lines: Sequence[str]) -> str:
    """Lines as the inside of the comment that opens a file of that name."""
    if not name.endswith(_XML):
        return "\n# ".join(lines)
    body = "\n     ".join(lines)
    while "--" in body:  # which no XML comment may hold
        body = body.replace("--", "- -")
    return body.rstrip("-")


def _root() -> Traversable:
    return resources.files(__package__) / "templates"


def _walk(folder: Traversable, prefix: str) -> Iterator[str]:
    for entry in folder.iterdir():
        path = f"{prefix}{entry.name}"
        if entry.is_dir():
            yield from _walk(entry, f"{path}/")
        elif entry.name.endswith(_SUFFIX):
            yield path.removesuffix(_SUFFIX)
