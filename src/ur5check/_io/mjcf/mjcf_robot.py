"""An MJCF to a `Robot`: what MuJoCo compiles, with the file's own numbers and their places.

MuJoCo applies the joints of one body one after the other, each about its own anchor in the body's
frame: T_parent→body = T · Trans(a) J(q) Trans(−a) · …  All but the last of several joints get a
link of their own, which is no body.  A joint's `ref` is its coordinate in the posture that the file
describes.  A body with a free joint stands fixed where the file puts it.
"""

from __future__ import annotations

import json
import re
import tempfile
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path
from typing import Any, cast

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
    Unmodelled,
)
from ..._robot.serial_arm import Joint, Limits
from ..._robot.transforms import Array, Transform
from ..._rules.finding_log import FindingLog
from ..arm_loading import judged_bodies
from ..bounded_process import EndedError, answer_of
from ..printed_numbers import common_rounding
from ..xml.xml_tree import XmlError, XmlNode
from .mjcf_text import MjcfText, numbers

__all__ = ["read_mjcf_robot"]

WORLD = "world"
#: Of the processor [s], of the wall clock [s], of memory and answer [byte].
_SECONDS, _AT_MOST, _MEMORY, _OUTPUT = 10.0, 120.0, 2**30, 64 * 2**20
#: What one element may unfold into; more would only keep the compiler busy until its limits.
_MOST_ENTRIES = 1_000_000
_UNLIMITED = np.finfo(float).max
_FULL = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")  # MJCF's order


def read_mjcf_robot(
    data: bytes, file: str, folder: Path, log: FindingLog, *, frames: Iterable[str] = ()
) -> Robot | None:
    """The robot in an MJCF; findings go to `log`.  None where the file describes none.

    folder : where included files and meshes are
    frames : names that may be those of sites, which then are links
    """
    try:
        text = MjcfText(data, file=file, folder=folder, log=log)
    except XmlError as error:
        log.add("XML101", "file", error.problem, Place(file, error.line, error.column))
        return None
    if text.root.tag != "mujoco":
        problem = f"the root element is <{text.root.tag}>, not <mujoco>"
        log.add("XML102", "file", problem, text.root.place(), value=text.root.tag)
        return None
    if find_spec("mujoco") is None:
        problem = "MJCF is read through MuJoCo, which is not installed here"
        log.add("XML109", "file", problem, Place(file), fix="pip install 'ur5check[mujoco]'")
        return None
    answer = _compile(text, list(frames))
    if answer is None:
        return None
    return _Reader(text, answer).robot()


def _compile(text: MjcfText, sites: list[str]) -> dict[str, Any] | None:
    """What MuJoCo makes of it; None, with a finding, where that is nothing."""
    node, entries = text.largest()
    if entries > _MOST_ENTRIES:
        problem = f"stands for {entries:,.0f} entries, more than {_MOST_ENTRIES:,}"
        text.log.add("XML100", f"<{node.tag}>", problem, node.place(), fix="make it smaller")
        return None
    request = {
        "text": text.text,
        "folder": str(text.folder.resolve()),
        "sites": sites,
        "seconds": _SECONDS,
        "memory_bytes": _MEMORY,
        "output_bytes": _OUTPUT,
    }
    try:
        with tempfile.TemporaryDirectory() as work:  # where MuJoCo may write its log
            answer: dict[str, Any] = json.loads(
                answer_of(
                    "ur5check._io.mjcf.mjcf_process",
                    json.dumps(request).encode(),
                    what="MuJoCo's compiler",
                    folder=Path(work),
                    seconds=_AT_MOST,
                )
            )
    except (EndedError, ValueError) as error:
        problem = error.problem if isinstance(error, EndedError) else "MuJoCo gave no answer"
        text.log.add("XML109", f"<{node.tag}>", problem, node.place())
        return None
    if "bodies" not in answer:
        _refused(text, answer["refused"])
        return None
    return answer


