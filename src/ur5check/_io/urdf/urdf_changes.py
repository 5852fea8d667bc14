"""A URDF's text with the numbers of another arm in it, and nothing else changed.

Comments, order, shapes and formatting stay: each number is replaced between the quotes of its
attribute, a number of a list by itself.  A joint's or link's number that stays the same within
rounding keeps its text.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..._finding import Place
from ..._robot.inertia import Inertia
from ..._robot.robot import ENTRIES, Inertial, Robot
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from ..number_text import as_written, exact
from ..round_trip import rpy_pose
from ..xml.xml_tree import XmlNode, parse_xml

__all__ = ["ChangedUrdf", "NumberChange", "changed_urdf"]

#: Part of the largest number involved that a number may move by changes of frame: a few ε each.
_ROUNDING = 1e-13

_NUMBER = re.compile(rb"[^ \t\r\n]+")


@dataclass(frozen=True)
class NumberChange:
    """One attribute whose numbers change.

    link : from 1; 0 for the base;  quantity : "mass", "centre", "tensor", "link_vector", "rotation"
    place : of the value, where a person wrote it;  what : "link 'forearm' mass", "… izz"
    old : as written, "" where the attribute is left out;  new : in its place
    """

    link: int
    quantity: str
    place: Place
    what: str
    old: str
    new: str


@dataclass(frozen=True)
class ChangedUrdf:
    """text : the whole;  changes : in the order of the arm
    unwritten : links, from 1 (0 for the base), whose numbers cannot be replaced, and why
    """

    text: str
    changes: tuple[NumberChange, ...]
    unwritten: tuple[tuple[int, str], ...]


def changed_urdf(arm: SerialArm, other: SerialArm) -> ChangedUrdf | None:
    """The text that `arm` was read from, changed to that of `other`.

    other : the same links and joints, with other inertias or fixed transforms

    None where the arm was not read from a URDF or xacro.  Of a xacro it is the expanded text.
    """
    robot, text = arm.source.robot, arm.source.urdf
    if robot is None or text is None:
        return None
    return _Changes(robot, arm, other, text.encode()).result()


@dataclass(frozen=True)
class _Edit:
    start: int
    end: int
    new: bytes


@dataclass(frozen=True)
class _Numbers:
    """Numbers of one attribute: whose they are, where they are written, what they shall be.

    error : how far each may be off and is the same
    """

    link: int
    quantity: str
    what: str
    place: Place
    values: Sequence[float]
    error: float

    def change(self, place: Place, old: str, new: str) -> NumberChange:
        return NumberChange(self.link, self.quantity, place, self.what, old, new)


class _Changes:
    def __init__(self, robot: Robot, arm: SerialArm, other: SerialArm, data: bytes) -> None:
        self.robot, self.arm, self.other, self.data = robot, arm, other, data
        root = parse_xml(data, robot.file)
        self.links = {(node.get("name") or "").strip(): node for node in root.all("link")}
        self.joints = {(node.get("name") or "").strip(): node for node in root.all("joint")}
        self.edits: list[_Edit] = []
        self.new_origins: dict[int, str] = {}
        self.changes: list[NumberChange] = []
        self.unwritten: list[tuple[int, str]] = []

    def result(self) -> ChangedUrdf:
        self._origins()
        for i in range(self.arm.n):
            self._inertia(i)
        for start, attributes in self.new_origins.items():
            self.edits.append(_Edit(start, start, f"<origin{attributes}/>".encode()))
        data = self.data
        for edit in sorted(self.edits, key=lambda each: -each.start):
            data = data[: edit.start] + edit.new + data[edit.end :]
        return ChangedUrdf(data.decode(), tuple(self.changes), tuple(self.unwritten))

    # --- inertias --------------------------------------------------------------------------------

    def _inertia(self, i: int) -> None:
        """Of link i, in its own <inertial>; what is fixed to the link stays as it is."""
        own, new = self.arm.links[i], self.other.links[i]
        before, after = (x.inertia.expressed_in(x.source_frame.inverse()) for x in (own, new))
        size = max(float(np.abs(own.link_tip_frame.p).max()), float(np.abs(before.com).max()))
        if _same_body(before, after, size):
            return
        subject = f"link {own.name!r}"
        inertial = self.robot.link[own.name].inertial
        if inertial is None:
            self.unwritten.append((i + 1, f"{subject}: its inertia is that of links fixed to it"))
            return
        if own.welded:
            moved = inertial.inertia.parameters() + after.parameters() - before.parameters()
            if not moved[0] > 0.0 or Inertia.from_parameters(moved).judged().fault is not None:
                parts = ", ".join(repr(name) for name, _ in own.welded)
                why = f"{subject}: the wrong number may be one of {parts}, fixed to it"
                self.unwritten.append((i + 1, why))
                return
            after = Inertia.from_parameters(moved)
            # Taken apart about the link's origin, where each part of the sum rounds by itself.
            moment = float(np.abs(before.parameters()[4:]).max())
        else:
            moment = float(np.abs(after.tensor).max())
        self._write_inertia(i, inertial, after, (size, moment))

    def _write_inertia(
        self, i: int, inertial: Inertial, after: Inertia, scales: tuple[float, float]
    ) -> None:
        """scales : the largest length [m] and moment [kg m²] that `after` was computed from"""
        size, moment = scales
        name = self.arm.links[i].name
        subject = f"link {name!r}"
        node = next(self.links[name].all("inertial"))
        place = inertial.place
        (mass,) = node.all("mass")
        error = _ROUNDING * after.mass
        what = f"{subject} mass"
        new = _Numbers(i + 1, "mass", what, place("mass"), [after.mass], error)
        self._replace(mass, "value", new)
        what = f"{subject} centre of mass"
        com = after.com.tolist()
        new = _Numbers(i + 1, "centre", what, place("origin"), com, _ROUNDING * size)
        self._triple(node, "xyz", new)
        R = Transform.from_rpy((0.0, 0.0, 0.0), inertial.rpy.tolist()).R
        tensor = R.T @ after.tensor @ R
        error = _ROUNDING * moment
        (entries,) = node.all("inertia")
        for entry in ENTRIES:
            value = float(tensor["xyz".index(entry[1]), "xyz".index(entry[2])])
            what = f"{subject} {entry}"
            self._replace(
                entries, entry, _Numbers(i + 1, "tensor", what, place(entry), [value], error)
            )

    # --- fixed transforms ------------------------------------------------------------------------

    def _origins(self) -> None:
        """B is the first joint's origin, P_i the next joint's, as far as nothing stands between."""
        names = [*self.arm.joint_names]
        frames = [self.arm.source.base, *(link.name for link in self.arm.links)]
        last = self.robot.above.get(self.arm.source.tip)
        if last is not None and last.parent == frames[-1]:
            names.append(last.name)
        before = [self.arm.base, *(link.link_tip_frame for link in self.arm.links)]
        after = [self.other.base, *(link.link_tip_frame for link in self.other.links)]
        for k, (frame, P, Q) in enumerate(zip(frames, before, after, strict=True)):
            size = max(float(np.abs(P.p).max()), float(np.abs(Q.p).max()))
            moved = float(np.abs(P.p - Q.p).max()) > _ROUNDING * size
            turned = float(np.abs(P.R - Q.R).max()) > _ROUNDING
            if not (moved or turned):
                continue
            if k == len(names) or self.robot.joint[names[k]].parent != frame:
                why = f"link {frame!r}: several joints, or none, place what follows it"
                self.unwritten.append((k, why))
                continue
            joint = self.robot.joint[names[k]]
            place, node, what = joint.at("origin"), self.joints[joint.name], f"joint {joint.name!r}"
            if moved:
                numbers, error = Q.p.tolist(), _ROUNDING * size
                new = _Numbers(k, "link_vector", f"{what} origin", place, numbers, error)
                self._triple(node, "xyz", new)
            if turned:
                turn = rpy_pose(Q).turn
                new = _Numbers(k, "rotation", f"{what} rotation", place, turn, _ROUNDING)
                self._triple(node, "rpy", new)

    # --- text ------------------------------------------------------------------------------------

    def _triple(self, above: XmlNode, key: str, numbers: _Numbers) -> None:
        """A list of three in an <origin>, which may be left out."""
        origin = next(above.all("origin"), None)
        if origin is not None and origin.get(key) is not None:
            self._replace(origin, key, numbers)
            return
        if max(map(abs, numbers.values)) <= numbers.error:
            return
        new = " ".join(exact(as_written(value, numbers.error)) for value in numbers.values)
        attribute = f' {key}="{new}"'
        if origin is not None:
            start = origin.offset + len(b"<origin")
            self.edits.append(_Edit(start, start, attribute.encode()))
        else:
            start = self.data.index(b">", above.offset) + 1
            self.new_origins[start] = self.new_origins.get(start, "") + attribute
        self.changes.append(numbers.change(numbers.place, "", new))

    def _replace(self, node: XmlNode, key: str, numbers: _Numbers) -> None:
        """The numbers of one attribute; those that stay the same keep their text."""
        start, end = node.value_span(key)
        old = self.data[start:end]
        words = list(_NUMBER.finditer(old))
        new = old
        for word, value in zip(reversed(words), reversed(numbers.values), strict=True):
            if abs(float(word[0]) - value) > numbers.error:
                text = exact(as_written(value, numbers.error)).encode()
                new = new[: word.start()] + text + new[word.end() :]
        if new != old:
            self.edits.append(_Edit(start, end, new))
            place = numbers.place
            if not place.via:
                place = replace(node.place(key), element=place.element)
            self.changes.append(numbers.change(place, old.decode(), new.decode()))


def _same_body(a: Inertia, b: Inertia, size: float) -> bool:
    return all(
        float(np.abs(np.subtract(x, y)).max()) <= _ROUNDING * scale
        for x, y, scale in _compared(a, b, size)
    )


def _compared(a: Inertia, b: Inertia, size: float) -> Iterator[tuple[Array, Array, float]]:
    yield np.array([a.mass]), np.array([b.mass]), max(abs(a.mass), abs(b.mass))
    yield a.com, b.com, max(size, float(np.abs(b.com).max()))
    yield a.tensor, b.tensor, max(float(np.abs(x.tensor).max()) for x in (a, b))
