"""An SDF's elements: the one model that is read, its numbers, and the text that Drake gets.

SDFormat has defaults that are rarely intended: a link without `<inertial>` has 1 kg and 1 kg m²
about each axis.  libsdformat fills them in without a warning, so they are looked for here.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

import numpy as np

from ..._finding import Place
from ..._robot.robot import ENTRIES, Inertial, ShapeRef
from ..._robot.serial_arm import STANDARD_GRAVITY
from ..._robot.transforms import Array, Transform
from ..._rules.finding_log import FindingLog
from ..number_text import roll_pitch_yaw
from ..printed_numbers import common_rounding, plain_number
from ..xml.lined_text import LinedText
from ..xml.xml_numbers import xml_words
from ..xml.xml_tree import XmlNode

__all__ = ["SdfText", "child", "number", "numbers"]

#: Drake computes poses only; without these parts it neither refuses nor warns about them.
_NOT_FOR_DRAKE = {
    "inertial", "visual", "collision", "sensor", "plugin", "light", "actor", "gui", "scene",
    "physics", "mimic", "gravity",
}  # fmt: skip
_WORLD_GRAVITY = (0.0, 0.0, -9.8)  # SDFormat's own default for a <world>
_OLDEST = (1, 4)
_NAN = math.nan


def child(node: XmlNode | None, *path: str) -> XmlNode | None:
    """The first element along a path of tags."""
    for tag in path:
        node = None if node is None else next(node.all(tag), None)
    return node


def number(node: XmlNode | None, tag: str, subject: str, log: FindingLog) -> float | None:
    """A child's number; None where there is no such child, nan with a finding where it is none."""
    part = child(node, tag)
    if part is None:
        return None
    return numbers(part, 1, f"{subject} {tag}", log)[0]


