"""An MJCF file with its included files as one tree of elements, in which each keeps its place.

What MuJoCo tolerates is found here: a document type, and numbers that are not finite (MuJoCo only
warns).  What makes bodies by other means than `<body>` is left out, and said.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path, PurePosixPath

from ..._files import read_regular
from ..._finding import Place
from ..._rules.finding_log import FindingLog
from ..printed_numbers import plain_number
from ..xml.lined_text import LinedText
from ..xml.xml_numbers import xml_words
from ..xml.xml_tree import XmlError, XmlNode, parse_xml

__all__ = ["MjcfText", "numbers"]

_TURNS = ("quat", "axisangle", "xyaxes", "zaxis", "euler")
_NUMBERS = {
    "body": ("pos", *_TURNS, "gravcomp"),
    "frame": ("pos", *_TURNS),
    "inertial": ("pos", *_TURNS, "mass", "diaginertia", "fullinertia"),
    "joint": ("pos", "axis", "range", "actuatorfrcrange", "ref", "armature", "damping",
              "frictionloss", "stiffness"),
    "geom": ("pos", *_TURNS, "size", "mass", "density", "fromto"),
    "option": ("gravity", "density", "viscosity", "wind"),
}  # fmt: skip
_NOT_READ = {
    "composite": "makes many bodies",
    "flexcomp": "is soft",
    "flex": "is soft",
    "attach": "takes a body from another file",
    "model": "names another file",
    "plugin": "is code",
}
#: What an element unfolds into: the product of these attributes, and of the counts around it.
_SIZES = {
    "replicate": ("count",),
    "hfield": ("nrow", "ncol"),
    "texture": ("width", "height"),
}


class MjcfText:
    """text : for MuJoCo;  inputs : (name, SHA-256) of every file that was read, the given one first

    Raises XmlError where the given file is no XML.
    """

    def __init__(self, data: bytes, *, file: str, folder: Path, log: FindingLog) -> None:
        self.file, self.folder, self.log = file, folder, log
        self.inputs: list[tuple[str, str]] = []
        self.root = self._parsed(data, file)
        self._splice(self.root)
        self._check(self.root)
        # Memory reserved for the user's data or the simulation: no part of the model.
        self.root.children = [node for node in self.root.children if node.tag != "size"]
        self._lines = LinedText(self.root)
        self.text = self._lines.text

    def node(self, line: str) -> XmlNode | None:
        """The element at "line 12" in what MuJoCo says."""
        return self._lines.at(line)

    def place(self, line: str, element: str = "") -> Place:
        """Where the element at a line of MuJoCo's is written."""
        node = self.node(line)
        return Place(self.file, element=element) if node is None else node.place(None, element)

    def largest(self) -> tuple[XmlNode, float]:
        """The element that unfolds into the most entries, and how many."""
        found, most = self.root, 1.0
        stack = [(self.root, 1.0)]
        while stack:
            node, around = stack.pop()
            size = around
            for attribute in _SIZES.get(node.tag, ()):
                size *= _count(node.get(attribute))
            if size > most:
                found, most = node, size
            stack += [(child, size if node.tag == "replicate" else 1.0) for child in node.children]
        return found, most

    def _parsed(self, data: bytes, file: str) -> XmlNode:
        self.inputs.append((file, hashlib.sha256(data).hexdigest()))
        return parse_xml(data, file)

    def _splice(self, node: XmlNode) -> None:
        """Replace every `<include>` below by the included file's elements, as MuJoCo does."""
        children = []
        for child in node.children:
            if child.tag == "include":
                children += self._included(child)
            else:
                self._splice(child)
                children.append(child)
        node.children = children

    def _included(self, include: XmlNode) -> list[XmlNode]:
        name = include.get("file") or ""
        place = include.place("file" if name else None, "<include> file")
        if not name:
            self.log.add("XML104", "<include>", "names no file", place)
        elif any(name == known for known, _ in self.inputs):
            # MuJoCo allows one only, which also keeps files from including each other for ever.
            problem = f"{name!r} is read already: a file is included once"
            self.log.add("XML100", "<include>", problem, place, value=name)
        else:
            try:
                # MuJoCo looks from the main file's folder, wherever the <include> itself stands.
                inner = self._parsed(read_regular(self.folder / PurePosixPath(name)), name)
            except (OSError, ValueError):
                problem = f"the file {name!r} cannot be read"
                fix = "put it there: paths start from the folder of the main file"
                self.log.add("XML100", "<include> file", problem, place, value=name, fix=fix)
            except XmlError as error:
                place = Place(name, error.line, error.column)
                self.log.add("XML101", "<include>", error.problem, place)
            else:
                self._splice(inner)
                return inner.children
        return []

    def _check(self, root: XmlNode) -> None:
        stack: list[tuple[XmlNode, XmlNode | None]] = [(root, None)]
        while stack:
            node, above = stack.pop()
            kept = []
            for child in node.children:
                if child.tag in _NOT_READ and node.tag != "default":
                    problem = f"{_NOT_READ[child.tag]}: left out"
                    self.log.add("XML108", f"<{child.tag}>", problem, child.place())
                else:
                    kept.append(child)
            node.children = kept
            subject = _subject(node, above)
            for attribute in _NUMBERS.get(node.tag, ()):
                numbers(node, attribute, subject, self.log)
            stack += [(child, node) for child in reversed(node.children)]


def numbers(node: XmlNode, attribute: str, subject: str, log: FindingLog | None) -> list[float]:
    """An attribute's numbers, each with its text; none, and a finding, where one is no number."""
    text = node.get(attribute)
    try:
        return [plain_number(word) for word in xml_words(text or "")]
    except ValueError as error:
        if log is not None:
            problem = f"{attribute}={text!r} {error}"
            log.add("XML103", f"{subject} {attribute}", problem, node.place(attribute), value=text)
        return []


def _count(text: str | None) -> float:
    """A count as written; 1 where it is none, which MuJoCo itself refuses."""
    try:
        return max(1.0, float(text or 1))
    except ValueError:
        return 1.0


def _subject(node: XmlNode, above: XmlNode | None) -> str:
    """“body 'rod' inertial”."""
    if node.tag in ("body", "joint") or above is None or above.tag != "body":
        return _words(node)
    return f"{_words(above)} {node.tag}"


def _words(node: XmlNode) -> str:
    name = re.sub(r"\s+", " ", node.get("name") or "")
    return f"{node.tag} {name!r}" if name else f"<{node.tag}>"
