"""The regressor: τ = Y(q, q̇, q̈) π, linear in the ten inertial parameters of each link.

The order within a link is that of Pinocchio's `Inertia.toDynamicParameters`: m, m c, and the tensor
about the *origin* of frame i, Ixx Ixy Iyy Ixz Iyz Izz (`PARAMETERS`).  With a the acceleration of
origin i minus gravity, the force and the moment about that origin that move the link are

    f = m a + α × (m c) + ω × (ω × m c)
    n = (m c) × a + I_o α + ω × I_o ω

which are linear in (m, m c, I_o) (Khalil & Dombre, Modeling, Identification and Control of Robots,
2002, ch. 9).  The wrench of each parameter is carried to the base as in eqs (14) and (15) of the
paper.
"""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike, NDArray

from .._robot.as_arm import ModelSource, as_arm_or_tree
from .batching import JointState, evaluate, gravity_of
from .chain_constants import Chain, chain_of
from .recursion import LinkMotion, outward
from .vectors import ZERO, Scalar, Vector

__all__ = ["regressor_rows", "torque_regressor"]

_AXES = (Vector(1.0, 0.0, 0.0), Vector(0.0, 1.0, 0.0), Vector(0.0, 0.0, 1.0))
_TENSOR_ENTRIES = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))


def torque_regressor(
    arm: ModelSource,
    q: ArrayLike,
    qd: ArrayLike,
    qdd: ArrayLike,
    gravity: ArrayLike | None = None,
) -> NDArray[Any]:
    """The regressor of the joint torques, with rnea(arm, …) = Y @ arm.parameters() + armature ∘ q̈.

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q, qd, qdd : array-like, shape (..., n)
        Joint positions [rad], velocities [rad/s] and accelerations [rad/s²]; [m], [m/s] and [m/s²]
        for a prismatic joint.  Real or complex; leading axes broadcast.
    gravity : array-like, shape (3,), optional
        In the arm's base frame [m/s²]; `arm.gravity` when None.

    Returns
    -------
    Y : ndarray, shape (..., n, 10 n)
        Columns 10 i … 10 i + 9 are the parameters of link i + 1 (`Inertia.parameters`), in the
        frame of that link.  Y depends on geometry and gravity, not on inertias.  A tree has
        10 N columns for its N moving links.

    Raises
    ------
    InputError
        For an arm that cannot be read, or arrays of another shape, that do not broadcast, or with
        entries that are not finite numbers.

    References
    ----------
    Khalil & Dombre, Modeling, Identification and Control of Robots, 2002, ch. 9.

    Examples
    --------
    >>> import ur5check
    >>> rest = [0.0] * 6
    >>> ur5check.torque_regressor("paper", rest, rest, rest).shape
    (6, 60)
    """
    arm = as_arm_or_tree(arm)
    chain = chain_of(arm)
    g_0 = chain.inner_gravity(gravity_of(arm, gravity))

    def compute(state: JointState) -> list[Scalar]:
        return regressor_rows(chain, outward(chain, state, g_0))

    return evaluate(arm, compute, (arm.n, 10 * len(chain.links)), q, qd, qdd)


def regressor_rows(chain: Chain, motions: list[LinkMotion]) -> list[Scalar]:
    """Y of one block of states, row by row."""
    columns = [
        chain.of_coordinates(_carried_down(motions, i, f, moment))
        for i, motion in enumerate(motions)
        for f, moment in _unit_wrenches(motion)
    ]
    return [entry for row in zip(*columns, strict=True) for entry in row]


def _unit_wrenches(motion: LinkMotion) -> list[tuple[Vector, Vector]]:
    """(f, n) about the origin of frame i, for one unit of each of the ten parameters."""
    w, dw = motion.w, motion.dw
    a = motion.acceleration_at(motion.r) - motion.g
    wrenches = [(a, ZERO)]
    for axis in _AXES:
        wrenches.append((dw.cross(axis) + w.cross(w.cross(axis)), axis.cross(a)))
    for row, column in _TENSOR_ENTRIES:
        moment = _unit_tensor(row, column, dw) + w.cross(_unit_tensor(row, column, w))
        wrenches.append((ZERO, moment))
    return wrenches


def _unit_tensor(row: int, column: int, v: Vector) -> Vector:
    """E v, for the symmetric matrix E with ones at (row, column) and (column, row)."""
    components = tuple(v)
    product: Vector = _AXES[row] * components[column]
    return product if row == column else product + _AXES[column] * components[row]


def _carried_down(motions: list[LinkMotion], i: int, f: Vector, moment: Vector) -> list[Scalar]:
    """The torque at every joint of a wrench at the origin of frame i: 0 but from i to the base."""
    torques: list[Scalar] = [0.0] * len(motions)
    while i >= 0:
        motion = motions[i]
        moment = moment + motion.r.cross(f)  # now about the joint, still in frame i
        torques[i] = motion.link.b.dot(f if motion.link.prismatic else moment)
        f, moment = motion.R @ f, motion.R @ moment
        moment = moment + motion.link.d.cross(f)  # about the parent's origin, in its frame
        i = motion.link.parent
    return torques
