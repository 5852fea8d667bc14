"""Forward kinematics: the product B · J1(q1) · P1 · … , link by link."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike, NDArray

from .._errors import UsageError
from .._robot.as_arm import ModelSource, as_arm_or_tree
from .._robot.robot_tree import RobotTree
from .._robot.transforms import Transform
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

    @classmethod
    def of(cls, T: Transform) -> Frame:
        """A constant pose."""
        x, y, z = (Vector.of(axis) for axis in T.R.T)
        return cls((x, y, z), Vector.of(T.p))

    def then(self, other: Frame) -> Frame:
        """T_0j, for a pose T_ij in this frame i."""
        x, y, z = (self.direction(axis) for axis in other.axes)
        return Frame((x, y, z), self.point(other.p))

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
    base = Frame((columns[0], columns[1], columns[2]), chain.origin)
    poses: list[Frame] = []
    for link, q, cos, sin in zip(chain.links, state.q, state.cos, state.sin, strict=True):
        R = link.rotation(cos, sin)
        frame = poses[link.parent] if link.parent >= 0 else base
        axes = [frame.direction(R @ axis) for axis in _UNIT]
        p = frame.point(link.d + R @ link.link_vector(q))
        poses.append(Frame((axes[0], axes[1], axes[2]), p))
    return poses


def link_frames(arm: ModelSource, q: ArrayLike) -> NDArray[Any]:
    """Poses of all link frames in the base frame.

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q : array-like, shape (..., n)
        Joint positions [rad], or [m] for a prismatic joint; real or complex.

    Returns
    -------
    T : ndarray, shape (..., n, 4, 4)
        Homogeneous matrices T_0i of frames i = 1 … n [m]; of a tree, those of its N moving links.

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
    arm = as_arm_or_tree(arm)
    chain = chain_of(arm)

    def compute(state: JointState) -> list[Scalar]:
        return [entry for frame in frames(chain, state) for entry in frame.entries()]

    return evaluate(arm, compute, (len(chain.links), 4, 4), q)


def forward_kinematics(arm: ModelSource, q: ArrayLike, link: str | None = None) -> NDArray[Any]:
    """Pose of the tool frame (frame n), or of a link of a tree, in the base frame.

    Parameters
    ----------
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    q : array-like, shape (..., n)
        Joint positions [rad], or [m] for a prismatic joint; real or complex.
    link : str, optional
        Of a RobotTree: the link, moving or fixed.  An arm has one tool, and takes none.

    Returns
    -------
    T_base_tool : ndarray, shape (..., 4, 4)
        Homogeneous matrices [m].

    Raises
    ------
    InputError
        For an arm that cannot be read, a link that is not in the tree, or a `q` of another shape or
        with entries that are not finite numbers.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.forward_kinematics("paper", [0.0] * 6)[:3, 3].round(4).tolist()
    [-0.8172, -0.1914, -0.0055]
    """
    arm = as_arm_or_tree(arm)
    chain = chain_of(arm)
    if not isinstance(arm, RobotTree):
        if link is not None:
            raise UsageError(f"an arm takes no link, only a RobotTree; {link!r:.80} was given")
        return evaluate(arm, lambda state: frames(chain, state)[-1].entries(), (4, 4), q)
    if not isinstance(link, str) or link not in arm.placements:
        raise UsageError(f"{link!r:.80} is no link of {arm.name!r}")
    index, pose = arm.placements[link]
    T_moving_link = Frame.of(pose)

    def compute(state: JointState) -> list[Scalar]:
        moving = frames(chain, state)[index] if index >= 0 else Frame.of(Transform.identity())
        return moving.then(T_moving_link).entries()

    return evaluate(arm, compute, (4, 4), q)
