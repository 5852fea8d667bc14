"""An MJCF file and its included files as one text, in which every element keeps its place.

MuJoCo reads the text; what it tolerates is refused here first: a document type, numbers that are
not finite (MuJoCo only warns), a swapped range (MuJoCo ignores the range).
Files other than
included ones are not read: an arm is determined by the files that were read and hashed.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path, PurePosixPath
from typing import NoReturn

from lxml import etree

from ..._errors import ModelError
from ..._files import read_regular
from ..inertia_checks import Place, check_inertia, printed_tensor
from ..xml.safe_xml import checked_root
from ..xml.xml_numbers import Element, ElementReader
from ..xml.xml_places import Places

__all__ = ["MjcfText"]

_NUMBERS = {
    "body": ("pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "gravcomp"),
    "frame": ("pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"),
    "inertial": ("pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "mass", "diaginertia",
                 "fullinertia"),
    "joint": ("pos", "axis", "range", "actuatorfrcrange", "ref", "armature", "damping",
              "frictionloss", "stiffness"),
    "geom": ("pos", "quat", "size", "mass", "density", "fromto"),
    "option": ("gravity", "density", "viscosity", "wind"),
}  # fmt: skip
#: Attributes whose product is the number of entries that an element unfolds into.
_SIZES = {"hfield": ("nrow", "ncol"), "texture": ("width", "height")}
_MOST_ENTRIES = 1_000_000
#: Elements that all <replicate>s make; MuJoCo's time to remove so many shapes again is seconds.
_MOST_REPLICATED = 2_000

_RANGES = ("range", "actuatorfrcrange", "ctrlrange", "forcerange")
_NO_BODIES = {
    "composite": "makes many bodies",
    "flexcomp": "is soft",
    "flex": "is soft",
    "attach": "takes a body from another file",
    "model": "names another file",
    "plugin": "is code",
}
_LINE = re.compile(r"\bline (\d+)")


class MjcfText:
    """read : (name, bytes) of every file, the given one first."""

    def __init__(self, data: bytes, *, file: str, folder: Path) -> None:
        self.file, self.folder = file, folder
        self.read: list[tuple[str, bytes]] = []
        # Elements of included files; keeping them keeps lxml from making new objects for them.
        self._homes: dict[Element, str] = {}
        root = self._parsed(data, file)
        if root.tag != "mujoco":
            fix = "an MJCF file's root is <mujoco>, a URDF's is <robot>"
            self.fail(root, f"<{root.tag}>", "the root element is not MJCF's", fix, root.tag)
        for include in list(root.iter("include")):
            self._splice(include)
        self.root = root
        self._check_elements()
        # Memory reserved for the user's data or the simulation: no part of the model.
        for node in list(root.iterchildren("size")):
            root.remove(node)
        self._places = Places(root)
        self.text = self._places.text

    @property
    def inputs(self) -> tuple[tuple[str, str], ...]:
        """(name, SHA-256) of every file that was read."""
        return tuple((name, hashlib.sha256(data).hexdigest()) for name, data in self.read)

    def fail(
        self, node: Element, element: str | None, problem: str, fix: str, value: object = None
    ) -> NoReturn:
        """Raise ModelError at an element, in the file where it stands."""
        ElementReader(self._home(node)).fail(node, element, problem, fix, value)

    def place(self, info: str) -> tuple[str, int | None]:
        """File and line of "line 12" in a message of MuJoCo."""
        found = _LINE.search(info)
        node = self._places.at(int(found[1])) if found else None
        return (self.file, None) if node is None else (self._home(node), node.sourceline)

    def warnings_of_mujoco(self, error: Exception) -> ModelError:
        """MuJoCo's error as a ModelError."""
        file, line = self.place(str(error))
        first, *rest = str(error).strip().splitlines()
        problem = re.sub(r"^((XML )?Error: )+", "", first)
        element = re.search(r"Element (?:name )?'([^']+)'", " ".join(rest))
        fix = "correct it by MuJoCo's XML reference"
        if "mjMINVAL" in problem:
            fix = "give the body an <inertial>, or shapes with mass"
        return ModelError(
            f"MuJoCo cannot take it: {problem}",
            fix=fix,
            file=file,
            line=line,
            element=f"{element[1]!r}" if element else None,
        )

    def bytes_of(self, name: str, wanted_by: str) -> bytes:
        """A file beside the model, read once and remembered.  wanted_by : for the error."""
        try:
            data = read_regular(self.folder / name)
        except OSError as error:
            problem = f"needs {name!r}, which cannot be read: {error.strerror}"
            fix = "put the file there, or give every moving body an <inertial>"
            raise ModelError(problem, fix=fix, file=self.file, element=wanted_by) from None
        self.read.append((name, data))
        return data

    def _parsed(self, data: bytes, file: str) -> Element:
        self.read.append((file, data))
        return checked_root(data, file)

    def _splice(self, include: Element) -> None:
        """Replace `<include>` by the included file's elements, as MuJoCo does."""
        name = include.get("file")
        if not name:
            self.fail(include, "<include>", "names no file", 'write <include file="…"/>')
        # MuJoCo looks from the folder of the main file, wherever the <include> itself stands.
        if any(name == known for known, _ in self.read):
            self.fail(include, "<include>", "is read already", "include a file once", name)
        try:
            data = read_regular(self.folder / PurePosixPath(name))
        except (OSError, ValueError):
            fix = "put it there: paths start from the folder of the main file"
            self.fail(include, "<include> file", "cannot be read", fix, name)
        inner = self._parsed(data, name)
        for node in inner.iter(etree.Element):
            self._homes[node] = name
        deeper = list(inner.iter("include"))
        parent = include.getparent()
        at = parent.index(include)
        for offset, child in enumerate(list(inner)):
            parent.insert(at + offset, child)
        parent.remove(include)
        for node in deeper:
            self._splice(node)

    def _home(self, node: Element) -> str:
        return self._homes.get(node, self.file)

    def _check_elements(self) -> None:
        replicated = 0.0
        for node in self.root.iter(etree.Element):
            if next(node.iterancestors("replicate"), None) is not None:
                replicated += _repeats(node)
            if replicated > _MOST_REPLICATED:
                around = next(node.iterancestors("replicate"))
                problem = f"makes {replicated:,.0f} elements, more than {_MOST_REPLICATED:,}"
                self.fail(around, "<replicate>", problem, "lower its count, or leave it out")
            self._check_size(node)
            if node.tag in _NO_BODIES and node.getparent().tag != "default":
                fix = "write rigid bodies out (MuJoCo's spec.to_xml() does), or remove it"
                problem = f"{_NO_BODIES[node.tag]}: no rigid body that can be read here"
                self.fail(node, f"<{node.tag}>", problem, fix)
            reader = ElementReader(self._home(node))
            subject = _named(node)
            for attribute in _NUMBERS.get(node.tag, ()):
                if attribute in node.attrib:
                    reader.numbers(node, attribute, subject)
            for attribute in _RANGES:
                self._check_range(node, attribute, reader, subject)
            if node.tag == "inertial":
                _check_inertial(node, reader, subject)

    def _check_size(self, node: Element) -> None:
        """Refuse what MuJoCo would unfold into more memory than a description needs."""
        size = _repeats(node)
        for attribute in _SIZES.get(node.tag, ()):
            size *= _whole(node.get(attribute))
        if size > _MOST_ENTRIES:
            problem = f"stands for {size:,.0f} entries, more than {_MOST_ENTRIES:,}"
            self.fail(node, f"<{node.tag}>", problem, "make it smaller, or leave it out")

    def _check_range(
        self, node: Element, attribute: str, reader: ElementReader, subject: str
    ) -> None:
        if node.tag not in ("joint", "motor", "general", "position", "velocity"):
            return
        values = reader.numbers(node, attribute, subject) if attribute in node.attrib else ()
        if len(values) == 2 and values[0] > values[1]:
            problem = "lower exceeds upper, so that MuJoCo ignores the limit"
            self.fail(node, f"{subject} {attribute}", problem, "swap them", node.get(attribute))


