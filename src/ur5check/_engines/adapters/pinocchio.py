"""Pinocchio as reference engine.

An arm that came from a URDF reaches Pinocchio as that URDF's text, through Pinocchio's own parser
(urdfdom): no code of ours stands between the file and the reference engine, so that an error in our
reading cannot affect both sides.  An arm that came from a `pin.Model` uses that model.  Only an arm
that has neither (a DH table, a value built in Python) is passed joint by joint.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..._errors import EngineError
from ..._robot.inertia import Inertia, parameter_map
from ..._robot.serial_arm import Joint, Limits, SerialArm
from ..._robot.transforms import Array, Transform
from ..captured_warnings import captured_output
from ..each_state import each_state
from ..engine_entry import EngineEntry
from ..imported_model import ImportedBody, ImportedModel
from ..known_issue import KnownIssue
from ..lazy_import import lazy_import

__all__ = ["ENTRY", "PinocchioEngine"]

pin = lazy_import("pinocchio")


class PinocchioEngine:
    """Pinocchio's algorithms on one arm; satisfies `engine.ReferenceEngine`.

    arm : the arm;  gravity : in its base frame [m/s²], the arm's own when None.

    Raises EngineError if Pinocchio refuses the model, or reads a chain with other joints.
    """

    name = "Pinocchio"

    def __init__(self, arm: SerialArm, gravity: ArrayLike | None = None) -> None:
        arm.require_tensors("an engine's model")
        self.arm = arm
        self.version = str(pin.__version__)
        self.warnings: tuple[str, ...] = ()
        if arm.source.urdf is not None:
            self.route = "URDF text, own parser"
            with captured_output() as lines:
                whole = _parse(arm.source.urdf, arm.name)
            self.warnings = tuple(lines)
        elif arm.source.model is not None:
            self.route = "pin.Model"
            whole = arm.source.model
        else:
            self.route = "SerialArm"
            whole = _build(arm)
        self.model = _only_these_joints(whole, arm)
        self.data = self.model.createData()
        self._joints = [self.model.joints[self.model.getJointId(name)] for name in arm.joint_names]
        self._rates = [joint.idx_v for joint in self._joints]
        #: the arm's q, q̇ and τ are Pinocchio's: one number a joint, in one order.  Most are, and
        #: then a loop over states re-orders nothing, which would take longer than the algorithm.
        self._as_it_is = self.model.nq == arm.n and self._rates == list(range(arm.n))
        self._base = self._frame(arm.source.base)
        self._tip = self._frame(arm.source.tip)
        # Gravity is given in the arm's base frame, which need not be Pinocchio's world.
        pin.framesForwardKinematics(self.model, self.data, pin.neutral(self.model))
        self._T_base_world = self.data.oMf[self._base].inverse()
        self._gravity_read = self._T_base_world.rotation @ self.model.gravity.linear
        g = np.asarray(arm.gravity if gravity is None else gravity, dtype=np.float64)
        self.model.gravity.linear = self._T_base_world.rotation.T @ g
        self._parameters_here = _parameter_maps(arm)

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool in the base frame, from `framesForwardKinematics`."""

        def pose(x: Array) -> Array:
            pin.framesForwardKinematics(self.model, self.data, x)
            return np.asarray((self._T_base_world * self.data.oMf[self._tip]).homogeneous)

        return self._each(lambda x: pose(self._configuration(x)), (4, 4), q)

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Torques from `pin.rnea`."""
        return self._torques(lambda x, v, a: pin.rnea(self.model, self.data, x, v, a), q, qd, qdd)

    def inverse_dynamics_gradient(
        self, q: Array, qd: Array, qdd: Array
    ) -> tuple[Array, Array, Array]:
        """∂τ/∂q, ∂τ/∂q̇ and ∂τ/∂q̈ = M from `pin.computeRNEADerivatives`.

        q, qd, qdd : shape (..., n) [rad], [rad/s], [rad/s²].  Each result has shape (..., n, n):
        row i is the torque of joint i [N m], column j what it is differentiated by.
        """

        n = self.arm.n
        slopes = self._each(lambda *state: self.torque_and_slope(*state)[1], (n, 3 * n), q, qd, qdd)
        return slopes[..., :n], slopes[..., n : 2 * n], slopes[..., 2 * n :]

    def torque_and_slope(self, q: Array, qd: Array, qdd: Array) -> tuple[Array, Array]:
        """τ of one state, shape (n,), and ∂τ/∂(q, q̇, q̈), shape (n, 3 n), in one pass.

        q, qd, qdd : shape (n,).  For callers with one state at a time, without the loop's cost.
        """
        rates = (self._velocity(qd), self._velocity(qdd))
        three = pin.computeRNEADerivatives(self.model, self.data, self._configuration(q), *rates)
        tau, slopes = np.array(self.data.tau), np.reshape(three, (3, self.model.nv, -1))
        if not self._as_it_is:
            tau, slopes = tau[self._rates], slopes[:, self._rates][:, :, self._rates]
        return tau, np.hstack(list(slopes))

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Accelerations from `pin.aba`."""
        return self._torques(lambda x, v, t: pin.aba(self.model, self.data, x, v, t), q, qd, tau)

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """C q̇ + g from `pin.nonLinearEffects`."""
        return self._torques(lambda x, v: pin.nonLinearEffects(self.model, self.data, x, v), q, qd)

    def gravity_torque(self, q: Array) -> Array:
        """g from `pin.computeGeneralizedGravity`."""
        return self._torques(lambda x: pin.computeGeneralizedGravity(self.model, self.data, x), q)

    def mass_matrix(self, q: Array) -> Array:
        """M from `pin.crba`, which fills the upper triangle; the lower one is its mirror image."""

        def crba(x: Array) -> Array:
            return np.atleast_2d(pin.crba(self.model, self.data, self._configuration(x)))

        M = self._each(crba, (self.arm.n, self.arm.n), q)
        return self._matrix(np.triu(M) + np.swapaxes(np.triu(M, 1), -1, -2))

    def coriolis_matrix(self, q: Array, qd: Array) -> Array:
        """C from `pin.computeCoriolisMatrix`."""

        def coriolis(x: Array, v: Array) -> Array:
            return np.atleast_2d(
                pin.computeCoriolisMatrix(
                    self.model, self.data, self._configuration(x), self._velocity(v)
                )
            )

        return self._matrix(self._each(coriolis, (self.arm.n, self.arm.n), q, qd))

    def torque_regressor(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Y from `pin.computeJointTorqueRegressor`, its columns taken to the arm's link frames."""

        def regressor(x: Array, v: Array, a: Array) -> Array:
            Y = pin.computeJointTorqueRegressor(
                self.model,
                self.data,
                self._configuration(x),
                self._velocity(v),
                self._velocity(a),
            )
            return np.reshape(Y, (self.arm.n, -1))  # one joint: pin returns a row

        Y = self._each(regressor, (self.arm.n, 10 * self.arm.n), q, qd, qdd)
        if not self._as_it_is:
            Y = Y[..., self._rates, :]
        rows = Y.reshape(-1, 10 * self.arm.n)  # of all states: one product a link, not one a state
        blocks = [
            rows[:, 10 * (joint.id - 1) : 10 * joint.id] @ A
            for joint, A in zip(self._joints, self._parameters_here, strict=True)
        ]
        return np.hstack(blocks).reshape(Y.shape)

    def imported_model(self) -> ImportedModel:
        """The `pin.Model`: one inertia per joint, links fixed to it merged into it."""
        pin.forwardKinematics(self.model, self.data, pin.neutral(self.model))
        in_order = sorted(self._joints, key=lambda joint: joint.id)
        carried_by = {joint.id: i for i, joint in enumerate(self._joints)}
        bodies = [
            ImportedBody(
                str(self.model.names[k]),
                carried_by.get(k),
                Inertia(body.mass, body.lever, body.inertia).expressed_in(self._pose(k)),
            )
            for k, body in enumerate(self.model.inertias)
            if body.mass or k
        ]
        return ImportedModel(
            tuple(self._imported_joint(joint) for joint in in_order),
            tuple(bodies),
            self._gravity_read,
            self.forward_kinematics(np.zeros(self.arm.n)),
            sum(joint.nq for joint in self._joints),
            self.warnings,
        )

    def _pose(self, joint: int) -> Transform:
        placed = self._T_base_world * self.data.oMi[joint]
        return Transform(placed.rotation, placed.translation)

    def _imported_joint(self, joint: Any) -> Joint:
        model, v, x = self.model, joint.idx_v, joint.idx_q
        fresh = joint.createData()
        joint.calc(fresh, pin.neutral(model))
        S = np.asarray(fresh.S, dtype=np.float64).reshape(6)
        sliding = bool(S[:3].any())
        position = joint.nq == 1
        return Joint(
            str(model.names[joint.id]),
            self._pose(joint.id).R @ (S[:3] if sliding else S[3:]),
            "prismatic" if sliding else "revolute",
            Limits(
                _finite(model.lowerPositionLimit[x]) if position else None,
                _finite(model.upperPositionLimit[x]) if position else None,
                _finite(model.upperVelocityLimit[v]),
                _finite(model.upperEffortLimit[v]),
            ),
            float(model.armature[v]),
            float(model.damping[v]),
            float(model.upperDryFrictionLimit[v]),
        )

    def _frame(self, name: str) -> int:
        # A URDF may give a link and a joint the same name: the link's frame is meant.
        for kind in (pin.FrameType.BODY, pin.FrameType.OP_FRAME):
            if self.model.existFrame(name, kind):
                return int(self.model.getFrameId(name, kind))
        if self.model.existFrame(name):
            return int(self.model.getFrameId(name))
        raise EngineError(f"Pinocchio's model of {self.arm.name!r} has no frame {name!r}")

    def _configuration(self, q: Array) -> Array:
        """The arm's q as Pinocchio's: a continuous joint has (cos q, sin q)."""
        if self._as_it_is:
            return q
        x: Array = pin.neutral(self.model)
        for joint, angle in zip(self._joints, q, strict=True):
            if joint.nq == 2:
                x[joint.idx_q : joint.idx_q + 2] = np.cos(angle), np.sin(angle)
            else:
                x[joint.idx_q] = angle
        return x

    def _velocity(self, rates: Array) -> Array:
        """The arm's joint order as Pinocchio's."""
        if self._as_it_is:
            return rates
        v = np.empty(self.model.nv)
        v[self._rates] = rates
        return v

    def _matrix(self, M: Array) -> Array:
        """Rows and columns from Pinocchio's order to the arm's, shape (..., n, n)."""
        return M if self._as_it_is else M[..., self._rates, :][..., self._rates]

    def _torques(self, algorithm: Callable[..., Array], q: Array, *rates: Array) -> Array:
        def one(x: Array, *rest: Array) -> Array:
            result = algorithm(self._configuration(x), *(self._velocity(r) for r in rest))
            return np.asarray(result if self._as_it_is else result[self._rates])

        return self._each(one, (self.arm.n,), q, *rates)

    def _each(self, one: Callable[..., Array], shape: tuple[int, ...], *arrays: Array) -> Array:
        return each_state(one, self.arm.n, shape, *arrays)


def _parse(urdf: str, name: str) -> Any:
    try:
        return pin.buildModelFromXML(urdf)
    except (ValueError, RuntimeError) as error:
        raise EngineError(f"Pinocchio cannot read the URDF of {name!r}: {error}") from error


def _only_these_joints(model: Any, arm: SerialArm) -> Any:
    """`model` with every joint that is not the arm's locked where it is held; always a copy."""
    names = list(model.names)[1:]
    missing = [name for name in arm.joint_names if name not in names]
    if missing:
        raise EngineError(f"Pinocchio's model of {arm.name!r} lacks joint {missing[0]!r}")
    others = [model.getJointId(name) for name in names if name not in arm.joint_names]
    if not others:
        return model.copy()
    posture = pin.neutral(model)
    for name, value in arm.source.held:
        joint = model.joints[model.getJointId(name)]
        held = [value] if joint.nq == 1 else [np.cos(value), np.sin(value)]
        posture[joint.idx_q : joint.idx_q + joint.nq] = held
    try:
        return pin.buildReducedModel(model, others, posture)
    except (ValueError, RuntimeError) as error:
        raise EngineError(
            f"Pinocchio cannot lock the joints of {arm.name!r} that are not on the chain: {error}"
        ) from error


def _build(arm: SerialArm) -> Any:
    """The arm passed joint by joint."""
    model = pin.Model()
    model.name = arm.name
    parent, placement = 0, arm.base
    armature: list[float] = []
    for joint, link in zip(arm.joints, arm.links, strict=True):
        kind = (
            pin.JointModelPrismaticUnaligned
            if joint.kind == "prismatic"
            else pin.JointModelRevoluteUnaligned
        )
        armature.append(joint.armature)
        parent = model.addJoint(parent, kind(joint.axis), _se3(placement), joint.name)
        # Through the ten parameters: `pin.Inertia(m, c, I)` refuses a tensor that no body could
        # have, and the laws hold for those too.
        inertia = pin.Inertia.FromDynamicParameters(link.inertia.parameters())
        model.appendBodyToJoint(parent, inertia, _se3(link.link_tip_frame))
        placement = link.link_tip_frame
    model.armature = np.array(armature)
    body = pin.FrameType.OP_FRAME
    model.addFrame(pin.Frame(arm.source.base, 0, 0, pin.SE3.Identity(), body))
    model.addFrame(pin.Frame(arm.source.tip, parent, 0, _se3(placement), body))
    return model


def _se3(T: Transform) -> Any:
    return pin.SE3(T.R, T.p)


def _parameter_maps(arm: SerialArm) -> list[Array]:
    """From parameters in frame i to parameters in Pinocchio's joint frame.

    Pinocchio's joint frame is at the joint, frame i at the tip of the link: P_i apart.
    """
    return [parameter_map(link.link_tip_frame) for link in arm.links]


def _finite(value: float) -> float | None:
    """A limit, or None where Pinocchio writes infinity or the largest double for "none"."""
    return float(value) if abs(value) < np.finfo(np.float64).max else None


_KNOWN_ISSUES = (
    KnownIssue(
        id="pinocchio-merges-fixed-links",
        engine="pinocchio",
        measured="4.1",
        kinds=("body-merged", "base-kept", "base-ignored"),
        harmful=False,
        title="fixed links are merged into their parents",
        explanation="Links behind fixed joints become part of the moving link that carries them. "
        "Links on the base become part of the universe, where they load no joint.",
        fix="none is needed: torques do not change",
    ),
    KnownIssue(
        id="pinocchio-continuous-joint",
        engine="pinocchio",
        measured="4.1",
        kinds=("coordinates",),
        harmful=False,
        title="a continuous joint takes two coordinates",
        explanation="Its configuration is (cos q, sin q), so that nq exceeds nv.",
        fix="none is needed here; in your own code use pin.integrate and model.joints[i].nq",
    ),
)

ENTRY = EngineEntry(
    key="pinocchio",
    title="Pinocchio",
    order=10,
    make=PinocchioEngine,
    module=pin,
    distribution="pin",
    known_issues=_KNOWN_ISSUES,
)