class SdfText:
    """links, joints : elements of the model, by name;  model : None where there is none to read"""

    def __init__(self, root: XmlNode, log: FindingLog) -> None:
        self.root, self.log = root, log
        self.links: dict[str, XmlNode] = {}
        self.joints: dict[str, XmlNode] = {}
        self._check_version()
        self._leave_out(root)
        self.world, self.model = self._model()
        if self.model is not None:
            self.links, self.joints = self._named("link"), self._named("joint")

    def for_drake(self, left_out: Iterable[XmlNode], axes: Iterable[XmlNode]) -> LinedText:
        """The model without some elements, and without what is read here.

        left_out : joints and limits that Drake would stop at;  axes : that are none, made z
        """
        gone = {id(node) for node in left_out}
        straight = {id(node) for node in axes}

        def copy(node: XmlNode) -> XmlNode:
            text = "0 0 1" if id(node) in straight else node.text
            kept = [
                copy(each)
                for each in node.children
                if id(each) not in gone and each.tag not in _NOT_FOR_DRAKE
            ]
            return XmlNode(node.tag, node.attributes, node.file, node.offset, kept, text)

        return LinedText(copy(self.root))

    def gravity(self) -> tuple[tuple[float, ...], tuple[str, ...]]:
        """In the world's frame [m/s²], and a note where it is SDFormat's default."""
        if self.world is None:
            return STANDARD_GRAVITY, ()
        node = child(self.world, "gravity")
        if node is None:
            return _WORLD_GRAVITY, ("the world names no gravity: SDFormat's is 9.8 m/s²",)
        given = numbers(node, 3, "<world> gravity", self.log)
        return (tuple(given), ()) if all(map(math.isfinite, given)) else (STANDARD_GRAVITY, ())

    def inertial(self, name: str, *, moves: bool) -> Inertial | None:
        """A link's inertial, nan where a number is missing; None where it has none and stands."""
        link, subject, log = self.links[name], f"link {name!r}", self.log
        node = child(link, "inertial")
        if node is None:
            if not moves:
                return None
            problem = "moves and has no <inertial>: SDFormat gives it 1 kg and 1 kg m²"
            fix = "write its <inertial>; a mere frame is a <frame>, not a link"
            log.add("XML104", subject, problem, link.place("name", subject), fix=fix)
            return _unknown(link.place("name", subject))
        if len(list(link.all("inertial"))) > 1:
            log.add("XML105", subject, "has several <inertial> elements", node.place())
        where = f"{subject} inertial"
        if _true(node.get("auto")):
            problem = "is to be made from shapes (auto)"
            log.add("XML108", where, problem, node.place(), fix="write <mass> and <inertia>")
            return _unknown(node.place())
        places = {"inertial": node.place(None, where)}
        mass = self._required(node, "mass", where, "1 kg", places)
        tensor = child(node, "inertia")
        entries = dict.fromkeys(ENTRIES, _NAN)
        if tensor is None:
            problem = "has no <inertia>: SDFormat gives it 1 kg m² about each axis"
            log.add("XML104", where, problem, node.place())
        else:
            places["inertia"] = tensor.place(None, f"{where}/inertia")
            for entry in ENTRIES:
                default = "1 kg m²" if entry[1] == entry[2] else "0"
                inside = f"{where}/inertia"
                entries[entry] = self._required(tensor, entry, inside, default, places)
        xyz, rpy = self._pose(node, where, places)
        return Inertial(mass, xyz, rpy, entries, common_rounding(entries), places)

    def shapes(self, name: str) -> tuple[ShapeRef, ...]:
        """A link's shapes; none where one is not of a kind known here: the rest is too little."""
        found = []
        for node in self.links[name].all("collision", "visual"):
            subject = f"link {name!r} {node.tag}"
            geometry = child(node, "geometry")
            solid = None if geometry is None or not geometry.children else geometry.children[0]
            quiet = FindingLog()
            xyz, rpy = self._pose(node, subject, {}, quiet)
            size = () if solid is None else _size(solid, quiet)
            if solid is None or not size or quiet.findings:
                return ()
            uri = child(solid, "uri")
            found.append(
                ShapeRef(
                    "collision" if node.tag == "collision" else "visual",
                    solid.tag,
                    size,
                    Transform.from_rpy(xyz, rpy.tolist()),
                    "" if uri is None else uri.text.strip(),
                    solid.place(None, subject),
                )
            )
        return tuple(found)

    def _check_version(self) -> None:
        version = self.root.get("version") or ""
        parts = re.fullmatch(r"(\d+)\.(\d+)", version)
        if parts is None or (int(parts[1]), int(parts[2])) < _OLDEST:
            place = self.root.place("version" if version else None)
            fix = 'write version="1.4" or later'
            self.log.add("XML100", "<sdf> version", "is too old or none", place, fix=fix)

    def _leave_out(self, root: XmlNode) -> None:
        """Elements that stand for other models."""
        stack = [root]
        while stack:
            node = stack.pop()
            kept = []
            for each in node.children:
                if each.tag == "include" or (each.tag == "model" and node.tag == "model"):
                    fix = "write the model out flat, in one file (gz sdf --print does)"
                    problem = "is not followed: left out"
                    self.log.add("XML108", f"<{each.tag}>", problem, each.place(), fix=fix)
                else:
                    kept.append(each)
            node.children = kept
            stack += kept

    def _model(self) -> tuple[XmlNode | None, XmlNode | None]:
        """The model with the most joints; another one is a finding, also where it has none."""
        world = child(self.root, "world")
        holders = [self.root, *self.root.all("world")]
        models = [(model, holder) for holder in holders for model in holder.all("model")]
        if not models:
            self.log.add("TRE105", "<sdf>", "holds no model", self.root.place())
            return world, None
        model, holder = max(models, key=lambda pair: len(list(pair[0].all("joint"))))
        for other, above in models:
            if other is model:
                continue
            severity = "error" if any(other.all("joint")) else "note"
            problem = f"the file holds {len(models)} models, and this one is left out"
            subject = f"model {other.get('name')!r}"
            fix = "keep the arm's model alone"
            self.log.add("XML108", subject, problem, other.place(), severity=severity, fix=fix)
            above.children = [each for each in above.children if each is not other]
        return (None if holder is self.root else holder), model

    def _named(self, tag: str) -> dict[str, XmlNode]:
        named: dict[str, XmlNode] = {}
        assert self.model is not None  # noqa: S101 - for the type checker
        for node in list(self.model.all(tag)):
            name = (node.get("name") or "").strip()
            if name and name not in named:
                named[name] = node
                continue
            if name:
                problem = f"appears twice, first in line {named[name].place().line}"
                self.log.add("TRE101", f"{tag} {name!r}", problem, node.place("name"))
            else:
                self.log.add("XML104", f"<{tag}>", f"a <{tag}> has no name", node.place())
            self.model.children.remove(node)
        return named

    def _required(
        self, node: XmlNode, tag: str, where: str, default: str, places: dict[str, Place]
    ) -> float:
        value = number(node, tag, where, self.log)
        if value is None:
            problem = f"has no <{tag}>: SDFormat gives it {default}"
            self.log.add("XML104", where, problem, node.place())
            return _NAN
        part = child(node, tag)
        if part is not None:
            places[tag] = part.place(None, f"{where}/{tag}")
        return value

    def _pose(
        self, node: XmlNode, subject: str, places: dict[str, Place], log: FindingLog | None = None
    ) -> tuple[Array, Array]:
        """Position [m] and roll, pitch, yaw [rad]; nan where they are not known here."""
        log = log or self.log
        pose = child(node, "pose")
        if pose is None:
            return np.zeros(3), np.zeros(3)
        subject += " pose"
        places["origin"] = pose.place(None, subject)
        unknown = np.full(3, _NAN), np.full(3, _NAN)
        if pose.get("relative_to"):
            fix = "write it in the link's frame"
            log.add("XML108", subject, "is relative to another frame", pose.place(), fix=fix)
            return unknown
        if pose.get("rotation_format") == "quat_xyzw":
            given = np.array(numbers(pose, 7, subject, log))
            if not np.isfinite(given).all() or not given[3:].any():
                return unknown
            R = Transform.from_quaternion(np.zeros(3), given[[6, 3, 4, 5]]).R
            return given[:3], np.array(roll_pitch_yaw(R))
        given = np.array(numbers(pose, 6, subject, log))
        in_degrees = _true(pose.get("degrees"))
        return given[:3], np.radians(given[3:]) if in_degrees else given[3:]


