"""The protocols of an engine.

All arrays have shape (..., n), in the joint order of the arm that the engine was made for; gravity
is in that arm's base frame and is fixed when the engine is made.

    Engine             torques, accelerations, M, C q̇ + g, g, the tool's pose, the imported model
    ├─ ReferenceEngine also C and the torque regressor, which the laws need
    └─ Stepper         also steps in time, by its own integrator
"""

from __future__ import annotations

from typing import ClassVar, Protocol, runtime_checkable

from numpy.typing import ArrayLike

from .._robot.robot_tree import ArmOrTree
from .._robot.transforms import Array
from .imported_model import ImportedModel

__all__ = ["Engine", "MakeEngine", "ReferenceEngine", "Stepper"]


@runtime_checkable
class Engine(Protocol):
    """An implementation of rigid-body dynamics with one arm, or one robot, loaded."""

    name: str
    version: str
    #: how the model reached the engine: "URDF text, own parser", or as a value: "SerialArm",
    #: "RobotTree", "pin.Model"
    route: str

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool (of a tree's last moving link) in the base frame, (..., 4, 4)."""
        ...

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Joint torques, shape (..., n) [N m]: rigid bodies and motor inertia, no damping."""
        ...

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Joint accelerations, shape (..., n) [rad/s²]."""
        ...

    def mass_matrix(self, q: Array) -> Array:
        """M(q), shape (..., n, n) [kg m²]."""
        ...

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """C q̇ + g, shape (..., n) [N m]."""
        ...

    def gravity_torque(self, q: Array) -> Array:
        """g(q), shape (..., n) [N m]."""
        ...

    def imported_model(self) -> ImportedModel:
        """The joints and bodies that the engine has after reading."""
        ...


class MakeEngine(Protocol):
    """How an engine is made: from an arm, whose source says by which route.

    An arm that came from a URDF reaches the engine as that text, through the engine's own parser;
    any other arm is passed joint by joint.  A whole robot reaches it likewise, as a `RobotTree`
    with a coordinate for every joint.

    Raises EngineError if the engine refuses the model.
    """

    def __call__(self, arm: ArmOrTree, gravity: ArrayLike | None = None) -> Engine:
        """The engine with `arm` loaded, under `gravity` (the arm's own when None)."""
        ...


class ReferenceEngine(Engine, Protocol):
    """An engine that has all terms that the laws need."""

    def coriolis_matrix(self, q: Array, qd: Array) -> Array:
        """A C(q, q̇) with C q̇ the velocity torque, shape (..., n, n) [N m s]."""
        ...

    def torque_regressor(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Y, shape (..., n, 10 n), for parameters expressed in the arm's link frames."""
        ...


class Stepper(Engine, Protocol):
    """An engine that integrates the arm's motion.

    Contact, joint limits, damping and friction are left out: what moves is the rigid-body model
    under gravity and the given torques.
    """

    #: names of the engine's integrators and the order of each, the engine's default first
    integrators: ClassVar[dict[str, int]]

    def step(
        self, q: Array, qd: Array, tau: Array, dt: float, integrator: str | None = None
    ) -> tuple[Array, Array]:
        """(q, q̇) after `dt` [s] of constant torque, by one step of the engine's integrator.

        q, qd, tau : shape (n,) [rad], [rad/s], [N m].
        """
        ...
