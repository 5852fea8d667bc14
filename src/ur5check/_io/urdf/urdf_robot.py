"""A URDF's text to a `Robot`, faults and all: each is recorded, and reading goes on.

What a fault leaves is the least that makes sense: a number that is none becomes nan, a joint whose
parent or child is missing is left out, of two elements that readers choose between the first stays.
"""

from __future__ import annotations

import math
import re
from typing import cast, get_args

import numpy as np

from ..._finding import Place
from ..._robot.robot import (
    ENTRIES,
    Inertial,
    JointKind,
    Mimic,
    Robot,
    RobotJoint,
    RobotLink,
    ShapeRef,
)
from ..._robot.serial_arm import STANDARD_GRAVITY, Limits
from ..._robot.transforms import Array, Transform, unit_vector
from ..._rules.finding_log import FindingLog
from ..printed_numbers import common_rounding, plain_number
from ..suggestions import did_you_mean
from ..xml.xml_tree import XmlNode

__all__ = ["read_urdf_robot"]

_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
#: What URDF's readers split a list of numbers at (urdfdom: a blank; others: XML's white space).
_BLANKS = re.compile(r"[ \t\r\n]+")
_NAN3 = (math.nan, math.nan, math.nan)

_KNOWN = {
    "origin": {"xyz", "rpy", "quat_xyzw"},
    "axis": {"xyz"},
    "mass": {"value"},
    "inertia": set(ENTRIES),
    "limit": {"lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"},
    "dynamics": {"damping", "friction"},
    "mimic": {"joint", "multiplier", "offset"},
}


def read_urdf_robot(
    root: XmlNode,
    log: FindingLog,
    *,
    kind: str = "urdf",
    inputs: tuple[tuple[str, str], ...] = (),
) -> Robot:
    """The robot that a URDF's root element describes; findings go to `log`."""
    return _Reader(root, log).robot(kind, inputs)


