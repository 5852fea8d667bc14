"""Drake as reference engine: `MultibodyPlant`'s inverse dynamics, mass matrix and time derivatives.

The root link is welded to the world (by default it floats), and the plant is
continuous.  Damping is set to zero after its value has been recorded for `imported_model`.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import metadata
from typing import Any

import numpy as np
from lxml import etree
from numpy.typing import ArrayLike

from ..._errors import EngineError, StateError
from ..._robot.inertia import Inertia
from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.serial_arm import Joint, Limits
from ..._robot.transforms import Array, Transform
from ..captured_warnings import captured_log
from ..each_state import each_state
from ..engine_entry import EngineEntry
from ..engine_urdf import parsed, root_link, text_for_engines
from ..imported_model import ImportedBody, ImportedModel
from ..known_issue import KnownIssue
from ..lazy_import import lazy_import
from ..urdf_repairs import fix_root_to_world

__all__ = ["ENTRY", "DrakeEngine"]

parsing = lazy_import("pydrake.multibody.parsing")
plants = lazy_import("pydrake.multibody.plant")
pydrake_math = lazy_import("pydrake.math")
tree = lazy_import("pydrake.multibody.tree")


class DrakeEngine:
    """Drake's algorithms on one arm or robot; satisfies `engine.Engine`.

    arm : an arm, or a tree without mimic joints;  gravity : in its base frame [m/s²], its own when
        None.

    Raises EngineError if Drake refuses the model.
    """

    name = "Drake"

    def __init__(self, arm: ArmOrTree, gravity: ArrayLike | None = None) -> None:
        self.arm = arm
        self.version = metadata.version("drake")
        self.route = "URDF text, own parser" if arm.source.urdf else type(arm).__name__
        self.plant = plants.MultibodyPlant(0.0)
        give = _build if arm.source.urdf is None else _parse
        with captured_log("drake") as lines:
            try:
                base, self._tip, self._tip_pose = give(self.plant, arm)
                self.plant.Finalize()
            except (RuntimeError, ValueError, SystemExit) as error:  # Drake's asserts exit
                reason = " ".join(str(error).split())
                raise EngineError(
                    f"Drake cannot take the model of {arm.name!r}: {reason}"
                ) from error
        self.warnings = tuple(lines)
        self.context = self.plant.CreateDefaultContext()
        self._joints = [self.plant.GetJointByName(name) for name in arm.joint_names]
        self._order = [joint.velocity_start() for joint in self._joints]
        self._damping = [joint.GetDamping(self.context) for joint in self._joints]
        for joint in self._joints:
            joint.SetDamping(self.context, 0.0)
        self._input = self.plant.get_applied_generalized_force_input_port()
        self._T_base_world = _transform(base.CalcPoseInWorld(self.context)).inverse()
        R = self._T_base_world.R
        field = self.plant.mutable_gravity_field()
        self._gravity_read = R @ field.gravity_vector()
        g = np.asarray(arm.gravity if gravity is None else gravity, dtype=np.float64)
        field.set_gravity_vector(R.T @ g)

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool in the base frame, from `CalcPoseInWorld`."""

        def pose(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            return self._tool().matrix()

        return each_state(pose, self.arm.n, (4, 4), q)

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Torques from `CalcInverseDynamics`."""

        def torque(x: Array, v: Array, a: Array) -> Array:
            self._place(x, v)
            return self._of(self._inverse(self._ordered(a)))

        return self._each(torque, q, qd, qdd)

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Accelerations from the plant's time derivatives."""

        def acceleration(x: Array, v: Array, t: Array) -> Array:
            self._place(x, v)
            self._input.FixValue(self.context, self._ordered(t))
            try:
                derivatives = self.plant.EvalTimeDerivatives(self.context)
            except RuntimeError as error:  # a mass matrix without an inverse
                raise StateError(f"Drake: {error}") from error
            return self._of(derivatives.get_generalized_velocity().CopyToVector())

        return self._each(acceleration, q, qd, tau)

    def mass_matrix(self, q: Array) -> Array:
        """M from `CalcMassMatrix`."""

        def mass(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            M = np.asarray(self.plant.CalcMassMatrix(self.context))
            return M[np.ix_(self._order, self._order)]

        return each_state(mass, self.arm.n, (self.arm.n, self.arm.n), q)

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """C q̇ + g from `CalcBiasTerm` and `CalcGravityGeneralizedForces`."""

        def bias(x: Array, v: Array) -> Array:
            self._place(x, v)
            velocity = self.plant.CalcBiasTerm(self.context)
            return self._of(velocity - self.plant.CalcGravityGeneralizedForces(self.context))

        return self._each(bias, q, qd)

    def gravity_torque(self, q: Array) -> Array:
        """g from `CalcGravityGeneralizedForces`."""

        def gravity(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            return self._of(-self.plant.CalcGravityGeneralizedForces(self.context))

        return self._each(gravity, q)

    def imported_model(self) -> ImportedModel:
        """The `MultibodyPlant`: a body for every link."""
        zero = np.zeros(self.arm.n)
        self._place(zero, zero)
        above = {}
        for k in self.plant.GetJointIndices():
            joint = self.plant.get_joint(k)
            above[int(joint.child_body().index())] = joint
        bodies = [self.plant.get_body(tree.BodyIndex(k)) for k in range(1, self.plant.num_bodies())]
        return ImportedModel(
            tuple(self._imported_joint(i) for i in np.argsort(self._order)),
            np.array([self._joint_frame(self._joints[i]).p for i in np.argsort(self._order)]),
            tuple(self._imported_body(body, above) for body in bodies),
            self._gravity_read,
            self._tool().matrix(),
            int(self.plant.num_positions()),
            self.warnings,
        )

    def _imported_joint(self, i: int) -> Joint:
        joint = self._joints[i]
        sliding = isinstance(joint, tree.PrismaticJoint)
        axis = joint.translation_axis() if sliding else joint.revolute_axis()
        motors = [
            motor
            for k in self.plant.GetJointActuatorIndices()
            if (motor := self.plant.get_joint_actuator(k)).joint() is joint
        ]
        return Joint(
            str(joint.name()),
            self._joint_frame(joint).R @ axis,
            "prismatic" if sliding else "revolute",
            Limits(
                _finite(joint.position_lower_limit()),
                _finite(joint.position_upper_limit()),
                _finite(joint.velocity_upper_limit()),
                _finite(motors[0].effort_limit()) if motors else None,
            ),
            float(sum(motor.default_reflected_inertia() for motor in motors)),
            float(self._damping[i]),
            0.0,  # a plants.MultibodyPlant has no dry friction in its joints
        )

    def _joint_frame(self, joint: Any) -> Transform:
        frame = joint.frame_on_parent().CalcPoseInWorld(self.context)
        return self._T_base_world @ _transform(frame)

    def _imported_body(self, body: Any, above: dict[int, Any]) -> ImportedBody:
        spatial = body.CalcSpatialInertiaInBodyFrame(self.context)
        mass, com = spatial.get_mass(), spatial.get_com()
        if mass == 0.0:
            inertia = Inertia.zero()
        else:
            central = spatial.Shift(com).CalcRotationalInertia().CopyToFullMatrix3()
            inertia = Inertia(mass, com, central)
        here = self._T_base_world @ _transform(body.EvalPoseInWorld(self.context))
        return ImportedBody(
            str(body.name()), self._carrier(body, above), inertia.expressed_in(here)
        )

    def _carrier(self, body: Any, above: dict[int, Any]) -> int | None:
        while int(body.index()) in above:
            joint = above[int(body.index())]
            if joint.num_velocities():
                return self._order.index(joint.velocity_start())
            body = joint.parent_body()
        return None

    def _inverse(self, accelerations: Array) -> Array:
        forces = tree.MultibodyForces(self.plant)
        self.plant.CalcForceElementsContribution(self.context, forces)
        return np.asarray(self.plant.CalcInverseDynamics(self.context, accelerations, forces))

    def _tool(self) -> Transform:
        tip = _transform(self._tip.CalcPoseInWorld(self.context))
        return self._T_base_world @ tip @ self._tip_pose

    def _place(self, q: Array, qd: Array) -> None:
        self.plant.SetPositions(self.context, self._ordered(q))
        self.plant.SetVelocities(self.context, self._ordered(qd))

    def _ordered(self, values: Array) -> Array:
        ordered = np.empty(self.arm.n)
        ordered[self._order] = values
        return ordered

    def _of(self, values: Array) -> Array:
        return np.array(values)[self._order]

    def _each(self, one: Callable[..., Array], *arrays: Array) -> Array:
        return each_state(one, self.arm.n, (self.arm.n,), *arrays)


def _parse(plant: Any, arm: ArmOrTree) -> tuple[Any, Any, Transform]:
    """Read the URDF; returns the base's and the tip's frames, and the tool's pose on the tip."""
    text = text_for_engines(arm)
    parsing.Parser(plant).AddModelsFromString(text, "urdf")
    root = root_link(parsed(arm))
    if root != "world":  # a link of that name *is* Drake's world
        plant.WeldFrames(plant.world_frame(), plant.GetFrameByName(root))
    frames = (plant.GetFrameByName(link) for link in (arm.source.base, arm.source.tip))
    return (*frames, Transform.identity())


def _build(plant: Any, arm: ArmOrTree) -> tuple[Any, Any, Transform]:
    """Pass the arm joint by joint; returns as `_parse` does."""
    bodies, tips = {-1: plant.world_body()}, {-1: Transform.identity()}
    links = tree_links(arm)
    for i, each in enumerate(links):
        joint, link, placement = each.joint, each.link, tips[each.parent] @ each.origin
        bodies[i] = child = plant.AddRigidBody(
            link.name, _spatial(link.inertia.expressed_in(link.link_tip_frame))
        )
        start = plant.AddFrame(
            tree.FixedOffsetFrame(
                f"{joint.name}_start", bodies[each.parent].body_frame(), _rigid(placement)
            )
        )
        kind = tree.PrismaticJoint if joint.kind == "prismatic" else tree.RevoluteJoint
        added = plant.AddJoint(kind(joint.name, start, child.body_frame(), joint.axis))
        if joint.armature:
            motor = plant.AddJointActuator(f"{joint.name}_motor", added)
            motor.set_default_rotor_inertia(joint.armature)
        tips[i] = link.link_tip_frame
    last = len(links) - 1
    return plant.world_frame(), bodies[last].body_frame(), tips[last]


def _spatial(inertia: Inertia) -> Any:
    if inertia.mass == 0.0:
        return tree.SpatialInertia.Zero()
    about_origin = inertia.parameters()[4:] / inertia.mass
    xx, xy, yy, xz, yz, zz = about_origin
    unit = tree.UnitInertia(tree.RotationalInertia(xx, yy, zz, xy, xz, yz))
    return tree.SpatialInertia(inertia.mass, inertia.com, unit)


def _rigid(T: Transform) -> Any:
    return pydrake_math.RigidTransform(pydrake_math.RotationMatrix(T.R), T.p)


def _transform(X: Any) -> Transform:
    return Transform(X.rotation().matrix(), X.translation())


def _finite(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _effort_in_transmissions(root: Any) -> None:
    """Give every moving joint with an effort limit an actuator, where it has none."""
    driven = {joint.get("name") for joint in root.findall("transmission/joint")}
    for joint in root.findall("joint"):
        limit, name = joint.find("limit"), joint.get("name")
        moves = joint.get("type") in ("revolute", "continuous", "prismatic")
        if not moves or name in driven or limit is None or limit.get("effort") is None:
            continue
        transmission = etree.SubElement(root, "transmission", name=f"{name}_transmission")
        kind = etree.SubElement(transmission, "type")
        kind.text = "transmission_interface/SimpleTransmission"
        etree.SubElement(transmission, "joint", name=name)
        etree.SubElement(transmission, "actuator", name=f"{name}_motor")


_KNOWN_ISSUES = (
    KnownIssue(
        id="drake-impossible-tensor",
        engine="drake",
        measured="1.51",
        kinds=("tensor-changed", "com-moved", "mass-changed"),
        harmful=True,
        title="an inertia tensor that no body can have is replaced",
        explanation="A tensor that violates the triangle inequality, if only in its last printed "
        "digit, is replaced by that of a solid sphere of water density and the same mass, with a "
        "warning on the log. Moments can shrink a hundredfold.",
        fix="correct the tensor: print more digits, or raise the smallest moments",
    ),
    KnownIssue(
        id="drake-effort-from-transmission",
        engine="drake",
        measured="1.51",
        kinds=("effort-limit",),
        harmful=False,
        title="effort limits count only where there is a transmission",
        explanation="A joint has no actuator, and so no effort limit, unless a <transmission> "
        "drives it.",
        fix="add a <transmission> for each joint; `ur5check expand --for drake`",
        rewrite=_effort_in_transmissions,
    ),
    KnownIssue(
        id="drake-no-friction",
        engine="drake",
        measured="1.51",
        kinds=("friction",),
        harmful=False,
        title="dry friction is not kept",
        explanation="A MultibodyPlant has no Coulomb friction in its joints, and logs a warning.",
        fix="add it as a force of your own",
    ),
    KnownIssue(
        id="drake-continuous-limits",
        engine="drake",
        measured="1.51",
        kinds=("position-limit",),
        harmful=False,
        title="a continuous joint keeps position limits",
        explanation="lower and upper in the <limit> of a continuous joint mean nothing by the URDF "
        "specification; Drake keeps them.",
        fix="take lower and upper out of the continuous joint's <limit>",
    ),
    KnownIssue(
        id="drake-keeps-base",
        engine="drake",
        measured="1.51",
        kinds=("base-kept",),
        harmful=False,
        title="the base keeps its inertia",
        explanation="Links on the base stay bodies; welded to the world they load no joint.",
        fix="none is needed: torques do not change",
    ),
    KnownIssue(
        id="drake-floating-root",
        engine="drake",
        measured="1.51",
        kinds=(),
        harmful=True,
        title="the root floats unless it is welded",
        explanation="A URDF's root link is free in space until WeldFrames, or a root link of the "
        "name `world`, fixes it. ur5check welds it.",
        fix="name the root `world`; `ur5check expand --for drake`",
        rewrite=fix_root_to_world,
    ),
)

ENTRY = EngineEntry(
    key="drake",
    title="Drake",
    order=30,
    make=DrakeEngine,
    module=plants,
    distribution="drake",
    extra="drake",
    known_issues=_KNOWN_ISSUES,
)
