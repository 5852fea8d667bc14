"""Drake as reference engine: `MultibodyPlant`'s inverse dynamics, mass matrix and time derivatives.

The root link is welded to the world (left to itself, Drake lets it float), and the plant is
continuous.  Damping is set to zero once it has been noted for `imported_model`.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import metadata
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import (
    BodyIndex,
    FixedOffsetFrame,
    MultibodyForces,
    PrismaticJoint,
    RevoluteJoint,
    RotationalInertia,
    SpatialInertia,
    UnitInertia,
)

from .._errors import EngineError
from .._robot.inertia import Inertia
from .._robot.serial_arm import Joint, Limits, SerialArm
from .._robot.transforms import Array, Transform
from .each_state import each_state
from .engine_urdf import parsed, root_link, text_for_engines
from .imported_model import HeldBody, ImportedModel

__all__ = ["DrakeEngine"]


class DrakeEngine:
    """Drake's algorithms on one arm; satisfies `engine.Engine`.

    arm : the arm;  gravity : in its base frame [m/s²], the arm's own when None.

    Raises EngineError if Drake cannot take the model.
    """

    name = "Drake"
    version = metadata.version("drake")

    def __init__(self, arm: SerialArm, gravity: ArrayLike | None = None) -> None:
        self.arm = arm
        self.route = "SerialArm" if arm.source.urdf is None else "URDF text, own parser"
        self.plant = MultibodyPlant(0.0)
        give = _build if arm.source.urdf is None else _parse
        with _heard() as said:
            try:
                base, self._tip, self._tip_pose = give(self.plant, arm)
                self.plant.Finalize()
            except (RuntimeError, ValueError) as error:
                reason = " ".join(str(error).split())
                raise EngineError(
                    f"Drake cannot take the model of {arm.name!r}: {reason}"
                ) from error
        self.said = tuple(said)
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
            derivatives = self.plant.EvalTimeDerivatives(self.context)
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
        """What the `MultibodyPlant` holds: a body for every link."""
        zero = np.zeros(self.arm.n)
        self._place(zero, zero)
        above = {}
        for k in self.plant.GetJointIndices():
            joint = self.plant.get_joint(k)
            above[int(joint.child_body().index())] = joint
        bodies = [self.plant.get_body(BodyIndex(k)) for k in range(1, self.plant.num_bodies())]
        return ImportedModel(
            tuple(self._held_joint(i) for i in np.argsort(self._order)),
            tuple(self._held_body(body, above) for body in bodies),
            self._gravity_read,
            self._tool().matrix(),
            int(self.plant.num_positions()),
            self.said,
        )

    def _held_joint(self, i: int) -> Joint:
        joint = self._joints[i]
        sliding = isinstance(joint, PrismaticJoint)
        axis = joint.translation_axis() if sliding else joint.revolute_axis()
        frame = joint.frame_on_parent().CalcPoseInWorld(self.context)
        motors = [
            motor
            for k in self.plant.GetJointActuatorIndices()
            if (motor := self.plant.get_joint_actuator(k)).joint() is joint
        ]
        return Joint(
            str(joint.name()),
            self._T_base_world.R @ frame.rotation().matrix() @ axis,
            "prismatic" if sliding else "revolute",
            Limits(
                _finite(joint.position_lower_limit()),
                _finite(joint.position_upper_limit()),
                _finite(joint.velocity_upper_limit()),
                _finite(motors[0].effort_limit()) if motors else None,
            ),
            float(sum(motor.default_reflected_inertia() for motor in motors)),
            float(self._damping[i]),
            0.0,  # a MultibodyPlant has no dry friction in its joints
        )

    def _held_body(self, body: Any, above: dict[int, Any]) -> HeldBody:
        held = body.CalcSpatialInertiaInBodyFrame(self.context)
        mass, com = held.get_mass(), held.get_com()
        if mass == 0.0:
            inertia = Inertia.zero()
        else:
            central = held.Shift(com).CalcRotationalInertia().CopyToFullMatrix3()
            inertia = Inertia(mass, com, central)
        here = self._T_base_world @ _transform(body.EvalPoseInWorld(self.context))
        return HeldBody(str(body.name()), self._carrier(body, above), inertia.expressed_in(here))

    def _carrier(self, body: Any, above: dict[int, Any]) -> int | None:
        while int(body.index()) in above:
            joint = above[int(body.index())]
            if joint.num_velocities():
                return self._order.index(joint.velocity_start())
            body = joint.parent_body()
        return None

    def _inverse(self, accelerations: Array) -> Array:
        forces = MultibodyForces(self.plant)
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


def _parse(plant: Any, arm: SerialArm) -> tuple[Any, Any, Transform]:
    """Read the URDF; returns the base's and the tip's frames, and the tool's pose on the tip."""
    text = text_for_engines(arm)
    Parser(plant).AddModelsFromString(text, "urdf")
    root = root_link(parsed(arm))
    if root != "world":  # a link of that name *is* Drake's world
        plant.WeldFrames(plant.world_frame(), plant.GetFrameByName(root))
    frames = (plant.GetFrameByName(link) for link in (arm.source.base, arm.source.tip))
    return (*frames, Transform.identity())


def _build(plant: Any, arm: SerialArm) -> tuple[Any, Any, Transform]:
    """Hand the arm over joint by joint; returns as `_parse` does."""
    body, placement = plant.world_body(), arm.base
    for joint, link in zip(arm.joints, arm.links, strict=True):
        child = plant.AddRigidBody(
            link.name, _spatial(link.inertia.expressed_in(link.link_tip_frame))
        )
        start = plant.AddFrame(
            FixedOffsetFrame(f"{joint.name}_start", body.body_frame(), _rigid(placement))
        )
        kind = PrismaticJoint if joint.kind == "prismatic" else RevoluteJoint
        added = plant.AddJoint(kind(joint.name, start, child.body_frame(), joint.axis))
        if joint.armature:
            motor = plant.AddJointActuator(f"{joint.name}_motor", added)
            motor.set_default_rotor_inertia(joint.armature)
        body, placement = child, link.link_tip_frame
    return plant.world_frame(), body.body_frame(), placement


def _spatial(inertia: Inertia) -> Any:
    if inertia.mass == 0.0:
        return SpatialInertia.Zero()
    about_origin = inertia.parameters()[4:] / inertia.mass
    xx, xy, yy, xz, yz, zz = about_origin
    unit = UnitInertia(RotationalInertia(xx, yy, zz, xy, xz, yz))
    return SpatialInertia(inertia.mass, inertia.com, unit)


def _rigid(T: Transform) -> Any:
    return RigidTransform(RotationMatrix(T.R), T.p)


def _transform(X: Any) -> Transform:
    return Transform(X.rotation().matrix(), X.translation())


def _finite(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


@contextmanager
def _heard() -> Iterator[list[str]]:
    """What Drake logs meanwhile, kept from the reader's terminal."""
    lines: list[str] = []
    logger = logging.getLogger("drake")

    class Keep(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            lines.append(" ".join(record.getMessage().split()))

    handler, propagated = Keep(), logger.propagate
    logger.addHandler(handler)
    logger.propagate = False
    try:
        yield lines
    finally:
        logger.removeHandler(handler)
        logger.propagate = propagated
