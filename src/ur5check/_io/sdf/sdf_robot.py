"""An SDF to a `Robot`: poses from Drake (libsdformat), all other numbers from the text."""

from __future__ import annotations

import hashlib
import json
import re
import tempfile
from importlib.util import find_spec
from pathlib import Path
from typing import Any, cast

import numpy as np

from ..._finding import Place
from ..._robot.robot import JointKind, Mimic, Robot, RobotJoint, RobotLink, Unmodelled
from ..._robot.serial_arm import Limits
from ..._robot.transforms import Array, Transform
from ..._rules.finding_log import FindingLog
from ..arm_loading import judged_bodies
from ..bounded_process import EndedError, answer_of
from ..suggestions import did_you_mean
from ..xml.xml_numbers import xml_words
from ..xml.xml_tree import XmlError, XmlNode, parse_xml
from .sdf_text import SdfText, child, number, numbers

__all__ = ["read_sdf_robot"]

WORLD = "world"
#: Of the processor [s], of the wall clock [s], of memory and answer [byte].
_SECONDS, _AT_MOST, _MEMORY, _OUTPUT = 10.0, 120.0, 2**30, 64 * 2**20
_LIMITS = ("lower", "upper", "effort", "velocity")
#: SDFormat's types, as a `Robot` calls them.
_KINDS = {"revolute": "revolute", "continuous": "continuous", "prismatic": "prismatic",
          "fixed": "fixed", "ball": "ball"}  # fmt: skip


def read_sdf_robot(data: bytes, file: str, log: FindingLog) -> Robot | None:
    """The robot in an SDF; findings go to `log`.  None where the file describes none."""
    try:
        root = parse_xml(data, file)
    except XmlError as error:
        log.add("XML101", "file", error.problem, Place(file, error.line, error.column))
        return None
    if root.tag != "sdf":
        problem = f"the root element is <{root.tag}>, not <sdf>"
        log.add("XML102", "file", problem, root.place(), value=root.tag)
        return None
    if find_spec("pydrake") is None:
        problem = "SDF is read through Drake, which is not installed here"
        log.add("XML109", "file", problem, Place(file), fix="pip install 'ur5check[drake]'")
        return None
    text = SdfText(root, log)
    if text.model is None:
        return None
    inputs = ((file, hashlib.sha256(data).hexdigest()),)
    return _Reader(text, text.model, file, log).robot(inputs)