def numbers(node: XmlNode, count: int, subject: str, log: FindingLog) -> list[float]:
    """An element's own text: `count` plain numbers, or nan and a finding."""
    words = xml_words(node.text)
    try:
        values: list[float] = [plain_number(word) for word in words]
        problem = f"takes {count} number{'s' if count > 1 else ''}, not {len(values)}"
    except ValueError as error:
        values, problem = [], str(error)
    if len(values) == count:
        return values
    log.add("XML103", subject, f"{node.text!r} {problem}", node.place(), value=node.text)
    return [_NAN] * count


def _size(solid: XmlNode, log: FindingLog) -> tuple[float, ...]:
    """As in `ShapeRef`; empty for another kind of shape."""
    if solid.tag == "mesh":
        scale = child(solid, "scale")
        return (1.0, 1.0, 1.0) if scale is None else tuple(numbers(scale, 3, "scale", log))
    if solid.tag == "box":
        size = child(solid, "size")
        return () if size is None else tuple(numbers(size, 3, "size", log))
    keys = {
        "sphere": ("radius",),
        "cylinder": ("radius", "length"),
        "capsule": ("radius", "length"),
    }
    given = [number(solid, key, solid.tag, log) for key in keys.get(solid.tag, ())]
    return tuple(value for value in given if value is not None) if None not in given else ()


def _unknown(place: Place) -> Inertial:
    nan = np.full(3, _NAN)
    return Inertial(_NAN, nan, nan, dict.fromkeys(ENTRIES, _NAN), places={"inertial": place})


def _true(text: str | None) -> bool:
    return (text or "false").strip().lower() in ("true", "1")
