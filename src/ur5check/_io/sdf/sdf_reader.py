"""An SDF model to a `SerialArm`: poses from Drake (libsdformat), inertias from the text."""

from __future__ import annotations

import hashlib
import logging
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Literal, NoReturn

import numpy as np

from ..._errors import ModelError
from ..._robot import Inertia, Joint, Limits, SerialArm, Source, Transform
from ..chain_assembly import assemble
from ..model_format import ModelFile
from ..urdf.urdf_chain import Edge, Tree
from ..world_body import chain_from_world
from .sdf_text import SdfText

__all__ = ["read_sdf", "read_sdf_file"]

_WORLD = "world"


def read_sdf_file(file: ModelFile) -> SerialArm:
    """The arm in an SDF.  Raises ModelError as `read_sdf` does."""
    return read_sdf(file.data, file=file.label, base=file.base, tip=file.tip)


def read_sdf(
    data: bytes, *, file: str, base: str | None = None, tip: str | None = None
) -> SerialArm:
    """The arm between two links of the only model in an SDF file.

    data : the file's bytes;  file : what errors and reports call it
    base : link to start from (default: the model's root, or the link that is fixed to the world)
    tip : link to end at (default: the end of the only chain of moving joints)

    Raises ModelError for a faulty file, several models, an `<include>`, a moving link without
    `<inertial>`, a joint that is neither revolute nor prismatic, and where Drake refuses.
    """
    text = SdfText(data, file)
    plant, said = _parsed(text)
    model = _Links(plant, text)
    chain = chain_from_world(model.tree, base, tip)
    parts = assemble(model, chain)
    gravity, notes = text.gravity()
    return SerialArm(
        text.name,
        parts.joints,
        parts.links,
        base=parts.base,
        gravity=model.orientation(chain.base).T @ np.array(gravity),
        source=Source(
            "sdf",
            ((file, hashlib.sha256(data).hexdigest()),),
            base=chain.base,
            tip=chain.tip,
            notes=parts.notes + notes + said,
        ),
    )


def _parsed(text: SdfText) -> tuple[Any, tuple[str, ...]]:
    """Drake's plant and its captured warnings."""
    try:
        from pydrake.multibody.parsing import Parser
        from pydrake.multibody.plant import MultibodyPlant
    except ImportError:
        raise ModelError(
            "SDF is read through Drake, which is not installed here",
            fix="pip install 'ur5check[drake]'",
            file=text.reader.file,
        ) from None
    plant = MultibodyPlant(0.0)
    with _log_kept() as said:
        try:
            Parser(plant).AddModelsFromString(text.text, "sdf")
            _refuse_loops(plant, text)
            plant.Finalize()
        except RuntimeError as error:
            raise text.warnings_of_drake(error) from None
    return plant, tuple(f"Drake says: {text.in_our_words(line)}" for line in said)


def _refuse_loops(plant: Any, text: SdfText) -> None:
    """Checked here since Drake's error names neither joint nor link."""
    moved_by: dict[str, str] = {}
    for joint in map(plant.get_joint, plant.GetJointIndices()):
        child, name = joint.child_body().name(), joint.name()
        if child in moved_by:
            problem = f"link {child!r} has two parents: joint {moved_by[child]!r} moves it already"
            text.fail(text.joints[name], f"joint {name!r}", problem, "cut the loop at one joint")
        moved_by[child] = name


@contextmanager
def _log_kept() -> Iterator[list[str]]:
    """Drake's warnings become notes instead of lines on stderr."""
    said: list[str] = []
    logger, handler = logging.getLogger("drake"), logging.Handler(logging.WARNING)
    handler.emit = lambda record: said.append(record.getMessage())  # type: ignore[method-assign]
    before = logger.propagate
    logger.addHandler(handler)
    logger.propagate = False
    try:
        yield said
    finally:
        logger.removeHandler(handler)
        logger.propagate = before