def _refused(text: MjcfText, message: str) -> None:
    """MuJoCo's refusal as a finding, unless an earlier finding is about the same element."""
    place = text.place(message)
    if any(f.severity == "error" and _same_line(f.places, place) for f in text.log.findings):
        return
    first, *rest = message.strip().splitlines()
    problem = re.sub(r"^((XML )?Error: )+", "", first)
    element = re.search(r"Element (?:name )?'([^']+)'", " ".join(rest))
    subject = "file" if element is None else repr(element[1])
    text.log.add("XML109", subject, f"MuJoCo refuses it: {problem}", place)


def _same_line(places: tuple[Place, ...], place: Place) -> bool:
    return any((p.file, p.line) == (place.file, place.line) for p in places)


class _Reader:
    def __init__(self, text: MjcfText, answer: dict[str, Any]) -> None:
        self.text, self.log, self.answer = text, text.log, answer
        self.links: list[RobotLink] = [RobotLink(WORLD, None, place=Place(text.file))]
        self.joints: list[RobotJoint] = []
        self.unmodelled: list[Unmodelled] = []
        self.refs = {j["name"]: j["ref"] for body in answer["bodies"] for j in body["joints"]}
        self.mimics: dict[str, Mimic] = {}
        self.names = {WORLD, *(body["name"] for body in answer["bodies"])}

    def robot(self) -> Robot:
        self._couplings()
        for body in self.answer["bodies"]:
            self._body(body)
        for site in self.answer["sites"]:
            place = self.text.place(site["line"], f"site {site['name']!r}")
            self.links.append(RobotLink(site["name"], None, place=place))
            self._fixed(f"{site['name']} (site)", site["parent"], site["name"], _pose(site), place)
        for body, line, path, reason in self.answer["lost"]:
            problem = f"its mass comes from the mesh {path!r}, which cannot be read: {reason}"
            self.log.add("XML110", f"body {body!r}", problem, self.text.place(line), value=path)
        if self.answer["fluid"]:
            every = frozenset(link.name for link in self.links)
            problem = "density, viscosity or wind is set: the bodies move in a fluid"
            option = next(self.text.root.all("option"), self.text.root)
            self.unmodelled.append(
                Unmodelled("<option>", problem, links=every, place=option.place())
            )
        weighed = [body["name"] for body in self.answer["bodies"] if body["weighed"]]
        notes = [f"MuJoCo says: {line}" for line in self.answer["said"]]
        if weighed:
            shown = ", ".join(map(repr, weighed))
            notes.append(
                f"mass and inertia made by MuJoCo's compiler, not written in the file: {shown}"
            )
        if "refused" in self.answer and not judged_bodies(self.links, self.joints):
            _refused(self.text, self.answer["refused"])
        return Robot(
            self.answer["name"] or "model",
            tuple(self.links),
            tuple(self.joints),
            "mjcf",
            self.text.file,
            np.array(self.answer["gravity"]),
            (*self.text.inputs, *((name, digest) for name, digest in self.answer["inputs"])),
            unmodelled=tuple(self.unmodelled),
            notes=tuple(notes),
        )

    def _couplings(self) -> None:
        for found in self.answer["couplings"]:
            if found["mimic"] is not None and found["mimic"][0] not in self.mimics:
                name, followed, factor, offset = found["mimic"]
                offset += self.refs[name] - factor * self.refs[followed]
                self.mimics[name] = Mimic(followed, factor, offset)
                continue
            self.unmodelled.append(
                Unmodelled(
                    found["what"],
                    "couples joints or bodies beside the joints' own motion",
                    frozenset(found["joints"]),
                    frozenset(found["bodies"]),
                    self.text.place(found["line"], found["what"]),
                )
            )

    # --- bodies ----------------------------------------------------------------------------------

    def _body(self, body: dict[str, Any]) -> None:
        name, subject = body["name"], f"body {body['name']!r}"
        place = self.text.place(body["line"], subject)
        node = self.text.node(body["line"])
        pose = _pose(body)
        parent = body["parent"]
        moving = [joint for joint in body["joints"] if joint["kind"] != "free"]
        for joint in moving:
            link = name if joint is moving[-1] else self._between(joint["name"], place)
            self._moving(joint, parent, link, pose, node)
            parent, pose = link, Transform.identity()
        if not moving:
            fixed = f"{name} (fixed)"
            if body["joints"]:
                fixed = body["joints"][0]["name"]
                problem = "stands free in the world: read as fixed where the file puts it"
                self.log.add("JNT115", f"joint {fixed!r}", problem, place)
            self._fixed(fixed, parent, name, pose, place)
        inertial = self._inertial(body, subject, node, place)
        self.links.append(RobotLink(name, inertial, self._shapes(body, subject), place))
        if body["gravcomp"] != 0.0:
            problem = "gravcomp takes weight away from the body"
            self.unmodelled.append(
                Unmodelled(
                    f"{subject} gravcomp", problem, links=frozenset({WORLD, name}), place=place
                )
            )

    def _between(self, joint: str, place: Place) -> str:
        name = joint
        while name in self.names:
            name += "_link"
        self.names.add(name)
        self.links.append(RobotLink(name, None, place=place, between=True))
        return name

    def _inertial(
        self, body: dict[str, Any], subject: str, node: XmlNode | None, place: Place
    ) -> Inertial | None:
        weighed = body["weighed"]
        if weighed is not None:
            turn = _rpy(weighed["quat"])
            entries = dict.fromkeys(ENTRIES, 0.0)
            entries |= dict(zip(("ixx", "iyy", "izz"), weighed["moments"], strict=True))
            pos = np.array(weighed["pos"])
            return Inertial(weighed["mass"], pos, turn, entries, {}, {"inertial": place})
        written = None if node is None else next(node.all("inertial"), None)
        if not body["explicit"] or written is None:
            return None
        where = f"{subject} inertial"
        (mass,) = numbers(written, "mass", where, None) or [np.nan]
        given = numbers(written, "pos", where, None)
        if written.get("pos") is None:
            given = [0.0] * 3
        elif len(given) != 3:
            given = [np.nan] * 3
        key = "fullinertia" if written.get("fullinertia") is not None else "diaginertia"
        values = numbers(written, key, where, None)
        names = _FULL if key == "fullinertia" else _FULL[:3]
        entries = dict.fromkeys(ENTRIES, 0.0 if values else np.nan)
        if not values and written.get(key) is None:
            problem = "has neither fullinertia nor diaginertia"
            self.log.add("XML104", where, problem, written.place())
        entries |= dict(zip(names, values, strict=len(values) > 0))
        places = {"inertial": written.place(None, where)}
        for part, attribute in (("mass", "mass"), ("origin", "pos"), ("inertia", key)):
            if written.get(attribute) is not None:
                places[part] = written.place(attribute, f"{where}/{part}")
        return Inertial(
            mass,
            np.array(given),
            _rpy(body["turn"]),
            entries,
            common_rounding(entries),
            places,
        )

    def _shapes(self, body: dict[str, Any], subject: str) -> tuple[ShapeRef, ...]:
        """None at all where one is of a kind not known here: the rest encloses too little."""
        shapes = []
        for geom in body["geoms"]:
            known = self.answer["shapes"].get(geom["name"])
            if known is None:
                return ()
            kind, size, pose = known["geometry"], geom["size"], _pose(geom)
            if kind == "mesh" and geom["moved"] is not None:
                pose = pose @ Transform.from_quaternion(*geom["moved"]).inverse()
            sizes = {
                "box": [2.0 * s for s in size],
                "sphere": size[:1],
                "mesh": known.get("scale"),
            }.get(kind, [size[0], 2.0 * size[1]])
            shapes.append(
                ShapeRef(
                    "visual" if known["visual"] else "collision",
                    kind,
                    tuple(sizes),
                    pose,
                    known.get("uri", ""),
                    self.text.place(geom["line"], f"{subject} geom"),
                )
            )
        return tuple(shapes)

    # --- joints ----------------------------------------------------------------------------------

    def _fixed(self, name: str, parent: str, child: str, pose: Transform, place: Place) -> None:
        x = np.array([1.0, 0.0, 0.0])
        self.joints.append(RobotJoint(name, "fixed", parent, child, pose, x, x, place=place))

    def _moving(
        self,
        joint: dict[str, Any],
        parent: str,
        child: str,
        pose: Transform,
        body: XmlNode | None,
    ) -> None:
        name, subject = joint["name"], f"joint {joint['name']!r}"
        place = self.text.place(joint["line"], subject)
        written, axis = _axis(self.answer.get("axes", {}).get(name, joint["axis"]))
        anchor = Transform.translation(joint["anchor"])
        carried = anchor.inverse()
        ref = joint["ref"]
        if ref != 0.0 and np.isfinite(axis).all():
            kind = "prismatic" if joint["kind"] == "prismatic" else "revolute"
            carried = Joint(name, axis, kind).motion(-ref) @ carried  # type: ignore[arg-type]
        motor = self.answer["motors"][name]
        lower, upper = joint["range"] or (-_UNLIMITED, _UNLIMITED)
        self.joints.append(
            RobotJoint(
                name,
                cast("JointKind", _kind(joint)),
                parent,
                child,
                pose @ anchor,
                axis,
                written,
                Limits(
                    None if lower == -_UNLIMITED else lower,
                    None if upper == _UNLIMITED else upper,
                    None,
                    motor["effort"],
                ),
                carried,
                armature=joint["armature"] + motor["armature"],
                damping=joint["damping"] + motor["damping"],
                friction=joint["friction"],
                mimic=self.mimics.get(name),
                rest=ref,
                place=place,
                places=self._places(joint, subject, body, motor["line"]),
            )
        )
        if joint["spring"]:
            what = f"{subject} stiffness"
            problem = "is a spring: its torque is no rigid body's"
            self.unmodelled.append(Unmodelled(what, problem, frozenset({name}), place=place))

    def _places(
        self, joint: dict[str, Any], subject: str, body: XmlNode | None, actuator: str
    ) -> dict[str, Place]:
        """Where its numbers stand; one that a default class gives stands at the joint."""
        node = self.text.node(joint["line"])
        if node is None:
            return {}
        found = {}
        for part, attribute in (
            ("axis", "axis"),
            ("lower", "range"),
            ("upper", "range"),
            ("limit", "range"),
            ("effort", "actuatorfrcrange"),
            ("damping", "damping"),
            ("friction", "frictionloss"),
        ):
            given = attribute if node.get(attribute) is not None else None
            found[part] = node.place(given, f"{subject} {attribute}")
        if joint["range"] is None:
            found = {key: found[key] for key in found if key not in ("lower", "upper", "limit")}
        if actuator:
            found["effort"] = self.text.place(actuator, f"{subject} actuator")
        if body is not None:
            found["origin"] = body.place("pos" if body.get("pos") is not None else None)
        return found


def _kind(joint: dict[str, Any]) -> str:
    return "continuous" if joint["kind"] == "revolute" and joint["range"] is None else joint["kind"]


def _pose(given: dict[str, Any]) -> Transform:
    return Transform.from_quaternion(given["pos"], given["quat"])


def _rpy(quaternion: list[float]) -> Array:
    from ..number_text import roll_pitch_yaw

    if not any(quaternion[1:]):
        return np.zeros(3)
    return np.array(roll_pitch_yaw(Transform.from_quaternion((0, 0, 0), quaternion).R))


def _axis(given: list[float]) -> tuple[Array, Array]:
    """As it is to be judged, and as a unit vector: MuJoCo takes any length that is a double's."""
    written = np.array(given)
    largest = float(np.abs(written).max())
    if not 1e-14 < largest < 1e100:
        return written, np.full(3, np.nan)
    length = float(np.linalg.norm(written))
    unit = abs(length - 1.0) <= np.finfo(float).eps
    axis = written if unit else written / length
    return axis, axis
