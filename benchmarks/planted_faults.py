"""Faults planted in sound URDFs, one at a time, as they occur in practice.

Each kind edits the file's XML and names the rules that would be right to find it.  A kind that
does not apply to a robot (no rpy, no second limb) is omitted for that robot.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from xml.etree import ElementTree as ET

__all__ = ["KINDS", "Kind"]

_ENTRIES = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


@dataclass(frozen=True)
class Kind:
    """One kind of fault.

    rules : ids of which one is right;  text : edits the written file, after `plant`
    plant : edits the root, and returns the subject's name, or None where there is no place for it
    """

    name: str
    rules: frozenset[str]
    plant: Callable[[ET.Element, Random], str | None]
    text: Callable[[str], str] | None = None


def planted(root: ET.Element, kind: Kind, seed: int) -> tuple[str, str] | None:
    """The file's text with the fault, and the name of the link or joint that has it."""
    spoiled = copy.deepcopy(root)
    subject = kind.plant(spoiled, Random(seed))  # noqa: S311 - a benchmark
    if subject is None:
        return None
    text = ET.tostring(spoiled, encoding="unicode")
    return (kind.text(text) if kind.text else text), subject


# --- places of faults -----------------------------------------------------------------------------


def _bodies(root: ET.Element) -> list[ET.Element]:
    """Links that a moving joint carries, with a mass that counts."""
    moving = {j.find("child").get("link") for j in _joints(root)}
    found = []
    for link in root.iter("link"):
        mass = link.find("inertial/mass")
        heavy = mass is not None and float(mass.get("value")) > 0.2
        if link.get("name") in moving and heavy and link.find("inertial/inertia") is not None:
            found.append(link)
    return found


def _joints(root: ET.Element) -> list[ET.Element]:
    return [
        j
        for j in root.iterfind("joint")
        if j.get("type") in ("revolute", "prismatic") and j.find("mimic") is None
    ]


def _pick(things: list[ET.Element], random: Random) -> ET.Element | None:
    return random.choice(things) if things else None


# --- kinds of faults ------------------------------------------------------------------------------


def _mass(factor: float) -> Callable[[ET.Element, Random], str | None]:
    def plant(root: ET.Element, random: Random) -> str | None:
        link = _pick(_bodies(root), random)
        if link is None:
            return None
        mass = link.find("inertial/mass")
        mass.set("value", f"{float(mass.get('value')) * factor:.6g}")
        return link.get("name")

    return plant


def _tensor(factor: float, *entries: str) -> Callable[[ET.Element, Random], str | None]:
    def plant(root: ET.Element, random: Random) -> str | None:
        link = _pick(_bodies(root), random)
        if link is None:
            return None
        tensor = link.find("inertial/inertia")
        for entry in entries or _ENTRIES:
            tensor.set(entry, f"{float(tensor.get(entry)) * factor:.6g}")
        return link.get("name")

    return plant


def _set_tensor(values: Callable[[dict[str, float]], dict[str, float]]):
    def plant(root: ET.Element, random: Random) -> str | None:
        link = _pick(_bodies(root), random)
        if link is None:
            return None
        tensor = link.find("inertial/inertia")
        old = {entry: float(tensor.get(entry)) for entry in _ENTRIES}
        for entry, value in values(old).items():
            tensor.set(entry, f"{value:.8g}")
        return link.get("name")

    return plant


def _origin(change: Callable[[list[float]], list[float] | None], key: str = "xyz"):
    def plant(root: ET.Element, random: Random) -> str | None:
        links = _bodies(root)
        random.shuffle(links)
        for link in links:
            origin = link.find("inertial/origin")
            if origin is None:
                origin = ET.SubElement(link.find("inertial"), "origin")
            new = change([float(x) for x in (origin.get(key) or "0 0 0").split()])
            if new is not None:
                origin.set(key, " ".join(f"{x:.6g}" for x in new))
                return link.get("name")
        return None

    return plant


def _millimetres(xyz: list[float]) -> list[float] | None:
    return [1000 * x for x in xyz] if max(map(abs, xyz)) > 0.01 else None


def _far(xyz: list[float]) -> list[float]:
    return [xyz[0], xyz[1] + 2.0, xyz[2]]


def _limit(**values: str) -> Callable[[ET.Element, Random], str | None]:
    def plant(root: ET.Element, random: Random) -> str | None:
        joint = _pick([j for j in _joints(root) if j.find("limit") is not None], random)
        if joint is None:
            return None
        for key, value in values.items():
            joint.find("limit").set(key, value)
        return joint.get("name")

    return plant


