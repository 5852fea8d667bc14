"""DART as reference engine: its inverse dynamics, articulated-body forward dynamics, and mass
matrix.

`dartpy` parses with urdfdom, as Pinocchio does, but keeps a body for every link.  Damping, dry
friction and springs are set to zero after their values have been recorded for `imported_model`:
DART adds damping to its articulated inertia, and what is compared is the rigid-body model.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from lxml import etree
from numpy.typing import ArrayLike

from ..._errors import EngineError
from ..._robot.inertia import Inertia
from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.serial_arm import Joint, Limits, Link
from ..._robot.transforms import Array, Transform
from ..captured_warnings import captured_output
from ..each_state import each_state
from ..engine_entry import EngineEntry
from ..engine_urdf import text_for_engines
from ..imported_model import ImportedBody, ImportedModel
from ..known_issue import KnownIssue
from ..lazy_import import lazy_import
from ..urdf_repairs import fix_root_to_world

__all__ = ["ENTRY", "DartEngine"]

dartpy = lazy_import("dartpy")

_NO_EXTERNAL_FORCES = (False, False, False)  # nor damping, nor springs


class DartEngine:
    """DART's algorithms on one arm or robot; satisfies `engine.Stepper`.

    arm : an arm, or a tree without mimic joints;  gravity : in its base frame [m/s²], its own when
        None.

    Raises EngineError if DART refuses the model.
    """

    name = "DART"
    #: as `World.step` does it: velocities first, then positions with the new ones
    integrators: ClassVar[dict[str, int]] = {"semi-implicit": 1}

    def __init__(self, arm: ArmOrTree, gravity: ArrayLike | None = None) -> None:
        self.arm = arm
        self.version = str(dartpy.__version__)
        self.route = "URDF text, own parser" if arm.source.urdf else type(arm).__name__
        with captured_output() as lines:
            skeleton = _built(arm) if arm.source.urdf is None else _parsed(arm)
        if skeleton is None:
            raise EngineError(
                f"DART cannot take the model of {arm.name!r}: {' '.join(lines[:2]) or 'no reason'}"
            )
        self.skeleton, self.warnings = skeleton, tuple(lines)
        self._dofs = [self._dof(name) for name in arm.joint_names]
        self._order = [dof.getIndexInSkeleton() for dof in self._dofs]
        # DART starts a joint in the middle of its range where that leaves zero out.
        skeleton.setPositions(np.zeros(arm.n))
        base = None if self.arm.source.urdf is None else skeleton.getBodyNode(arm.source.base)
        self._T_base_world = Transform.identity() if base is None else _pose(base).inverse()
        self._joints = tuple(self._imported_joint(k) for k in range(skeleton.getNumDofs()))
        for dof in self._dofs:
            dof.setDampingCoefficient(0.0)
            dof.setCoulombFriction(0.0)
            dof.setSpringStiffness(0.0)
        R = self._T_base_world.R
        self._gravity_read = R @ skeleton.getGravity()
        g = np.asarray(arm.gravity if gravity is None else gravity, dtype=np.float64)
        skeleton.setGravity(R.T @ g)

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool in the base frame, from the tool body's world transform."""

        def pose(x: Array) -> Array:
            self._set(self.skeleton.setPositions, x)
            return self._tool().matrix()

        return each_state(pose, self.arm.n, (4, 4), q)

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Torques from `computeInverseDynamics`."""

        def torque(x: Array, v: Array, a: Array) -> Array:
            self._place(x, v)
            self._set(self.skeleton.setAccelerations, a)
            self.skeleton.computeInverseDynamics(*_NO_EXTERNAL_FORCES)
            return self._of(self.skeleton.getForces())

        return self._each(torque, q, qd, qdd)

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Accelerations from `computeForwardDynamics`."""

        def acceleration(x: Array, v: Array, t: Array) -> Array:
            self._place(x, v)
            self._set(self.skeleton.setForces, t)
            self.skeleton.computeForwardDynamics()
            return self._of(self.skeleton.getAccelerations())

        return self._each(acceleration, q, qd, tau)

    def mass_matrix(self, q: Array) -> Array:
        """M from `getMassMatrix`."""

        def mass(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            return np.asarray(self.skeleton.getMassMatrix())[np.ix_(self._order, self._order)]

        return each_state(mass, self.arm.n, (self.arm.n, self.arm.n), q)

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """C q̇ + g from `getCoriolisAndGravityForces`."""

        def bias(x: Array, v: Array) -> Array:
            self._place(x, v)
            return self._of(self.skeleton.getCoriolisAndGravityForces())

        return self._each(bias, q, qd)

    def gravity_torque(self, q: Array) -> Array:
        """g from `getGravityForces`."""

        def gravity(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            return self._of(self.skeleton.getGravityForces())

        return self._each(gravity, q)

    def step(
        self, q: Array, qd: Array, tau: Array, dt: float, integrator: str | None = None
    ) -> tuple[Array, Array]:
        """(q, q̇) after one step of `dt` [s], in the order in which `World.step` takes it."""
        self.skeleton.setTimeStep(dt)
        self._place(q, qd)
        self._set(self.skeleton.setForces, tau)
        self.skeleton.computeForwardDynamics()
        self.skeleton.integrateVelocities(dt)
        self.skeleton.integratePositions(dt)
        return self._of(self.skeleton.getPositions()), self._of(self.skeleton.getVelocities())

    def imported_model(self) -> ImportedModel:
        """The `Skeleton`: a body for every link."""
        zero = np.zeros(self.arm.n)
        self._place(zero, zero)
        nodes = [self.skeleton.getBodyNode(k) for k in range(self.skeleton.getNumBodyNodes())]
        return ImportedModel(
            self._joints,
            np.array([self._joint_frame(joint.name).p for joint in self._joints]),
            tuple(self._imported_body(node) for node in nodes),
            self._gravity_read,
            self._tool().matrix(),
            int(self.skeleton.getNumDofs()),
            self.warnings,
        )

    def _imported_joint(self, k: int) -> Joint:
        dof = self.skeleton.getDof(k)
        joint = self.skeleton.getJoint(dof.getName())
        sliding = joint.getType() == "PrismaticJoint"
        return Joint(
            str(dof.getName()),
            self._joint_frame(joint.getName()).R @ joint.getAxis(),
            "prismatic" if sliding else "revolute",
            Limits(
                _finite(dof.getPositionLowerLimit()),
                _finite(dof.getPositionUpperLimit()),
                _finite(dof.getVelocityUpperLimit()),
                _finite(dof.getForceUpperLimit()),
            ),
            0.0,  # DART's joints have no armature
            float(dof.getDampingCoefficient()),
            float(dof.getCoulombFriction()),
        )

    def _joint_frame(self, name: str) -> Transform:
        """Pose of a joint's frame, which it does not move, in the base frame."""
        joint = self.skeleton.getJoint(name)
        seen = joint.getTransformFromChildBodyNode()
        child = self._T_base_world @ _pose(joint.getChildBodyNode())
        return child @ Transform(seen.rotation(), seen.translation())

    def _imported_body(self, node: Any) -> ImportedBody:
        own = node.getInertia()
        inertia = Inertia(own.getMass(), own.getLocalCOM(), own.getMoment())
        here = inertia.expressed_in(self._T_base_world @ _pose(node))
        return ImportedBody(str(node.getName()), self._carrier(node), here)

    def _carrier(self, node: Any) -> int | None:
        while node is not None:
            joint = node.getParentJoint()
            if joint.getNumDofs():
                return self._order.index(joint.getIndexInSkeleton(0))
            node = node.getParentBodyNode()
        return None

    def _dof(self, name: str) -> Any:
        dof = self.skeleton.getDof(name)
        if dof is None:
            raise EngineError(f"DART's model of {self.arm.name!r} lacks joint {name!r}")
        return dof

    def _tool(self) -> Transform:
        if self.arm.source.urdf is None:
            last = self.skeleton.getBodyNode(self.skeleton.getNumBodyNodes() - 1)
            return _pose(last) @ tree_links(self.arm)[-1].link.link_tip_frame
        return self._T_base_world @ _pose(self.skeleton.getBodyNode(self.arm.source.tip))

    def _place(self, q: Array, qd: Array) -> None:
        self._set(self.skeleton.setPositions, q)
        self._set(self.skeleton.setVelocities, qd)

    def _set(self, setter: Callable[[Array], None], values: Array) -> None:
        ordered = np.empty(self.arm.n)
        ordered[self._order] = values
        setter(ordered)

    def _of(self, values: Array) -> Array:
        return np.array(values)[self._order]

    def _each(self, one: Callable[..., Array], *arrays: Array) -> Array:
        return each_state(one, self.arm.n, (self.arm.n,), *arrays)


def _pose(node: Any) -> Transform:
    T = node.getWorldTransform()
    return Transform(T.rotation(), T.translation())


def _finite(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _parsed(arm: ArmOrTree) -> Any:
    loader = dartpy.utils.DartLoader()
    options = dartpy.utils.DartLoader.Options()
    # By default DART lets the root float.
    options.mDefaultRootJointType = dartpy.utils.DartLoader.RootJointType.FIXED
    loader.setOptions(options)
    return loader.parseSkeletonString(text_for_engines(arm), dartpy.common.Uri(""))


def _built(arm: ArmOrTree) -> Any:
    """The arm passed joint by joint."""
    skeleton = dartpy.dynamics.Skeleton(arm.name)
    nodes: dict[int, Any] = {-1: None}
    tips = {-1: Transform.identity()}
    for i, each in enumerate(tree_links(arm)):
        placement = tips[each.parent] @ each.origin
        nodes[i] = _add(skeleton, nodes[each.parent], each.joint, each.link, placement)
        tips[i] = each.link.link_tip_frame
    return skeleton


def _add(skeleton: Any, parent: Any, joint: Joint, link: Link, placement: Transform) -> Any:
    dynamics = dartpy.dynamics
    if joint.kind == "prismatic":
        properties = dynamics.PrismaticJointProperties()
        create = skeleton.createPrismaticJointAndBodyNodePair
    else:
        properties = dynamics.RevoluteJointProperties()
        create = skeleton.createRevoluteJointAndBodyNodePair
    properties.mName = joint.name
    properties.mAxis = joint.axis
    properties.mT_ParentBodyToJoint = dartpy.math.Isometry3(placement.matrix())
    _, node = create(parent, properties)
    node.setName(link.name)
    here = link.inertia.expressed_in(link.link_tip_frame)
    node.setInertia(dynamics.Inertia(here.mass, here.com, here.tensor))
    return node


def _write_massless_links(root: Any) -> None:
    """Give every link without `<inertial>` one of mass zero."""
    for link in root.iterchildren("link"):
        if link.find("inertial") is None and link.get("name") != "world":
            inertial = etree.SubElement(link, "inertial")
            etree.SubElement(inertial, "mass", value="0")
            moments = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
            etree.SubElement(inertial, "inertia", dict.fromkeys(moments, "0"))


_KNOWN_ISSUES = (
    KnownIssue(
        id="dart-default-inertia",
        engine="dart",
        measured="6.20",
        kinds=("default-inertia",),
        harmful=True,
        title="a link without <inertial> gets 1 kg",
        explanation="DART gives such a link, a tool frame for instance, 1 kg and moments of "
        "1 kg m².",
        fix="write an <inertial> of mass zero; `ur5check expand --for dart`",
        rewrite=_write_massless_links,
    ),
    KnownIssue(
        id="dart-keeps-base",
        engine="dart",
        measured="6.20",
        kinds=("base-kept",),
        harmful=False,
        title="the base keeps its inertia",
        explanation="Links on the base stay bodies; at rest they load no joint.",
        fix="none is needed: torques do not change",
    ),
    KnownIssue(
        id="dart-floating-root",
        engine="dart",
        measured="6.20",
        kinds=(),
        harmful=True,
        title="the root floats by default",
        explanation="DartLoader makes the root joint floating. ur5check sets it to fixed.",
        fix="set mDefaultRootJointType to FIXED, or fix the root to a link `world`; "
        "`ur5check expand --for dart`",
        rewrite=fix_root_to_world,
    ),
    KnownIssue(
        id="dart-no-motor-inertia",
        engine="dart",
        measured="6.20",
        kinds=("armature",),
        harmful=True,
        title="motor inertia is not kept",
        explanation="DART's joints have no armature.",
        fix="add it to the mass matrix, or compare without it",
    ),
)

ENTRY = EngineEntry(
    key="dart",
    title="DART",
    order=40,
    make=DartEngine,
    module=dartpy,
    distribution="dartpy",
    extra="dart",
    known_issues=_KNOWN_ISSUES,
    finds_packages=False,
)
