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
    """An implementation of rigid-body dynamics with one arm, or one robot, loaded.

    Arrays have shape (..., n), in the joint order of the arm; units are [rad] and [N m], [m] and
    [N] for a prismatic joint.

    Attributes
    ----------
    name, version : str
    route : str
        How the model reached the engine: "URDF text, own parser", "SerialArm", "pin.Model".
    """

    name: str
    version: str
    #: how the model reached the engine: "URDF text, own parser", or as a value: "SerialArm",
    #: "RobotTree", "pin.Model"
    route: str

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool (of a tree's last moving link) in the base frame.

        Parameters
        ----------
        q : array-like, shape (..., n)
            [rad]

        Returns
        -------
        ndarray, shape (..., 4, 4)
            Homogeneous matrix; lengths in [m].
        """
        ...

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Joint torques of rigid bodies and motor inertia, without damping or friction.

        Parameters
        ----------
        q, qd, qdd : array-like, shape (..., n)
            [rad], [rad/s], [rad/s²]

        Returns
        -------
        ndarray, shape (..., n)
            [N m]
        """
        ...

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Joint accelerations.

        Parameters
        ----------
        q, qd, tau : array-like, shape (..., n)
            [rad], [rad/s], [N m]

        Returns
        -------
        ndarray, shape (..., n)
            [rad/s²]
        """
        ...

    def mass_matrix(self, q: Array) -> Array:
        """The joint-space mass matrix M(q), both triangles filled.

        Parameters
        ----------
        q : array-like, shape (..., n)
            [rad]

        Returns
        -------
        ndarray, shape (..., n, n)
            [kg m²]
        """
        ...

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """The torque C(q, q̇) q̇ + g(q).

        Parameters
        ----------
        q, qd : array-like, shape (..., n)
            [rad], [rad/s]

        Returns
        -------
        ndarray, shape (..., n)
            [N m]
        """
        ...

    def gravity_torque(self, q: Array) -> Array:
        """The gravity torque g(q).

        Parameters
        ----------
        q : array-like, shape (..., n)
            [rad]

        Returns
        -------
        ndarray, shape (..., n)
            [N m]
        """
        ...

    def imported_model(self) -> ImportedModel:
        """The joints and bodies that the engine has after reading.

        Returns
        -------
        ImportedModel
            In the arm's base frame, all joints at zero.
        """
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
        """A matrix C(q, q̇) with C q̇ the Coriolis and centrifugal torque.

        Parameters
        ----------
        q, qd : array-like, shape (..., n)
            [rad], [rad/s]

        Returns
        -------
        ndarray, shape (..., n, n)
            [N m s]
        """
        ...

    def torque_regressor(self, q: Array, qd: Array, qdd: Array) -> Array:
        """The regressor Y, with τ = Y π.

        Parameters
        ----------
        q, qd, qdd : array-like, shape (..., n)
            [rad], [rad/s], [rad/s²]

        Returns
        -------
        ndarray, shape (..., n, 10 n)
            For parameters expressed in the arm's link frames.
        """
        ...


class Stepper(Engine, Protocol):
    """An engine that integrates the arm's motion.

    Contact, joint limits, damping and friction are left out: what moves is the rigid-body model
    under gravity and the given torques.

    Attributes
    ----------
    integrators : dict of str to int
        Names of the engine's integrators and the order of each, the engine's default first.
    """

    #: names of the engine's integrators and the order of each, the engine's default first
    integrators: ClassVar[dict[str, int]]

    def step(
        self, q: Array, qd: Array, tau: Array, dt: float, integrator: str | None = None
    ) -> tuple[Array, Array]:
        """One step of the engine's integrator under constant torque.

        Parameters
        ----------
        q, qd, tau : ndarray, shape (n,)
            [rad], [rad/s], [N m]
        dt : float
            Step [s].
        integrator : str, optional
            One of `integrators`; the engine's default when None.

        Returns
        -------
        q, qd : ndarray, shape (n,)
            After the step [rad], [rad/s].
        """
        ...
