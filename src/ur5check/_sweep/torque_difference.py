"""The torque difference of a block of states, by a kernel."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from .._dynamics.compiled.kernel import compile_difference
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["TorqueDifference", "torque_difference"]


@dataclass(frozen=True)
class TorqueDifference:
    """Δτ = τ_a − τ_b of two arms in the same joint coordinates.

    engine : the path of the kernel, the same for the whole sweep
    of : (q, qd, qdd), each of shape (N, n), to Δτ of shape (N, n) [N m].  All are transposed views
        of arrays with one row per joint, so that nothing is copied
    """

    engine: str
    of: Callable[[Array, Array, Array], Array]


def torque_difference(a: SerialArm, b: SerialArm) -> TorqueDifference:
    """The kernel of the difference: machine code where llvmlite is installed, else NumPy."""
    kernel = compile_difference(a, b)

    def of(q: Array, qd: Array, qdd: Array) -> Array:
        return kernel(q.T, qd.T, qdd.T, layout="joints").T

    return TorqueDifference(kernel.path, of)