def _swapped(root: ET.Element, random: Random) -> str | None:
    joints = [
        j
        for j in _joints(root)
        if j.find("limit") is not None
        and float(j.find("limit").get("lower", 0)) < float(j.find("limit").get("upper", 0))
    ]
    joint = _pick(joints, random)
    if joint is None:
        return None
    limit = joint.find("limit")
    lower, upper = limit.get("lower", "0"), limit.get("upper", "0")
    limit.set("lower", upper)
    limit.set("upper", lower)
    return joint.get("name")


def _degrees(root: ET.Element, random: Random) -> str | None:
    joints = [j for j in _joints(root) if j.get("type") == "revolute"]
    joints = [j for j in joints if abs(float(j.find("limit").get("upper", 0))) > 0.5]
    joint = _pick(joints, random)
    if joint is None:
        return None
    limit = joint.find("limit")
    for key in ("lower", "upper"):
        limit.set(key, f"{round(float(limit.get(key, 0)) * 57.29577951)}")
    return joint.get("name")


def _rpy_degrees(root: ET.Element, random: Random) -> str | None:
    joints = [
        j
        for j in root.iterfind("joint")
        if j.find("origin") is not None
        and max(abs(float(x)) for x in (j.find("origin").get("rpy") or "0").split()) > 0.5
    ]
    joint = _pick(joints, random)
    if joint is None:
        return None
    origin = joint.find("origin")
    origin.set("rpy", " ".join(f"{float(x) * 57.29577951:.6g}" for x in origin.get("rpy").split()))
    return joint.get("name")


def _axis(xyz: str) -> Callable[[ET.Element, Random], str | None]:
    def plant(root: ET.Element, random: Random) -> str | None:
        joint = _pick(_joints(root), random)
        if joint is None:
            return None
        axis = joint.find("axis")
        if axis is None:
            axis = ET.SubElement(joint, "axis")
        axis.set("xyz", xyz)
        return joint.get("name")

    return plant


def _mass_text(change: Callable[[str], str]) -> Callable[[ET.Element, Random], str | None]:
    def plant(root: ET.Element, random: Random) -> str | None:
        link = _pick(_bodies(root), random)
        if link is None:
            return None
        mass = link.find("inertial/mass")
        mass.set("value", change(mass.get("value")))
        return link.get("name")

    return plant


def _without(path: str, attribute: str) -> Callable[[ET.Element, Random], str | None]:
    def plant(root: ET.Element, random: Random) -> str | None:
        link = _pick(_bodies(root), random)
        if link is None:
            return None
        del link.find(path).attrib[attribute]
        return link.get("name")

    return plant


def _without_inertial(root: ET.Element, random: Random) -> str | None:
    fixed = {
        j.find("parent").get("link") for j in root.iterfind("joint") if j.get("type") == "fixed"
    }
    link = _pick([x for x in _bodies(root) if x.get("name") not in fixed], random)
    if link is None:
        return None
    link.remove(link.find("inertial"))
    return link.get("name")


def _massless_end(root: ET.Element, random: Random) -> str | None:
    parents = {j.find("parent").get("link") for j in root.iterfind("joint")}
    link = _pick([x for x in _bodies(root) if x.get("name") not in parents], random)
    if link is None:
        return None
    link.find("inertial/mass").set("value", "0")
    for entry in _ENTRIES:
        link.find("inertial/inertia").set(entry, "0")
    return link.get("name")


def _point(root: ET.Element, random: Random) -> str | None:
    parents = {
        j.find("parent").get("link") for j in root.iterfind("joint") if j.get("type") == "fixed"
    }
    link = _pick([x for x in _bodies(root) if x.get("name") not in parents], random)
    if link is None:
        return None
    for entry in _ENTRIES:
        link.find("inertial/inertia").set(entry, "0")
    return link.get("name")


def _twice(root: ET.Element, random: Random) -> str | None:
    link = _pick(_bodies(root), random)
    if link is None:
        return None
    root.append(copy.deepcopy(link))
    return link.get("name")


def _unknown_child(root: ET.Element, random: Random) -> str | None:
    joint = _pick(_joints(root), random)
    if joint is None:
        return None
    joint.find("child").set("link", joint.find("child").get("link") + "_new")
    return joint.get("name")


def _cut(root: ET.Element, random: Random) -> str | None:
    joint = _pick(_joints(root), random)
    if joint is None:
        return None
    root.remove(joint)
    return "robot"


def _loop(root: ET.Element, random: Random) -> str | None:
    joints = _joints(root)
    if len(joints) < 3:
        return None
    first, last = joints[0], joints[-1]
    extra = copy.deepcopy(last)
    extra.set("name", "closing_joint")
    extra.find("parent").set("link", last.find("child").get("link"))
    extra.find("child").set("link", first.find("child").get("link"))
    root.append(extra)
    return "closing_joint"


