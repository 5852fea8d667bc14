"""iDynTree as reference engine: `KinDynComputations` on its base link, which is fixed.

iDynTree has floating bases only.  A fixed base is one that does not accelerate, so the joints'
rows and columns of its equations are those of the arm.  It offers no forward dynamics of such an
arm: its own mass matrix and bias are solved for the acceleration.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import metadata
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..._errors import EngineError
from ..._robot.inertia import Inertia
from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.serial_arm import STANDARD_GRAVITY, Joint, Limits
from ..._robot.transforms import Array, Transform
from ..captured_warnings import captured_output
from ..each_state import each_state
from ..engine_entry import EngineEntry
from ..engine_urdf import text_for_engines
from ..imported_model import ImportedBody, ImportedModel
from ..known_issue import KnownIssue
from ..lazy_import import lazy_import

__all__ = ["ENTRY", "IDynTreeEngine"]

# SWIG's types raise DeprecationWarnings while they are created, and crash the interpreter where
# warnings are errors.
idyn = lazy_import("idyntree.bindings", ignored=DeprecationWarning)


class IDynTreeEngine:
    """iDynTree's algorithms on one arm or robot; satisfies `engine.Engine`.

    arm : an arm, or a tree without mimic joints;  gravity : in its base frame [m/s²], its own when
        None.

    Raises EngineError if iDynTree refuses the model.
    """

    name = "iDynTree"

    def __init__(self, arm: ArmOrTree, gravity: ArrayLike | None = None) -> None:
        self.arm = arm
        self.version = metadata.version("idyntree")
        self.route = "URDF text, own parser" if arm.source.urdf else type(arm).__name__
        self._computing = idyn.KinDynComputations()
        with captured_output() as lines:
            self.model = _built(arm) if arm.source.urdf is None else _parsed(arm)
            taken = self.model is not None and self._computing.loadRobotModel(self.model)
        self.warnings = tuple(lines)
        if not taken:
            reason = " ".join(self.warnings[:2]) or "no reason given"
            raise EngineError(f"iDynTree cannot take the model of {arm.name!r}: {reason}")
        self._ids = [self._joint_id(name) for name in arm.joint_names]
        self._order = [self.model.getJoint(k).getDOFsOffset() for k in self._ids]
        self._gravity = _vector((0.0, 0.0, 0.0))
        self._place(np.zeros(arm.n), np.zeros(arm.n))
        base = arm.source.base if self.arm.source.urdf is not None else "base"
        self._T_base_world = self._frame(base).inverse()
        # It has no gravity of its own: every call takes one as an argument.
        self._gravity_read = np.array(STANDARD_GRAVITY)
        g = np.asarray(arm.gravity if gravity is None else gravity, dtype=np.float64)
        self._gravity = _vector(self._T_base_world.R.T @ g)

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool in the base frame, from `getWorldTransform`."""

        def pose(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            return self._tool().matrix()

        return each_state(pose, self.arm.n, (4, 4), q)

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Torques from `inverseDynamics`."""
        torques = idyn.FreeFloatingGeneralizedTorques(self.model)
        wrenches, still = idyn.LinkWrenches(self.model), idyn.Vector6()
        wrenches.zero()
        still.zero()

        def torque(x: Array, v: Array, a: Array) -> Array:
            self._place(x, v)
            self._computing.inverseDynamics(still, self._ordered(a), wrenches, torques)
            return self._of(_numbers(torques.jointTorques()))

        return self._each(torque, q, qd, qdd)

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Accelerations: its M and its bias, solved."""
        rest = np.asarray(tau) - self.bias_torque(q, qd)
        return np.asarray(np.linalg.solve(self.mass_matrix(q), rest[..., None])[..., 0])

    def mass_matrix(self, q: Array) -> Array:
        """M: the joints' block of `getFreeFloatingMassMatrix`."""
        size = self.model.getNrOfDOFs() + 6
        whole = idyn.MatrixDynSize(size, size)

        def mass(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            self._computing.getFreeFloatingMassMatrix(whole)
            return _numbers(whole)[6:, 6:][np.ix_(self._order, self._order)]

        return each_state(mass, self.arm.n, (self.arm.n, self.arm.n), q)

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """C q̇ + g from `generalizedBiasForces`."""
        torques = idyn.FreeFloatingGeneralizedTorques(self.model)

        def bias(x: Array, v: Array) -> Array:
            self._place(x, v)
            self._computing.generalizedBiasForces(torques)
            return self._of(_numbers(torques.jointTorques()))

        return self._each(bias, q, qd)

    def gravity_torque(self, q: Array) -> Array:
        """g from `generalizedGravityForces`."""
        torques = idyn.FreeFloatingGeneralizedTorques(self.model)

        def gravity(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            self._computing.generalizedGravityForces(torques)
            return self._of(_numbers(torques.jointTorques()))

        return self._each(gravity, q)

    def imported_model(self) -> ImportedModel:
        """The `Model`: massless links at the ends have become frames."""
        self._place(np.zeros(self.arm.n), np.zeros(self.arm.n))
        moving = sorted(self._ids, key=lambda k: self.model.getJoint(k).getDOFsOffset())
        return ImportedModel(
            tuple(self._imported_joint(k) for k in moving),
            np.array([self._child_frame(k).p for k in moving]),
            tuple(self._imported_body(k) for k in range(self.model.getNrOfLinks())),
            self._gravity_read,
            self._tool().matrix(),
            int(self.model.getNrOfPosCoords()),
            self.warnings,
        )

    def _imported_joint(self, k: int) -> Joint:
        joint = self.model.getJoint(k)
        child = joint.getSecondAttachedLink()
        sliding = joint.isPrismaticJoint()
        as_kind = joint.asPrismaticJoint() if sliding else joint.asRevoluteJoint()
        axis = as_kind.getAxis(child, joint.getFirstAttachedLink())
        direction = axis.getDirection()
        return Joint(
            str(self.model.getJointName(k)),
            self._child_frame(k).R @ _numbers(direction),
            "prismatic" if sliding else "revolute",
            Limits(
                joint.getMinPosLimit(0) if joint.hasPosLimits() else None,
                joint.getMaxPosLimit(0) if joint.hasPosLimits() else None,
                joint.getVelocityLimit(0) if joint.hasVelocityLimits() else None,
                joint.getEffortLimit(0) if joint.hasEffortLimits() else None,
            ),
            0.0,  # iDynTree's joints have no armature
            float(joint.getDamping(0)),
            float(joint.getStaticFriction(0)),
        )

    def _child_frame(self, k: int) -> Transform:
        """Pose of the link that joint k moves, whose origin lies on the joint."""
        child = self.model.getLinkName(self.model.getJoint(k).getSecondAttachedLink())
        return self._T_base_world @ self._frame(child)

    def _imported_body(self, k: int) -> ImportedBody:
        own = self.model.getLink(k).getInertia()
        name = str(self.model.getLinkName(k))
        inertia = Inertia.zero()
        if own.getMass() != 0.0:
            com, about_com = own.getCenterOfMass(), own.getRotationalInertiaWrtCenterOfMass()
            inertia = Inertia(own.getMass(), _numbers(com), _numbers(about_com))
        here = inertia.expressed_in(self._T_base_world @ self._frame(name))
        return ImportedBody(name, self._carrier(k), here)

    def _carrier(self, link: int) -> int | None:
        """The arm's joint that carries a link; joints lead from their first link to the second."""
        above = {
            joint.getSecondAttachedLink(): (k, joint)
            for k in range(self.model.getNrOfJoints())
            if (joint := self.model.getJoint(k))
        }
        while link in above:
            k, joint = above[link]
            if joint.getNrOfDOFs():
                return self._ids.index(k)
            link = joint.getFirstAttachedLink()
        return None

    def _joint_id(self, name: str) -> int:
        found = int(self.model.getJointIndex(name))
        if found < 0:
            raise EngineError(f"iDynTree's model of {self.arm.name!r} lacks joint {name!r}")
        return found

    def _frame(self, name: str) -> Transform:
        """Pose of a frame in iDynTree's world, where its base link stands."""
        T = _numbers(self._computing.getWorldTransform(name).asHomogeneousTransform())
        return Transform(T[:3, :3], T[:3, 3])

    def _tool(self) -> Transform:
        if self.arm.source.urdf is None:
            last = self._frame(_link_name(self.arm.n))
            return last @ tree_links(self.arm)[-1].link.link_tip_frame
        return self._T_base_world @ self._frame(self.arm.source.tip)

    def _place(self, q: Array, qd: Array) -> None:
        self._computing.setRobotState(
            idyn.Transform.Identity(),
            self._ordered(q),
            idyn.Twist.Zero(),
            self._ordered(qd),
            self._gravity,
        )

    def _ordered(self, values: Array) -> Any:
        ordered = np.empty(self.arm.n)
        ordered[self._order] = values
        return idyn.VectorDynSize.FromPython(ordered)

    def _of(self, values: Array) -> Array:
        return np.array(values)[self._order]

    def _each(self, one: Callable[..., Array], *arrays: Array) -> Array:
        return each_state(one, self.arm.n, (self.arm.n,), *arrays)


def _parsed(arm: ArmOrTree) -> Any:
    loader = idyn.ModelLoader()
    return loader.model().copy() if loader.loadModelFromString(text_for_engines(arm)) else None


def _built(arm: ArmOrTree) -> Any:
    """The arm passed joint by joint; its links are named by their numbers."""
    model = idyn.Model()
    model.addLink("base", _link(Inertia.zero()))
    tips = [Transform.identity()]
    for i, each in enumerate(tree_links(arm), start=1):
        joint, link, parent = each.joint, each.link, each.parent + 1
        model.addLink(_link_name(i), _link(link.inertia.expressed_in(link.link_tip_frame)))
        added = idyn.PrismaticJoint() if joint.kind == "prismatic" else idyn.RevoluteJoint()
        added.setAttachedLinks(parent, i)
        added.setRestTransform(_transform(tips[parent] @ each.origin))
        direction = idyn.Direction(*map(float, joint.axis))
        added.setAxis(idyn.Axis(direction, idyn.Position.Zero()), i, parent)
        model.addJoint(joint.name, added)
        tips.append(link.link_tip_frame)
    model.setDefaultBaseLink(0)
    return model


def _numbers(array: Any) -> Array:
    """A copy: iDynTree's arrays are views, which die with the object they look into."""
    return np.array(array.toNumPy(), dtype=np.float64)


def _link_name(i: int) -> str:
    return f"link {i}"


def _link(inertia: Inertia) -> Any:
    spatial = idyn.SpatialInertia()
    spatial.fromVector(_six(inertia.parameters()))
    link = idyn.Link()
    link.setInertia(spatial)
    return link


def _six(parameters: Array) -> Any:
    """Ten parameters in iDynTree's order: m, m c, then Ixx Ixy Ixz Iyy Iyz Izz."""
    vector = idyn.Vector10()
    for k, of in enumerate((0, 1, 2, 3, 4, 5, 7, 6, 8, 9)):
        vector.setVal(k, float(parameters[of]))
    return vector


def _transform(T: Transform) -> Any:
    rotation, position = idyn.Rotation(), _position(T.p)
    for i in range(3):
        for j in range(3):
            rotation.setVal(i, j, float(T.R[i, j]))
    return idyn.Transform(rotation, position)


def _position(p: Array) -> Any:
    return idyn.Position(*map(float, p))


def _vector(values: ArrayLike) -> Any:
    vector = idyn.Vector3()
    for i, value in enumerate(np.asarray(values, dtype=np.float64)):
        vector.setVal(i, float(value))
    return vector


_KNOWN_ISSUES = (
    KnownIssue(
        id="idyntree-links-become-frames",
        engine="idyntree",
        measured="15.1",
        kinds=("body-lost", "body-merged"),
        harmful=False,
        title="massless links at the ends become frames",
        explanation="A link without <inertial> behind a fixed joint is kept as a frame of its "
        "parent.",
        fix="none is needed: torques do not change",
    ),
    KnownIssue(
        id="idyntree-keeps-base",
        engine="idyntree",
        measured="15.1",
        kinds=("base-kept",),
        harmful=False,
        title="the base keeps its inertia",
        explanation="iDynTree's base floats, so its inertia is part of the model; a fixed base "
        "loads no joint.",
        fix="none is needed: torques do not change",
    ),
    KnownIssue(
        id="idyntree-continuous-limits",
        engine="idyntree",
        measured="15.1",
        kinds=("position-limit",),
        harmful=False,
        title="a continuous joint has limits of 0",
        explanation="With a <limit> for effort and velocity, a continuous joint reports position "
        "limits, both 0.",
        fix="read the limits of revolute joints only",
    ),
    KnownIssue(
        id="idyntree-no-motor-inertia",
        engine="idyntree",
        measured="15.1",
        kinds=("armature",),
        harmful=True,
        title="motor inertia is not kept",
        explanation="iDynTree's joints have no armature.",
        fix="add it to the mass matrix, or compare without it",
    ),
)

ENTRY = EngineEntry(
    key="idyntree",
    title="iDynTree",
    order=50,
    make=IDynTreeEngine,
    module=idyn,
    distribution="idyntree",
    extra="idyntree",
    known_issues=_KNOWN_ISSUES,
)
