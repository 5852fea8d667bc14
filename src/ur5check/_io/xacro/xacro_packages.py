"""`$(find NAME)` of a package that is not known: an error only where the robot needs it.

Configuration of simulators and controllers names packages that a description is read without.  So
the expression stands for itself, until a file of the package is opened or it remains in a part of
the robot that is read.
"""

from __future__ import annotations

import re
import xml.dom.minidom
from collections.abc import Iterator, Sequence

from ..._errors import ModelError
from ..suggestions import did_you_mean

__all__ = ["PackageFolders", "UnknownPackageError"]

#: Elements of a URDF that describe no body and no joint.
_CONFIGURATION = ("gazebo", "ros2_control", "transmission")
_FIND = re.compile(r"\$\(find ([^)]*)\)")


class UnknownPackageError(Exception):
    """explained : what is wrong;  snippet, files : the text, and the files that it may stand in"""

    def __init__(self, explained: ModelError, snippet: str, files: Sequence[str]) -> None:
        super().__init__(str(explained))
        self.explained, self.snippet, self.files = explained, snippet, list(files)


class PackageFolders:
    """packages : names and their folders, the first one counts first"""

    def __init__(self, packages: dict[str, list[str]]) -> None:
        self.packages = packages
        self._unknown: dict[str, UnknownPackageError] = {}

    def find(self, name: str, snippet: str, files: Sequence[str]) -> str:
        """The package's first folder, or the expression itself."""
        if name in self.packages:
            return self.packages[name][0]
        error = ModelError(
            f"package {name!r} is not known",
            fix=f"pass --package {name}=DIR ({did_you_mean(name, self.packages)})",
            element=f"$(find {name})",
            rule="XAC101",
        )
        self._unknown.setdefault(name, UnknownPackageError(error, snippet, files))
        return f"$(find {name})"

    def check(self, text: str) -> None:
        """Raise UnknownPackageError where a text holds the folder of an unknown package."""
        for name in _FIND.findall(text) if self._unknown else ():
            if name in self._unknown:
                raise self._unknown[name]

    def check_robot(self, document: xml.dom.minidom.Document) -> None:
        """`check` of all that describes the robot."""
        root = document.documentElement
        for text in _texts(root) if self._unknown and root is not None else ():
            self.check(text)


def _texts(element: xml.dom.minidom.Element) -> Iterator[str]:
    """Attributes and texts of an element and all below it, except configuration."""
    elements = [element]
    while elements:
        element = elements.pop()
        yield from (str(value) for _, value in element.attributes.items())
        for child in element.childNodes:
            if child.nodeType == child.TEXT_NODE:
                yield str(child.data)
            elif child.nodeType == child.ELEMENT_NODE and child.tagName not in _CONFIGURATION:
                elements.append(child)