class _Reader:
    def __init__(self, root: XmlNode, log: FindingLog) -> None:
        self.root, self.log = root, log
        self.file = root.place().file
        self.link_names: set[str] = set()

    def robot(self, kind: str, inputs: tuple[tuple[str, str], ...]) -> Robot:
        name = self.root.get("name")
        if not (name or "").strip():
            self.log.add("XML104", "robot", "<robot> has no name", self.root.place())
        self._unexpanded()
        links = self._named("link")
        self.link_names = set(links)
        joints = self._named("joint")
        if not links:
            self.log.add("TRE105", f"robot {name!r}", "has no link", self.root.place())
        read_links = tuple(self._link(key, node) for key, node in links.items())
        read_joints = [self._joint(key, node, joints) for key, node in joints.items()]
        kept = self._forest(links, [joint for joint in read_joints if joint is not None])
        return Robot(
            name or "",
            read_links,
            kept,
            kind,
            self.file,
            np.array(STANDARD_GRAVITY),
            inputs,
        )

    # --- names and the tree ----------------------------------------------------------------------

    def _unexpanded(self) -> None:
        """xacro that was not expanded; one finding, at the first place."""
        for node in self.root.walk():
            if node.tag.startswith("xacro:"):
                problem = f"<{node.tag}> is a xacro instruction, not yet expanded"
                self.log.add("XML107", "robot", problem, node.place())
                return
            if node.tag.startswith(("gazebo", "ros2_control", "transmission")):
                continue
            for key, text in node.attributes.items():
                if "${" in text or "$(" in text:
                    problem = f"{key}={text!r} is an unexpanded xacro expression"
                    self.log.add("XML107", "robot", problem, node.place(key))
                    return

    def _named(self, tag: str) -> dict[str, XmlNode]:
        named: dict[str, XmlNode] = {}
        for node in self.root.all(tag):
            name = (node.get("name") or "").strip()
            if not name:
                self.log.add("XML104", f"<{tag}>", f"a <{tag}> has no name", node.place())
            elif name in named:
                problem = f"appears twice, first in line {named[name].place().line}"
                self.log.add("TRE101", f"{tag} {name!r}", problem, node.place("name"))
            else:
                named[name] = node
        return named

    def _forest(
        self, links: dict[str, XmlNode], joints: list[RobotJoint]
    ) -> tuple[RobotJoint, ...]:
        """The joints of a forest: one above each link, no cycle."""
        above: dict[str, RobotJoint] = {}
        for joint in joints:
            if joint.child in above:
                problem = (
                    f"is the child of two joints, {above[joint.child].name!r} and {joint.name!r}"
                )
                self.log.add("TRE104", f"link {joint.child!r}", problem, joint.at("child"))
            else:
                above[joint.child] = joint
        settled: set[str] = set()
        for link in links:
            path: list[str] = []
            while link in above and link not in settled and link not in path:
                path.append(link)
                link = above[link].parent
            if link in path:
                joint = above.pop(link)
                shown = " → ".join([*reversed(path[path.index(link) :]), path[-1]])
                problem = f"closes a loop of links: {shown}"
                self.log.add("TRE104", f"joint {joint.name!r}", problem, joint.place)
            settled.update(path)
        roots = [link for link in links if link not in above]
        # Every joint that was left out makes a root of its child: one fault, one finding.
        if len(roots) > 1 and len(joints) == len(list(self.root.all("joint"))):
            shown = ", ".join(map(repr, roots[:6])) + (", …" if len(roots) > 6 else "")
            self.log.add(
                "TRE103",
                "robot",
                f"has {len(roots)} root links: {shown}",
                *(links[root].place("name") for root in roots[:6]),
                value=len(roots),
                bound=1,
            )
        return tuple(joint for joint in joints if above.get(joint.child) is joint)

    # --- links -----------------------------------------------------------------------------------

    def _link(self, name: str, node: XmlNode) -> RobotLink:
        subject = f"link {name!r}"
        inertial = self._only(node, "inertial", subject)
        shapes = [
            shape
            for part in node.all("collision", "visual")
            if (shape := self._shape(part, subject)) is not None
        ]
        return RobotLink(
            name,
            None if inertial is None else self._inertial(inertial, subject),
            tuple(shapes),
            node.place("name", subject),
        )

    def _inertial(self, node: XmlNode, subject: str) -> Inertial:
        mass_node = self._only(node, "mass", subject)
        tensor_node = self._only(node, "inertia", subject)
        xyz, rpy, origin = self._origin(node, f"{subject} inertial")
        places = {"inertial": node.place(), "origin": origin}
        mass = math.nan
        if mass_node is None:
            self.log.add("XML104", subject, "<inertial> has no <mass>", node.place())
        else:
            mass = self._number(mass_node, "value", f"{subject} inertial/mass")
            places["mass"] = mass_node.place("value", f"{subject} inertial/mass")
        entries: dict[str, float] = {}
        if tensor_node is None:
            self.log.add("XML104", subject, "<inertial> has no <inertia>", node.place())
        else:
            places["inertia"] = tensor_node.place(None, f"{subject} inertial/inertia")
            for entry in ENTRIES:
                where = f"{subject} inertial/inertia"
                entries[entry] = self._number(tensor_node, entry, where)
                places[entry] = tensor_node.place(entry, f"{where} {entry}")
        rounding = common_rounding(entries)
        return Inertial(mass, np.array(xyz), np.array(rpy), entries, rounding, places)

    def _shape(self, node: XmlNode, subject: str) -> ShapeRef | None:
        where = f"{subject} {node.tag}"
        geometry = self._only(node, "geometry", where)
        solids = [] if geometry is None else geometry.children
        if not solids:
            self.log.add("XML104", where, f"<{node.tag}> has no geometry", node.place())
            return None
        solid = solids[0]
        xyz, rpy, _ = self._origin(node, where)
        if not np.isfinite([*xyz, *rpy]).all():
            return None
        size: tuple[float, ...] = ()
        uri = ""
        if solid.tag == "box":
            size = self._triple(solid, "size", where, None)
        elif solid.tag in ("cylinder", "capsule"):
            size = tuple(self._number(solid, key, where) for key in ("radius", "length"))
        elif solid.tag == "sphere":
            size = (self._number(solid, "radius", where),)
        elif solid.tag == "mesh":
            uri = solid.get("filename") or ""
            size = self._triple(solid, "scale", where, (1.0, 1.0, 1.0))
        else:
            self.log.add("XML106", where, f"<{solid.tag}> is no shape of URDF", solid.place())
            return None
        if not np.isfinite(size).all():
            return None
        key = "filename" if solid.tag == "mesh" else None
        return ShapeRef(
            "collision" if node.tag == "collision" else "visual",
            solid.tag,
            tuple(map(float, size)),
            Transform.from_rpy(xyz, rpy),
            uri,
            solid.place(key, where),
        )

    # --- joints ----------------------------------------------------------------------------------

    def _joint(self, name: str, node: XmlNode, joints: dict[str, XmlNode]) -> RobotJoint | None:
        subject = f"joint {name!r}"
        kind = node.get("type") or ""
        if kind not in _TYPES:
            problem = f"type {kind!r} is no joint type of URDF" if kind else "has no type"
            fix = did_you_mean(kind, _TYPES)
            self.log.add("JNT100", subject, problem, node.place("type" if kind else None), fix=fix)
            return None
        ends = [self._end(node, tag, subject) for tag in ("parent", "child")]
        if None in ends:
            return None
        parent, child = cast("list[str]", ends)
        xyz, rpy, origin = self._origin(node, subject)
        places = {"origin": origin}
        for tag in ("axis", "limit", "dynamics", "mimic", "child"):
            part = next(node.all(tag), None)
            if part is not None:
                places[tag] = part.place(None, f"{subject} {tag}")
                for key in part.attributes:
                    places.setdefault(key, part.place(key, f"{subject} {tag} {key}"))
        written, axis = self._axis(node, subject, kind)
        damping, friction = self._dynamics(node, subject)
        finite = np.isfinite([*xyz, *rpy]).all()
        return RobotJoint(
            name,
            cast("JointKind", kind),
            parent,
            child,
            Transform.from_rpy(xyz, rpy) if finite else Transform.identity(),
            axis,
            written,
            self._limits(node, subject, kind),
            rpy=np.array(rpy),
            damping=damping,
            friction=friction,
            mimic=self._mimic(node, subject, name, joints),
            place=node.place("name", subject),
            places=places,
        )

    def _end(self, node: XmlNode, tag: str, subject: str) -> str | None:
        """The link that a joint's <parent> or <child> names, if it exists."""
        end = self._only(node, tag, subject)
        if end is None:
            self.log.add("XML104", subject, f"has no <{tag}>", node.place())
            return None
        link = end.get("link") or ""
        if link not in self.link_names:
            problem = f"<{tag}> names no link of this file: {link!r}"
            fix = did_you_mean(link, self.link_names)
            self.log.add("TRE102", subject, problem, end.place("link"), value=link, fix=fix)
            return None
        return link

    def _axis(self, node: XmlNode, subject: str, kind: str) -> tuple[Array, Array]:
        """As written, and as a unit vector: (1, 0, 0) where it is left out, nan where none."""
        default = np.array([1.0, 0.0, 0.0])
        if kind in ("fixed", "floating"):  # an axis has no meaning there, whatever is written
            return default, default
        axis_node = self._only(node, "axis", subject)
        if axis_node is None:
            return default, default
        written = np.array(self._triple(axis_node, "xyz", f"{subject} axis", None))
        if not np.isfinite(written).all() or not written.any():
            return written, np.full(3, math.nan)
        return written, unit_vector(written)

    def _limits(self, node: XmlNode, subject: str, kind: str) -> Limits:
        limit = self._only(node, "limit", subject)
        if limit is None:
            if kind in ("revolute", "prismatic"):
                problem = f"has no <limit>, which a {kind} joint must have"
                self.log.add("JNT108", subject, problem, node.place())
            return Limits()
        values = {
            key: self._number(limit, key, f"{subject} limit")
            for key in ("lower", "upper", "effort", "velocity")
            if limit.get(key) is not None
        }
        for key in ("effort", "velocity"):
            if key not in values:  # urdfdom refuses the file, whatever kind of joint it is
                self.log.add("XML104", f"{subject} limit", f"{key} is missing", limit.place())
        bounded = kind not in ("continuous", "fixed", "floating", "planar")
        return Limits(
            lower=values.get("lower", 0.0) if bounded else None,  # URDF: left out, it is 0
            upper=values.get("upper", 0.0) if bounded else None,
            velocity=values.get("velocity"),
            effort=values.get("effort"),
        )

    def _dynamics(self, node: XmlNode, subject: str) -> tuple[float, float]:
        dynamics = self._only(node, "dynamics", subject)
        if dynamics is None:
            return 0.0, 0.0
        damping, friction = (
            0.0 if dynamics.get(key) is None else self._number(dynamics, key, f"{subject} dynamics")
            for key in ("damping", "friction")
        )
        return damping, friction

    def _mimic(
        self, node: XmlNode, subject: str, name: str, joints: dict[str, XmlNode]
    ) -> Mimic | None:
        mimic = self._only(node, "mimic", subject)
        if mimic is None:
            return None
        followed = mimic.get("joint") or ""
        if followed not in joints or followed == name:
            problem = f"<mimic> names no other joint of this file: {followed!r}"
            fix = did_you_mean(followed, set(joints) - {name})
            self.log.add("TRE102", subject, problem, mimic.place("joint"), value=followed, fix=fix)
            return None
        factors = {
            key: self._number(mimic, key, f"{subject} mimic")
            for key in ("multiplier", "offset")
            if mimic.get(key) is not None
        }
        return Mimic(followed, factors.get("multiplier", 1.0), factors.get("offset", 0.0))

    # --- numbers ---------------------------------------------------------------------------------

    def _only(self, node: XmlNode, tag: str, subject: str) -> XmlNode | None:
        """The first child of a tag.  A second one, or an ignored attribute, is a finding."""
        found = list(node.all(tag))
        if len(found) > 1:
            problem = f"has {len(found)} <{tag}> elements; readers differ on which counts"
            self.log.add("XML105", subject, problem, found[1].place())
        if not found:
            return None
        unknown = set(found[0].attributes) - _KNOWN.get(tag, set(found[0].attributes))
        for key in sorted(unknown):
            problem = f"<{tag}> has an attribute {key!r}, which URDF ignores"
            self.log.add("XML106", subject, problem, found[0].place(key))
        return found[0]

    def _number(self, node: XmlNode, key: str, where: str) -> float:
        """A number with its text; nan, with a finding, where there is none."""
        text = node.get(key)
        if text is None:
            self.log.add("XML104", where, f"{key} is missing", node.place())
            return math.nan
        return self._plain(node, key, where, text, text)

    def _plain(self, node: XmlNode, key: str, where: str, word: str, whole: str) -> float:
        try:
            return plain_number(word)
        except ValueError as error:
            if "${" not in whole and "$(" not in whole:  # which is a finding of the whole file
                problem = f"{key}={whole!r} {error}"
                self.log.add("XML103", where, problem, node.place(key), value=whole)
            return math.nan

    def _triple(
        self, node: XmlNode, key: str, where: str, default: tuple[float, float, float] | None
    ) -> tuple[float, float, float]:
        text = node.get(key)
        if text is None:
            if default is None:
                self.log.add("XML104", where, f"{key} is missing", node.place())
                return _NAN3
            return default
        words = [word for word in _BLANKS.split(text.strip(" \t\r\n")) if word]
        if len(words) != 3:
            problem = f"{key}={text!r} takes 3 numbers, not {len(words)}"
            fix = "write three numbers, parted by spaces"
            self.log.add("XML103", where, problem, node.place(key), value=text, fix=fix)
            return _NAN3
        a, b, c = (self._plain(node, key, where, word, text) for word in words)
        return a, b, c

    def _origin(
        self, node: XmlNode, where: str
    ) -> tuple[tuple[float, float, float], tuple[float, float, float], Place]:
        """Position [m], roll, pitch, yaw [rad], and where they are written."""
        zero = (0.0, 0.0, 0.0)
        origin = self._only(node, "origin", where)
        if origin is None:
            return zero, zero, node.place()
        xyz = self._triple(origin, "xyz", f"{where} origin", zero)
        return xyz, self._triple(origin, "rpy", f"{where} origin", zero), origin.place()


assert set(_TYPES) <= set(get_args(JointKind))  # noqa: S101 - about this file alone