def _repeats(node: Element) -> float:
    """How often an element stands in the model, by the <replicate> elements around it."""
    count = 1.0
    around = [node, *node.iterancestors("replicate")]
    for replicate in (each for each in around if each.tag == "replicate"):
        count *= _whole(replicate.get("count"))
    return count


def _whole(text: str | None) -> float:
    """A count as written; 1 where it is none, which MuJoCo itself refuses."""
    try:
        return max(1.0, float(text or 1))
    except ValueError:
        return 1.0


def _check_inertial(node: Element, reader: ElementReader, subject: str) -> None:
    mass = reader.number(node, "mass", subject)
    key, names = "fullinertia", ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]
    if key not in node.attrib:
        key, names = "diaginertia", names[:3]
    if key not in node.attrib:
        fix = 'write fullinertia="xx yy zz xy xz yz" or diaginertia="xx yy zz"'
        reader.fail(node, subject, "has no inertia", fix)
    entries = reader.numbers(node, key, subject)
    if len(entries) != len(names):
        problem = f"takes {len(names)} numbers, not {len(entries)}"
        reader.fail(node, f"{subject} {key}", problem, "write them all", node.get(key))
    products = {"ixy": 0.0, "ixz": 0.0, "iyz": 0.0}
    tensor, digits = printed_tensor(products | dict(zip(names, entries, strict=True)))
    line = node.sourceline
    check_inertia(mass, tensor, Place(reader.file, f"{subject}/", line, line), digits=digits)


def _named(node: Element) -> str:
    """“body 'rod' inertial”, for errors."""
    above = node.getparent()
    if node.tag in ("body", "joint") or above is None or above.tag != "body":
        return _words(node)
    return f"{_words(above)} {node.tag}"


def _words(node: Element) -> str:
    return f"{node.tag} {node.get('name')!r}" if node.get("name") else f"<{node.tag}>"
