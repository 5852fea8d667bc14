"""Multiplications and additions at one state, in the recursion and in the generated program."""

from __future__ import annotations

from collections.abc import Sequence

from ur5check._dynamics.symbolic.quantities import Quantity
from ur5check._dynamics.symbolic.trace import as_written, trace
from ur5check._robot.serial_arm import SerialArm

from .random_chain import chain
from .result import OperationCount

__all__ = ["operations"]

_QUANTITIES: dict[str, Quantity] = {
    "torques": "tau",
    "mass matrix": "M",
    "Coriolis matrix": "C",
    "gravity torque": "g",
    "torque regressor": "regressor",
}


def operations(arm: SerialArm, lengths: Sequence[int], seed: int) -> tuple[OperationCount, ...]:
    """Every quantity of the arm, and the torques of longer chains."""
    longer = [_count(f"torques, {n} joints", chain(n, seed), "tau") for n in lengths]
    return (*(_count(what, arm, quantity) for what, quantity in _QUANTITIES.items()), *longer)


def _count(what: str, arm: SerialArm, quantity: Quantity) -> OperationCount:
    return OperationCount(what, as_written(arm, quantity), trace(arm, quantity).operations)