class _Links:
    """A `Description` of Drake's plant."""

    def __init__(self, plant: Any, text: SdfText) -> None:
        self._plant, self._text = plant, text
        self._joints = {
            joint.name(): joint
            for joint in map(plant.get_joint, plant.GetJointIndices())
            if not joint.is_ephemeral()
        }
        actuators = map(plant.get_joint_actuator, plant.GetJointActuatorIndices())
        self._actuators = {actuator.joint().name(): actuator for actuator in actuators}
        edges = [
            Edge(name, _kind(joint), joint.parent_body().name(), joint.child_body().name())
            for name, joint in self._joints.items()
        ]
        self.tree = Tree(self._checked(edges), edges, text.reader.file)

    def joint(self, edge: Edge) -> Joint:
        """Raises ModelError for a joint that is neither revolute nor prismatic, or mimics."""
        joint, node = self._joints[edge.joint], self._text.joints[edge.joint]
        if edge.kind not in ("revolute", "prismatic"):
            fix = "choose base= and tip= so that it lies outside the arm"
            problem = f"is {edge.kind}: neither revolute nor prismatic"
            self.fail("joint", edge.joint, "", problem, fix)
        if node.find("axis/mimic") is not None:
            fix = "choose a tip= before it, or remove <mimic>"
            self.fail("joint", edge.joint, "", "mimics another: no coordinate of its own", fix)
        if float(node.findtext("axis/dynamics/spring_stiffness") or 0.0) != 0.0:
            fix = "remove it: its torque is no rigid body's"
            self.fail("joint", edge.joint, " spring_stiffness", "is a spring", fix)
        revolute = edge.kind == "revolute"
        kind: Literal["revolute", "prismatic"] = "revolute" if revolute else "prismatic"
        axis = joint.revolute_axis() if revolute else joint.translation_axis()
        actuator = self._actuators.get(edge.joint)
        limits = Limits(
            _finite(joint.position_lower_limit()),
            _finite(joint.position_upper_limit()),
            _finite(joint.velocity_upper_limit()),
            None if actuator is None else _finite(actuator.effort_limit()),
        )
        armature = 0.0
        if actuator is not None:
            armature = actuator.default_rotor_inertia() * actuator.default_gear_ratio() ** 2
        return Joint(edge.joint, axis, kind, limits, armature, *self._text.losses(edge.joint))

    def joint_origin(self, edge: Edge) -> Transform:
        return _transform(self._joints[edge.joint].frame_on_parent().GetFixedPoseInBodyFrame())

    def carried(self, edge: Edge) -> Transform:
        frame = self._joints[edge.joint].frame_on_child()
        return _transform(frame.GetFixedPoseInBodyFrame()).inverse()

    def held_pose(self, edge: Edge, moving: frozenset[str]) -> Transform:
        return self.joint_origin(edge) @ self.carried(edge)

    def inertia(self, link: str) -> Inertia | None:
        return self._text.inertia(link)

    def orientation(self, link: str) -> Any:
        """R from a link to the world, shape (3, 3), in the posture that the file describes."""
        body = self._plant.world_body() if link == _WORLD else self._plant.GetBodyByName(link)
        context = self._plant.CreateDefaultContext()
        return self._plant.EvalBodyPoseInWorld(context, body).rotation().matrix()

    def fail(
        self,
        tag: Literal["link", "joint"],
        name: str,
        part: str,
        problem: str,
        fix: str,
        rule: str = "XML100",
    ) -> NoReturn:
        """Raise ModelError at a link or joint."""
        node = (self._text.joints if tag == "joint" else self._text.links)[name]
        self._text.fail(node, f"{tag} {name!r}{part}", problem, fix, rule=rule)

    def _checked(self, edges: list[Edge]) -> list[str]:
        """The links, of which the joints must make one tree."""
        links = list(self._text.links)
        if any(edge.parent == _WORLD for edge in edges):
            links.insert(0, _WORLD)
        children = {edge.child for edge in edges}
        roots = [link for link in links if link not in children]
        if len(roots) != 1:
            shown = ", ".join(map(repr, roots[:6]))
            problem = f"the model holds {len(roots)} separate trees, from {shown}"
            self._text.fail(self._text.model, "<model>", problem, "join them with joints")
        return links


def _kind(joint: Any) -> str:
    return "fixed" if joint.type_name() == "weld" else str(joint.type_name())


def _transform(X: Any) -> Transform:
    return Transform(X.rotation().matrix(), X.translation())


def _finite(limit: float) -> float | None:
    return float(limit) if np.isfinite(limit) else None
