"""ROS packages around a file, found without being named.

In this order: the package that the file itself stands in (`package.xml` above it) and its siblings
in the same source folder; then what ROS's own variables name (ROS_PACKAGE_PATH, and `share` of each
prefix in AMENT_PREFIX_PATH).  Only names are listed here; nothing is read but `package.xml`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

__all__ = ["packages_around"]

_NAME = re.compile(rb"<name>\s*([A-Za-z0-9_.-]+)\s*</name>")
#: A source folder with more entries is not searched for siblings: a home folder, say.
_MOST_SIBLINGS = 2000


def packages_around(file: Path) -> dict[str, Path]:
    """Package names and their folders, the nearer first where two bear one name."""
    found: dict[str, Path] = {}
    here = file.resolve()
    for folder in here.parents:
        if (folder / "package.xml").is_file():
            _add(found, folder)
            for sibling in _folders(folder.parent):
                _add(found, sibling)
            break
    for variable in ("ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"):
        for entry in os.environ.get(variable, "").split(os.pathsep):
            if entry:
                top = Path(entry) / "share" if variable == "AMENT_PREFIX_PATH" else Path(entry)
                _add(found, top)
                for folder in _folders(top):
                    _add(found, folder)
    return found


def _folders(top: Path) -> Iterator[Path]:
    try:
        entries = sorted(entry for entry in top.iterdir() if entry.is_dir())
    except OSError:
        return
    if len(entries) <= _MOST_SIBLINGS:
        yield from entries
        for entry in entries:  # repositories hold their packages one level deeper
            if not (entry / "package.xml").is_file() and not entry.name.startswith("."):
                try:
                    inner = sorted(x for x in entry.iterdir() if x.is_dir())
                except OSError:
                    continue
                if len(inner) <= 100:
                    yield from inner


def _add(found: dict[str, Path], folder: Path) -> None:
    manifest = folder / "package.xml"
    try:
        text = manifest.read_bytes()[:100_000] if manifest.is_file() else b""
    except OSError:
        return
    name = _NAME.search(text)
    if name:
        found.setdefault(name[1].decode("ascii"), folder)
