"""Bodies and joints of a compiled MuJoCo model, as the tree that an arm is taken from.

MuJoCo applies the joints of one body one after the other, each about its own anchor in the body's
frame: T_parent→body = T · Trans(a) J(q) Trans(−a) · …  All but the last of several joints get a
massless link of their own.  A joint's `ref` is its coordinate in the posture that the file
describes.

Numbers are taken from the file where it states them, since MuJoCo's compiler keeps tensors only as
principal moments; and from the compiler where it computes them (angles other than
quaternions, `<frame>`s, masses from shapes, `settotalmass` and its kin).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Literal, NoReturn

import numpy as np

from ..._errors import ModelError
from ..._robot import Inertia, Joint, Limits, Transform
from ..._robot.transforms import Array
from ..urdf.urdf_chain import Edge, Tree
from .mjcf_text import MjcfText

__all__ = ["Bodies", "name_all"]

WORLD = "world"
_KINDS = {"mjJNT_HINGE": "revolute", "mjJNT_SLIDE": "prismatic"}
_UNLIMITED = np.finfo(float).max
_SPRING = "remove it: its torque is no rigid body's"


def name_all(spec: Any) -> None:
    """Give a name to every body and joint that has none; MJCF does not require names."""
    for kind, elements in (("body", spec.bodies), ("joint", spec.joints)):
        taken = {element.name for element in elements}
        for number, element in enumerate(elements):
            name = f"{kind}_{number}"
            while not element.name:
                element.name = "" if name in taken else name
                name += "_"


class Bodies:
    """A `Description` of a model's bodies.

    spec, model : MuJoCo's parsed text and the compiled model
    sites : those that are used as frames, by name, because `base` or `tip` names them
    efforts : largest effort of the actuators at a joint, where that is one number
    """

    def __init__(
        self,
        spec: Any,
        model: Any,
        text: MjcfText,
        *,
        sites: Iterable[str] = (),
        efforts: dict[str, float],
    ) -> None:
        self._model, self._text, self._efforts = model, text, efforts
        self._bodies = {body.name: body for body in spec.bodies}
        self._joints = {joint.name: joint for joint in spec.joints}
        self._sites = {site.name: site for site in spec.sites if site.name in set(sites)}
        self._changed = _changed_by_compiler(spec.compiler)
        self.weighed: list[str] = []
        self.massless: set[str] = set()
        links, edges = [WORLD], []
        for body in spec.bodies:
            if body.name == WORLD:
                continue
            above = body.parent.name
            for joint in body.joints[:-1]:
                between = _unused(joint.name, {*self._bodies, *links})
                self.massless.add(between)
                links.append(between)
                edges.append(Edge(joint.name, _kind(joint), above, between))
                above = between
            name, kind = f"{body.name} (fixed)", "fixed"
            if body.joints:
                name, kind = body.joints[-1].name, _kind(body.joints[-1])
            links.append(body.name)
            edges.append(Edge(name, kind, above, body.name))
        for site in self._sites.values():
            links.append(site.name)
            edges.append(Edge(f"{site.name} (site)", "fixed", site.parent.name, site.name))
        self.tree = Tree(links, edges, text.file)

    def joint(self, edge: Edge) -> Joint:
        """Limits and losses included.  Raises ModelError for a spring, a ball, a free body."""
        spec = self._joints[edge.joint]
        if edge.kind not in _KINDS.values():
            fix = "choose base= and tip= so that it lies outside the arm"
            self.fail("joint", edge.joint, "", f"is {edge.kind}: neither hinge nor slide", fix)
        index, dof = self._model.joint(edge.joint).id, self._model.joint(edge.joint).dofadr[0]
        if self._model.jnt_stiffness[index] != 0.0:
            self.fail("joint", edge.joint, " stiffness", "is a spring", _SPRING)
        axis = spec.axis if spec.frame is None else self._model.jnt_axis[index]
        kind: Literal["revolute", "prismatic"] = (
            "prismatic" if edge.kind == "prismatic" else "revolute"
        )
        return Joint(
            edge.joint,
            np.array(axis),
            kind,
            self._limits(index, edge.joint),
            armature=float(self._model.dof_armature[dof]),
            damping=float(self._model.dof_damping[dof]),
            friction=float(self._model.dof_frictionloss[dof]),
        )

    def joint_origin(self, edge: Edge) -> Transform:
        """Of a body's first joint: the body's pose and the anchor.  Of the others: the anchor."""
        if edge.joint not in self._joints:
            return self._pose(edge.child)
        body = self._joints[edge.joint].parent
        anchor = Transform.translation(self._anchor(edge.joint))
        first = body.joints[0].name == edge.joint
        return self._pose(body.name) @ anchor if first else anchor

    def carried(self, edge: Edge) -> Transform:
        """Back by `ref` and from the anchor to the body's own frame."""
        if edge.joint not in self._joints:
            return Transform.identity()
        back = Transform.translation(-self._anchor(edge.joint))
        ref = self._reference(edge)
        return back if ref == 0.0 else self.joint(edge).motion(-ref) @ back

    def held_pose(self, edge: Edge, moving: frozenset[str]) -> Transform:
        """In the posture that the file describes, a joint changes nothing."""
        pose = self.joint_origin(edge)
        if edge.joint in self._joints:
            pose = pose @ Transform.translation(-self._anchor(edge.joint))
        return pose

    def inertia(self, link: str) -> Inertia | None:
        """A body's inertia: from the file, or computed by MuJoCo from the body's shapes."""
        if link in self.massless:
            return Inertia.zero()
        body = self._bodies.get(link)
        if body is None or link == WORLD:
            return None
        index = self._model.body(link).id
        if self._model.body_mass[index] == 0.0 and not body.explicitinertial:
            return None
        if body.gravcomp != 0.0:
            fix = "remove gravcomp: the force that holds the body up is no rigid body's"
            self.fail("link", link, " gravcomp", "takes weight away from the body", fix)
        if not body.explicitinertial or self._changed:
            self.weighed.append(link)
            return self._compiled_inertia(index)
        return _written_inertia(body, self._model.body_iquat[index])

    def fail(
        self,
        tag: Literal["link", "joint"],
        name: str,
        part: str,
        problem: str,
        fix: str,
        rule: str = "XML100",
    ) -> NoReturn:
        """Raise ModelError at a body or joint."""
        node = self._joints.get(name) if tag == "joint" else self._bodies.get(name)
        # MuJoCo keeps no line of a <freejoint>; its body's line is used.
        info = "" if node is None else node.info or node.parent.info
        file, line = self._text.place(info)
        word = "body" if tag == "link" else tag
        element = f"{word} {name!r}{part}"
        raise ModelError(problem, fix=fix, file=file, line=line, element=element, rule=rule)

    def _limits(self, index: int, name: str) -> Limits:
        lower, upper = self._model.jnt_range[index] if self._model.jnt_limited[index] else (
            -_UNLIMITED, _UNLIMITED,
        )  # fmt: skip
        return Limits(
            lower=None if lower == -_UNLIMITED else float(lower),
            upper=None if upper == _UNLIMITED else float(upper),
            effort=self._efforts.get(name),
        )

    def _anchor(self, joint: str) -> Array:
        spec = self._joints[joint]
        return np.array(
            spec.pos if spec.frame is None else self._model.jnt_pos[self._model.joint(joint).id]
        )

    def _reference(self, edge: Edge) -> float:
        if edge.kind not in _KINDS.values():
            return 0.0
        return float(self._model.qpos0[self._model.joint(edge.joint).qposadr[0]])

    def _pose(self, link: str) -> Transform:
        """Pose of a body or site in the body above it."""
        site = self._sites.get(link)
        if site is not None and link not in self._bodies:
            index = self._model.site(link).id
            return self._written_pose(
                site, self._model.site_pos[index], self._model.site_quat[index]
            )
        index = self._model.body(link).id
        return self._written_pose(
            self._bodies[link], self._model.body_pos[index], self._model.body_quat[index]
        )

    @staticmethod
    def _written_pose(spec: Any, pos: Array, quat: Array) -> Transform:
        plain = spec.frame is None and spec.alt.type.name == "mjORIENTATION_QUAT"
        return Transform.from_quaternion(spec.pos if plain else pos, spec.quat if plain else quat)

    def _compiled_inertia(self, index: int) -> Inertia:
        pose = Transform.from_quaternion(
            self._model.body_ipos[index], self._model.body_iquat[index]
        )
        principal = np.diag(self._model.body_inertia[index])
        return Inertia(self._model.body_mass[index], np.zeros(3), principal).expressed_in(pose)


def _written_inertia(body: Any, compiled_quat: Array) -> Inertia:
    if not np.isnan(body.fullinertia[0]):
        xx, yy, zz, xy, xz, yz = body.fullinertia
        return Inertia.from_entries(
            body.mass, body.ipos, ixx=xx, iyy=yy, izz=zz, ixy=xy, ixz=xz, iyz=yz
        )
    plain = body.ialt.type.name == "mjORIENTATION_QUAT"
    pose = Transform.from_quaternion(body.ipos, body.iquat if plain else compiled_quat)
    return Inertia(body.mass, np.zeros(3), np.diag(body.inertia)).expressed_in(pose)


def _changed_by_compiler(compiler: Any) -> bool:
    """Whether a compiler option changes the masses of the file."""
    return (
        compiler.inertiafromgeom.name == "mjINERTIAFROMGEOM_TRUE"
        or compiler.settotalmass > 0.0
        or compiler.boundmass > 0.0
        or compiler.boundinertia > 0.0
        or bool(compiler.balanceinertia)
    )


def _kind(joint: Any) -> str:
    name = str(joint.type.name)
    return _KINDS.get(name, name.removeprefix("mjJNT_").lower())


def _unused(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_link"
    return name
