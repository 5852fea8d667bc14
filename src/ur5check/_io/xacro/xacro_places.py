"""From a place in an expanded xacro back to where it was written."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..._finding import Place
from ..ros_packages import PackageMap
from ..xml.xml_tree import XmlNode

__all__ = ["FileNames", "SourcePlaces"]

#: So many calls of macros are named that led to an element, the innermost first.
_CALLS = 3


class FileNames:
    """What a file that was read is called.

    robot : the robot file's path;  given : as reports call it
    """

    def __init__(self, robot: str, given: str, packages: PackageMap) -> None:
        self.robot, self.given, self.packages = robot, given, packages

    def of_input(self, file: str) -> str:
        """The same name on every machine: a package:// URI, or the path from the robot file."""
        for name, folders in self.packages.folders.items():
            for folder in folders:
                if Path(file).is_relative_to(folder):
                    return f"package://{name}/{Path(file).relative_to(folder).as_posix()}"
        return self.given if file == self.robot else self._beside(file)

    def of_place(self, file: str) -> str:
        """A path that an editor opens, for files of the robot's own package or folder."""
        if file == self.robot:
            return self.given
        home = Path(self.robot).parent
        own = [f for fs in self.packages.folders.values() for f in fs if home.is_relative_to(f)]
        if any(Path(file).is_relative_to(folder) for folder in (home, *own)):
            return os.path.normpath(Path(self.given).parent / self._beside(file))
        return self.of_input(file)

    def _beside(self, file: str) -> str:
        return os.path.relpath(file, Path(self.robot).parent)


class SourcePlaces:
    """Where each element of an expansion was written.

    table : as `xacro_origins.Origins.table` makes it;  label : of the expanded text

    Raises ValueError, TypeError, KeyError or IndexError for a table that is none.
    """

    def __init__(self, table: Mapping[str, Any], names: FileNames) -> None:
        files = [names.of_place(str(file)) for file in table["files"]]
        calls: list[tuple[Place, ...]] = []
        for file, line, column, call, tag in table["calls"]:
            outer = () if call < 0 else calls[call]
            place = Place(files[file], int(line), int(column), f"<{tag}>")
            calls.append((place, *outer)[:_CALLS])
        self.places = [
            Place(files[file], int(line), int(column), "", () if call < 0 else calls[call])
            for file, line, column, call in table["elements"]
        ]

    def attach(self, root: XmlNode) -> None:
        """Give each element of the expanded text its place.  Raises ValueError if it has others."""
        for node, place in zip(root.walk(), self.places, strict=True):
            node.source = place