class _Reader:
    def __init__(self, text: SdfText, model: XmlNode, file: str, log: FindingLog) -> None:
        self.text, self.model, self.file, self.log = text, model, file, log
        self.left_out: list[XmlNode] = []  # which Drake would stop at
        self.axes: list[XmlNode] = []
        self.unmodelled: list[Unmodelled] = []

    def robot(self, inputs: tuple[tuple[str, str], ...]) -> Robot | None:
        edges = self._edges()
        moved = self._moved(edges)
        links = [self._link(name, name in moved) for name in self.text.links]
        if any(parent == WORLD for parent, _ in edges.values()):
            links.insert(0, RobotLink(WORLD, None, place=Place(self.file)))
        if not links:
            self.log.add("TRE105", "<model>", "has no link", self.model.place())
            return None
        children = {end for _, end in edges.values()}
        roots = [link.name for link in links if link.name not in children]
        answer = self._read_by_drake(roots[0])
        if answer is None:
            self.log.findings += judged_bodies(links)
            return None
        joints = [self._joint(name, *edges[name], answer["joints"][name]) for name in edges]
        if len(roots) > 1:
            shown = ", ".join(map(repr, roots[:6])) + (", …" if len(roots) > 6 else "")
            places = [link.place for link in links if link.name in roots and link.place.line]
            self.log.add(
                "TRE103", "model", f"holds {len(roots)} separate trees, from {shown}", *places[:6],
                value=len(roots), bound=1,
            )  # fmt: skip
        gravity, notes = self.text.gravity()
        said = tuple(f"Drake says: {_in_our_words(line)}" for line in answer["said"])
        return Robot(
            self.model.get("name") or "",
            tuple(links),
            tuple(joints),
            "sdf",
            self.file,
            np.array(answer["orientation"]).T @ np.array(gravity),
            inputs,
            unmodelled=tuple(self.unmodelled),
            notes=(*notes, *said),
        )

    def _read_by_drake(self, root: str) -> dict[str, Any] | None:
        lines = self.text.for_drake(self.left_out, self.axes)
        request = {
            "root": root,
            "text": lines.text,
            "seconds": _SECONDS,
            "memory_bytes": _MEMORY,
            "output_bytes": _OUTPUT,
        }
        try:
            with tempfile.TemporaryDirectory() as work:
                answer: dict[str, Any] = json.loads(
                    answer_of(
                        "ur5check._io.sdf.sdf_process",
                        json.dumps(request).encode(),
                        what="Drake's reading",
                        folder=Path(work),
                        seconds=_AT_MOST,
                    )
                )
        except (EndedError, ValueError) as error:
            problem = error.problem if isinstance(error, EndedError) else "Drake gave no answer"
            self.log.add("XML109", "file", problem, self.model.place())
            return None
        if "refused" not in answer:
            return answer
        if not any(finding.severity == "error" for finding in self.log.findings):
            node = lines.at(answer["refused"])
            place = Place(self.file) if node is None else node.place()
            problem = f"Drake refuses it: {_in_our_words(answer['refused'])}"
            self.log.add("XML109", "file", problem, place)
        return None

    # --- the tree --------------------------------------------------------------------------------

    def _edges(self) -> dict[str, tuple[str, str]]:
        """Parent and child of the joints that are read: each child once."""
        edges: dict[str, tuple[str, str]] = {}
        above: dict[str, str] = {}
        for name, node in self.text.joints.items():
            subject = f"joint {name!r}"
            kind = node.get("type") or ""
            ends = [self._end(node, tag, subject) for tag in ("parent", "child")]
            if kind not in _KINDS:
                problem = f"type {kind!r} is not read" if kind else "has no type"
                place = node.place("type" if kind else None, subject)
                fix = f"use one of {', '.join(_KINDS)}; {did_you_mean(kind, _KINDS)}"
                self.log.add("JNT100", subject, problem, place, fix=fix)
            elif ends[0] is not None and ends[1] is not None and ends[1] in above:
                problem = f"is the child of two joints, {above[ends[1]]!r} and {name!r}"
                self.log.add("TRE104", f"link {ends[1]!r}", problem, node.place("name", subject))
            elif ends[0] is not None and ends[1] is not None:
                edges[name], above[ends[1]] = (ends[0], ends[1]), name
                self._check_axis(child(node, "axis"), subject)
                continue
            self.left_out.append(node)
        return edges

    def _check_axis(self, axis: XmlNode | None, subject: str) -> None:
        """Numbers that Drake would stop at, or take without a word."""
        xyz, limit = child(axis, "xyz"), child(axis, "limit")
        if xyz is not None:
            values = numbers(xyz, 3, f"{subject} axis", self.log)
            if not 1e-14 < max(map(abs, values)) < 1e100:
                self.axes.append(xyz)
        bounds = {}
        for node in () if limit is None else limit.children:
            if node.tag in _LIMITS and node.text.strip() not in ("inf", "+inf", "-inf"):
                (bounds[node.tag],) = numbers(node, 1, f"{subject} limit {node.tag}", self.log)
        swapped = bounds.get("lower", -np.inf) > bounds.get("upper", np.inf)
        if limit is not None and (swapped or np.isnan(list(bounds.values())).any()):
            self.left_out.append(limit)

    def _end(self, node: XmlNode, tag: str, subject: str) -> str | None:
        end = child(node, tag)
        if end is None:
            self.log.add("XML104", subject, f"has no <{tag}>", node.place())
            return None
        link = end.text.strip()
        if link in self.text.links or (tag == "parent" and link == WORLD):
            return link
        problem = f"<{tag}> names no link of this model: {link!r}"
        fix = did_you_mean(link, self.text.links)
        self.log.add("TRE102", subject, problem, end.place(), value=link, fix=fix)
        return None

    def _moved(self, edges: dict[str, tuple[str, str]]) -> set[str]:
        """Links that some moving joint carries, directly or not."""
        below: dict[str, list[tuple[str, bool]]] = {}
        for name, (parent, end) in edges.items():
            moves = self.text.joints[name].get("type") != "fixed"
            below.setdefault(parent, []).append((end, moves))
        children = {end for _, end in edges.values()}
        stack = [(link, False) for link in (WORLD, *self.text.links) if link not in children]
        found = set()
        while stack:
            link, moves = stack.pop()
            if moves:
                found.add(link)
            stack += [(end, moves or own) for end, own in below.get(link, [])]
        return found

    # --- links and joints ------------------------------------------------------------------------

    def _link(self, name: str, moves: bool) -> RobotLink:
        node = self.text.links[name]
        place = node.place("name", f"link {name!r}")
        switch = child(node, "gravity")
        if switch is not None and switch.text.strip().lower() in ("false", "0"):
            self.unmodelled.append(
                Unmodelled(
                    f"link {name!r} gravity",
                    "the link's gravity is switched off",
                    links=frozenset({WORLD, name}),
                    place=switch.place(),
                )
            )
        inertial = self.text.inertial(name, moves=moves)
        return RobotLink(name, inertial, self.text.shapes(name), place)

    def _joint(self, name: str, parent: str, end: str, drake: dict[str, Any]) -> RobotJoint:
        node, subject = self.text.joints[name], f"joint {name!r}"
        kind = _KINDS[node.get("type") or ""]
        axis_node = child(node, "axis")
        dynamics = child(axis_node, "dynamics")
        places: dict[str, Place] = {}
        for part in (child(axis_node, "xyz"), dynamics, child(axis_node, "limit")):
            for each in () if part is None else (part, *part.children):
                key = "axis" if each.tag == "xyz" else each.tag
                places[key] = each.place(None, f"{subject} {key}")
        damping = number(dynamics, "damping", f"{subject} dynamics", self.log)
        friction = number(dynamics, "friction", f"{subject} dynamics", self.log)
        if number(dynamics, "spring_stiffness", f"{subject} dynamics", self.log):
            what = f"{subject} spring_stiffness"
            problem = "is a spring: its torque is no rigid body's"
            place = places["spring_stiffness"]
            self.unmodelled.append(Unmodelled(what, problem, frozenset({name}), place=place))
        written, axis = self._axis(axis_node, subject, drake)
        return RobotJoint(
            name,
            cast("JointKind", kind),
            parent,
            end,
            Transform.from_matrix(drake["origin"]),
            axis,
            written,
            self._limits(axis_node, subject, kind, drake),
            Transform.from_matrix(drake["child_frame"]).inverse(),
            damping=damping or 0.0,
            friction=friction or 0.0,
            armature=drake["armature"],
            mimic=self._mimic(axis_node, subject),
            place=node.place("name", subject),
            places=places,
        )

    def _axis(
        self, axis_node: XmlNode | None, subject: str, drake: dict[str, Any]
    ) -> tuple[Array, Array]:
        """As it is to be judged, and as Drake has it: SDFormat normalises axes."""
        if drake["axis"] is None:
            return np.array([1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0])
        xyz = child(axis_node, "xyz")
        if xyz is not None and xyz in self.axes:
            words = _floats(xyz.text)
            return np.array(words if len(words) == 3 else [np.nan] * 3), np.full(3, np.nan)
        return np.array(drake["axis"]), np.array(drake["axis"])

    def _limits(
        self, axis_node: XmlNode | None, subject: str, kind: str, drake: dict[str, Any]
    ) -> Limits:
        limit = child(axis_node, "limit")
        if kind in ("fixed", "ball"):
            return Limits()
        given = {key: _bound(limit, key) for key in _LIMITS}
        if limit is not None and limit in self.left_out:
            lower, upper, velocity = given["lower"], given["upper"], given["velocity"]
        else:
            lower, upper, velocity = drake["lower"], drake["upper"], drake["velocity"]
        effort = given["effort"]
        return Limits(
            _finite(lower) if kind != "continuous" else None,
            _finite(upper) if kind != "continuous" else None,
            _finite(velocity),
            None if effort is None or effort < 0.0 else _finite(effort),  # −1: no limit
        )

    def _mimic(self, axis_node: XmlNode | None, subject: str) -> Mimic | None:
        """q = multiplier · (q_of(joint) − reference) + offset"""
        mimic = child(axis_node, "mimic")
        if mimic is None:
            return None
        followed = mimic.get("joint") or ""
        if followed not in self.text.joints:
            problem = f"<mimic> names no joint of this model: {followed!r}"
            fix = did_you_mean(followed, self.text.joints)
            self.log.add("TRE102", subject, problem, mimic.place(), value=followed, fix=fix)
            return None
        factor, offset, reference = (
            number(mimic, key, f"{subject} mimic", self.log)
            for key in ("multiplier", "offset", "reference")
        )
        factor = 1.0 if factor is None else factor
        return Mimic(followed, factor, (offset or 0.0) - factor * (reference or 0.0))


def _bound(limit: XmlNode | None, tag: str) -> float | None:
    part = child(limit, tag)
    values = [] if part is None else _floats(part.text)
    return values[0] if len(values) == 1 else None


def _floats(text: str) -> list[float]:
    try:
        return [float(word) for word in xml_words(text)]
    except ValueError:
        return []


def _finite(limit: float | None) -> float | None:
    return None if limit is None or not abs(limit) < 1e15 else float(limit)


def _in_our_words(said: str) -> str:
    """One line, without the place, which refers to the rewritten text."""
    line = " ".join(said.split())
    return re.sub(r"^(<[\w-]+>(\.sdf)?(:\d+)?: *)?((error|warning): *)?", "", line).rstrip(".")
