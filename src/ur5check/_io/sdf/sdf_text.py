"""Strict reading of an SDF: one model, and the masses and inertias of its links.

SDFormat has defaults that are rarely intended: a link without `<inertial>` has 1 kg and 1 kg m²
about each axis.  libsdformat fills them in without a warning, so they are looked for in the text
first.  Poses (relative to frames, joints relative to links) are left to libsdformat; masses
and inertias are read here, with every digit.
"""

from __future__ import annotations

import math
import re
from typing import NoReturn

import numpy as np

from ..._errors import ModelError
from ..._robot import STANDARD_GRAVITY, Inertia, Transform
from ..inertia_checks import Place, check_inertia, printed_tensor
from ..printed_numbers import Printed
from ..xml.safe_xml import checked_root
from ..xml.xml_numbers import Element, ElementReader
from ..xml.xml_places import Places

__all__ = ["SdfText"]

_ENTRIES = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_NOT_READ = ("visual", "collision", "sensor", "plugin", "light", "actor", "gui", "scene", "physics")
_WORLD_GRAVITY = (0.0, 0.0, -9.8)  # SDFormat's own default for a <world>
_OLDEST = (1, 4)


class SdfText:
    """The only model of an SDF file."""

    def __init__(self, data: bytes, file: str) -> None:
        self.reader = ElementReader(file)
        self.root = checked_root(data, file)
        self._check_root()
        self.world, self.model = self._only_model()
        self.name = self.reader.name(self.model)
        self.links = self._named("link")
        self.joints = self._named("joint")
        self._inertials = {
            name: self.reader.child(link, "inertial", f"link {name!r}")
            for name, link in self.links.items()
        }
        for name, joint in self.joints.items():
            self._check_joint(name, joint)
        # Drake computes poses only; without these parts it neither refuses nor warns about them.
        for node in list(self.root.iter("inertial", *_NOT_READ)):
            node.getparent().remove(node)
        gravity = None if self.world is None else self.world.find("gravity")
        self._gravity = gravity
        if self.world is not None and gravity is not None:
            # Drake has its own gravity and only warns that it does not take the file's.
            self.world.remove(gravity)
        self._places = Places(self.root)
        self.text = self._places.text

    def gravity(self) -> tuple[tuple[float, ...], tuple[str, ...]]:
        """In the world's frame [m/s²], and a note where it is SDFormat's default."""
        if self.world is None:
            return STANDARD_GRAVITY, ()
        if self._gravity is None:
            return _WORLD_GRAVITY, ("the world names no gravity: SDFormat's is 9.8 m/s²",)
        return tuple(self._numbers(self._gravity, "<world> gravity", 3)), ()

    def inertia(self, name: str) -> Inertia:
        """A moving link's inertia, in the link's frame.  Raises ModelError for a default."""
        link, subject = self.links[name], f"link {name!r}"
        inertial = self._inertials[name]
        if (link.findtext("gravity") or "true").strip().lower() in ("false", "0"):
            fix = "remove <gravity>: no arm on earth has a link without weight"
            self.reader.fail(link, subject, "has its gravity switched off", fix)
        if inertial is None:
            problem = "moves and has no <inertial>: SDFormat would give it 1 kg and 1 kg m²"
            fix = "write its <inertial>; a mere frame is a <frame>, not a link"
            self.reader.fail(link, subject, problem, fix)
        subject += " inertial"
        if (inertial.get("auto") or "false").strip().lower() in ("true", "1"):
            fix = "write <mass> and <inertia>"
            self.reader.fail(inertial, subject, "is to be made from shapes (auto)", fix)
        mass_node = self._part(inertial, "mass", subject, "1 kg")
        inertia_node = self._part(inertial, "inertia", subject, "1 kg m²")
        (mass,) = self._numbers(mass_node, f"{subject}/mass", 1)
        entries = {}
        for entry in _ENTRIES:
            default = "1 kg m²" if entry[1] == entry[2] else "0"
            node = self._part(inertia_node, entry, f"{subject}/inertia", default)
            (entries[entry],) = self._numbers(node, f"{subject}/inertia/{entry}", 1)
        tensor, digits = printed_tensor(entries)
        place = Place(
            self.reader.file, f"{subject}/", mass_node.sourceline, inertia_node.sourceline
        )
        check_inertia(mass, tensor, place, digits=digits, point_mass=True)
        own = Inertia(mass, np.zeros(3), tensor, digits)
        return own.expressed_in(self._pose(inertial, subject))

    def losses(self, joint: str) -> tuple[float, float]:
        """A joint's damping and friction; zero where the file names none."""
        node = self.joints[joint].find("axis/dynamics")
        given = {key: self._optional(node, key, joint) for key in ("damping", "friction")}
        return given["damping"], given["friction"]

    def fail(
        self,
        node: Element,
        element: str | None,
        problem: str,
        fix: str,
        value: object = None,
        rule: str = "XML100",
    ) -> NoReturn:
        """Raise ModelError at an element."""
        self.reader.fail(node, element, problem, fix, value, rule)

    def warnings_of_drake(self, error: Exception) -> ModelError:
        """Drake's refusal as a ModelError."""
        said = str(error)
        found = re.search(r"\.sdf:(\d+)", said)
        node = self._places.at(int(found[1])) if found else None
        return ModelError(
            f"Drake cannot take it: {self.in_our_words(said)}",
            fix="correct it by http://sdformat.org/spec",
            file=self.reader.file,
            line=None if node is None else node.sourceline,
        )

    @staticmethod
    def in_our_words(said: str) -> str:
        """One line, without the place, which refers to the rewritten text."""
        line = " ".join(said.split())
        return re.sub(r"^(<[\w-]+>(\.sdf)?(:\d+)?: *)?((error|warning): *)?", "", line).rstrip(".")

    def _check_root(self) -> None:
        if self.root.tag != "sdf":
            fix = "an SDF file's root is <sdf version=…>"
            self.fail(self.root, f"<{self.root.tag}>", "the root element is not SDF's", fix)
        version = self.root.get("version") or ""
        numbers = re.fullmatch(r"(\d+)\.(\d+)", version)
        if numbers is None or (int(numbers[1]), int(numbers[2])) < _OLDEST:
            fix = 'write version="1.4" or later'
            self.fail(self.root, "<sdf> version", "is too old or none", fix, version or None)

    def _only_model(self) -> tuple[Element | None, Element]:
        for tag in ("include", "model/model", "world/model/model"):
            node = self.root.find(f".//{tag}" if tag == "include" else tag)
            if node is not None:
                fix = "write the model out flat, in one file (gz sdf --print does)"
                self.fail(node, f"<{node.tag}>", "is not followed", fix)
        models = [*self.root.findall("model"), *self.root.findall("world/model")]
        if len(models) != 1:
            node = models[1] if models else self.root
            fix = "keep the arm's model alone"
            self.fail(node, "<sdf>", f"holds {len(models)} models", fix)
        world = self.root.find("world")
        return world, models[0]

    def _named(self, tag: str) -> dict[str, Element]:
        named: dict[str, Element] = {}
        for node in self.model.findall(tag):
            name = self.reader.name(node)
            if name in named:
                problem = f"appears twice, first in line {named[name].sourceline}"
                self.fail(node, f"{tag} {name!r}", problem, "give each its own name")
            named[name] = node
        return named

    def _check_joint(self, name: str, joint: Element) -> None:
        subject = f"joint {name!r}"
        axis = self.reader.child(joint, "axis", subject)
        if axis is None:
            return
        xyz = self.reader.child(axis, "xyz", subject)
        if xyz is not None and not any(self._numbers(xyz, f"{subject} axis", 3)):
            self.fail(
                xyz, f"{subject} axis", "is zero", "write a direction, such as 0 0 1", xyz.text
            )
        limit = self.reader.child(axis, "limit", subject)
        if limit is not None:
            values = {}
            for node in limit.iterchildren("lower", "upper", "effort", "velocity"):
                (values[node.tag],) = self._numbers(node, f"{subject} limit {node.tag}", 1)
            if values.get("lower", -math.inf) > values.get("upper", math.inf):
                self.fail(limit, f"{subject} limit", "lower exceeds upper", "swap them")

    def _part(self, node: Element, tag: str, subject: str, default: str) -> Element:
        part = self.reader.child(node, tag, subject)
        if part is None:
            problem = f"has no <{tag}>: SDFormat would give it {default}"
            self.fail(node, subject, problem, f"write <{tag}>")
        return part

    def _optional(self, node: Element | None, tag: str, joint: str) -> float:
        part = None if node is None else self.reader.child(node, tag, f"joint {joint!r}")
        if part is None:
            return 0.0
        (value,) = self._numbers(part, f"joint {joint!r} dynamics {tag}", 1)
        return value

    def _pose(self, node: Element, subject: str) -> Transform:
        pose = self.reader.child(node, "pose", subject)
        if pose is None:
            return Transform.identity()
        subject += " pose"
        if pose.get("relative_to"):
            self.fail(pose, subject, "is relative to another frame", "write it in the link's frame")
        if pose.get("rotation_format", "euler_rpy") == "quat_xyzw":
            x, y, z, *xyz_w = self._numbers(pose, subject, 7)
            return Transform.from_quaternion((x, y, z), (xyz_w[3], *xyz_w[:3]))
        x, y, z, *rpy = self._numbers(pose, subject, 6)
        in_degrees = (pose.get("degrees") or "false").strip().lower() in ("true", "1")
        return Transform.from_rpy((x, y, z), [math.radians(a) for a in rpy] if in_degrees else rpy)

    def _numbers(self, node: Element, subject: str, count: int) -> list[Printed]:
        return self.reader.text_numbers(node, subject, count)