def _negative_damping(root: ET.Element, random: Random) -> str | None:
    joint = _pick(_joints(root), random)
    if joint is None:
        return None
    dynamics = joint.find("dynamics")
    if dynamics is None:
        dynamics = ET.SubElement(joint, "dynamics")
    dynamics.set("damping", "-0.5")
    return joint.get("name")


def _two_inertials(root: ET.Element, random: Random) -> str | None:
    link = _pick(_bodies(root), random)
    if link is None:
        return None
    link.append(copy.deepcopy(link.find("inertial")))
    return link.get("name")


def _anything(root: ET.Element, random: Random) -> str | None:
    return "file"


def _over_triangle(old: dict[str, float]) -> dict[str, float]:
    return old | {"izz": 1.3 * (old["ixx"] + old["iyy"])}


def _all(value: float) -> Callable[[dict[str, float]], dict[str, float]]:
    return lambda old: dict.fromkeys(old, value)


def _unit(old: dict[str, float]) -> dict[str, float]:
    return dict.fromkeys(old, 0.0) | {"ixx": 1.0, "iyy": 1.0, "izz": 1.0}


_SPREAD = frozenset({"INE108", "INE109"})

KINDS: tuple[Kind, ...] = (
    Kind("mass in grams", frozenset({"INE111", "INE115"}), _mass(1000.0)),
    Kind("mass in tonnes", _SPREAD, _mass(0.001)),
    Kind("mass negative", frozenset({"INE101"}), _mass(-1.0)),
    Kind("centre in mm", frozenset({"INE112", "GEO101"}), _origin(_millimetres)),
    Kind("centre 2 m away", frozenset({"INE112", "GEO101"}), _origin(_far)),
    Kind("tensor in g mm²", _SPREAD, _tensor(1e9)),
    Kind("tensor in kg mm²", _SPREAD, _tensor(1e6)),
    Kind("tensor in kg cm²", _SPREAD, _tensor(1e4)),
    Kind("tensor in lb in²", _SPREAD, _tensor(3417.17)),
    Kind("tensor in g m²", _SPREAD, _tensor(1e3)),
    Kind("tensor too small by 1e6", frozenset({"INE110"}), _tensor(1e-6)),
    Kind("triangle inequality", frozenset({"INE103"}), _set_tensor(_over_triangle)),
    Kind("negative moment", frozenset({"INE102"}), _tensor(-1.0, "ixx")),
    Kind("unit tensor", _SPREAD | {"INE113"}, _set_tensor(_unit)),
    Kind("six equal entries", frozenset({"INE113", "INE103"}), _set_tensor(_all(0.001))),
    Kind("no inertial", frozenset({"INE104", "INE107"}), _without_inertial),
    Kind("massless end", frozenset({"INE105", "INE107"}), _massless_end),
    Kind("mass without tensor", frozenset({"INE106"}), _point),
    Kind("effort 0", frozenset({"JNT103"}), _limit(effort="0")),
    Kind("velocity 0", frozenset({"JNT103"}), _limit(velocity="0")),
    Kind("effort negative", frozenset({"JNT104"}), _limit(effort="-10")),
    Kind("limits swapped", frozenset({"JNT105"}), _swapped),
    Kind("limits in degrees", frozenset({"JNT109"}), _degrees),
    Kind("rpy in degrees", frozenset({"JNT110"}), _rpy_degrees),
    Kind("axis zero", frozenset({"JNT101"}), _axis("0 0 0")),
    Kind("axis not unit", frozenset({"JNT102"}), _axis("0 0 2")),
    Kind("damping negative", frozenset({"JNT112"}), _negative_damping),
    Kind("decimal comma", frozenset({"XML103"}), _mass_text(lambda x: x.replace(".", ",") + ",0")),
    Kind("nan", frozenset({"XML103"}), _mass_text(lambda x: "nan")),
    Kind("missing ixx", frozenset({"XML104"}), _without("inertial/inertia", "ixx")),
    Kind("missing mass", frozenset({"XML104"}), _without("inertial/mass", "value")),
    Kind("two inertials", frozenset({"XML105"}), _two_inertials),
    Kind("xacro unexpanded", frozenset({"XML107"}), _mass_text(lambda x: "${mass}")),
    Kind("link twice", frozenset({"TRE101"}), _twice),
    Kind("unknown child", frozenset({"TRE102"}), _unknown_child),
    Kind("joint lost", frozenset({"TRE103"}), _cut),
    Kind("loop", frozenset({"TRE104"}), _loop),
    Kind("file cut off", frozenset({"XML101"}), _anything, lambda text: text[: len(text) * 2 // 3]),
)  # fmt: skip
