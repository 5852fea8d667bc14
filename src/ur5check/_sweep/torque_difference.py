"""The one place where a sweep meets an algorithm: the torque difference of a block of states."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from .._dynamics.compiled.kernel import compile_difference
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["TorqueDifference", "torque_difference"]


@dataclass(frozen=True)
class TorqueDifference:
    """Δτ = τ_a − τ_b of two arms in one set of joint coordinates.

    engine : what computes it; a sweep does not change engines on the way
    of : (q, qd, qdd), each of shape (N, n), to Δτ of shape (N, n) [N m].  States come as
        transposed views of rows, one row a joint, and may be returned so: then nothing is copied
    """

    engine: str
    of: Callable[[Array, Array, Array], Array]


def torque_difference(a: SerialArm, b: SerialArm) -> TorqueDifference:
    """By a kernel of the difference: machine code where llvmlite is installed, else NumPy."""
    kernel = compile_difference(a, b)

    def of(q: Array, qd: Array, qdd: Array) -> Array:
        return kernel(q.T, qd.T, qdd.T, layout="joints").T

    return TorqueDifference(kernel.path, of)
