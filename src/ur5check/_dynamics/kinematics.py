"""Forward kinematics: the product B · J1(q1) · P1 · … , link by link."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike, NDArray

from .._robot.as_arm import ArmSource, as_arm
from .batching import JointState, evaluate
from .chain_constants import Chain, chain_of
from .vectors import Scalar, Vector

__all__ = ["Frame", "forward_kinematics", "frames", "link_frames"]

_UNIT = (Vector(1.0, 0.0, 0.0), Vector(0.0, 1.0, 0.0), Vector(0.0, 0.0, 1.0))


class Frame:
    """A pose T_0i in components: axes (columns of R) and origin p, in the base frame."""

    __slots__ = ("axes", "p")

    def __init__(self, axes: tuple[Vector, Vector, Vector], p: Vector) -> None:
        self.axes, self.p = axes, p

    def direction(self, v: Vector) -> Vector:
        """R v: a direction given in this frame, in the base frame."""
        x, y, z = self.axes
        along: Vector = x * v.x + y * v.y + z * v.z
        return along

    def point(self, v: Vector) -> Vector:
        """T v: a point given in this frame, in the base frame."""
        return self.p + self.direction(v)

    def entries(self) -> list[Scalar]:
        """The homogeneous matrix, row by row."""
        x, y, z = self.axes
        rows = zip(x, y, z, self.p, strict=True)
        return [entry for row in rows for entry in row] + [0.0, 0.0, 0.0, 1.0]


def frames(chain: Chain, state: JointState) -> list[Frame]:
    """Poses of frames 1 … n in the base frame: T_0i = T_0,i−1 · J_i(q_i) · P_i."""
    columns = [chain.base @ axis for axis in _UNIT]
    frame = Frame((columns[0], columns[1], columns[2]), chain.origin)
    poses = []
    for link, q, cos, sin in zip(chain.links, state.q, state.cos, state.sin, strict=True):
        R = link.rotation(cos, sin)
        axes = [frame.direction(R @ axis) for axis in _UNIT]
        p = frame.point(R @ link.link_vector(q))
        frame = Frame((axes[0], axes[1], axes[2]), p)
        poses.append(frame)
    return poses


def link_frames(arm: ArmSource, q: ArrayLike) -> NDArray[Any]:
    """Poses of all link frames in the base frame.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    q : array-like, shape (..., n)
        Joint positions [rad], or [m] for a prismatic joint; real or complex.

    Returns
    -------
    T : ndarray, shape (..., n, 4, 4)
        Homogeneous matrices T_0i of frames i = 1 … n [m].

    Raises
    ------
    InputError
        For an arm that cannot be read, or a `q` of another shape or with entries that are not
        finite numbers.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.link_frames("paper", [0.0] * 6).shape
    (6, 4, 4)
    """
    arm = as_arm(arm)
    chain = chain_of(arm)

    def compute(state: JointState) -> list[Scalar]:
        return [entry for frame in frames(chain, state) for entry in frame.entries()]

    return evaluate(arm, compute, (arm.n, 4, 4), q)


def forward_kinematics(arm: ArmSource, q: ArrayLike) -> NDArray[Any]:
    """Pose of the tool frame (frame n) in the base frame.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    q : array-like, shape (..., n)
        Joint positions [rad], or [m] for a prismatic joint; real or complex.

    Returns
    -------
    T_base_tool : ndarray, shape (..., 4, 4)
        Homogeneous matrices [m].

    Raises
    ------
    InputError
        For an arm that cannot be read, or a `q` of another shape or with entries that are not
        finite numbers.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.forward_kinematics("paper", [0.0] * 6)[:3, 3].round(4).tolist()
    [-0.8172, -0.1914, -0.0055]
    """
    arm = as_arm(arm)
    chain = chain_of(arm)
    return evaluate(arm, lambda state: frames(chain, state)[-1].entries(), (4, 4), q)
