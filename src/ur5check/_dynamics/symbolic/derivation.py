"""A closed form, and what it took: operations at each stage, and time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter

from ..._robot.serial_arm import SerialArm
from .program import Operations, Program
from .quantities import Quantity
from .trace import Parameters, as_written, trace

__all__ = ["Derivation", "derive"]


@dataclass(frozen=True, eq=False)
class Derivation:
    """A program and the road to it.

    written : operations of the recursion as it is written, each equal value formed once
    factored : of the arm's own numbers, factored
    program : with inertial parameters regrouped before, where they are numbers
    seconds : that all this took
    """

    written: Operations
    factored: Operations
    program: Program
    seconds: float

    @property
    def stages(self) -> Sequence[tuple[str, Operations]]:
        """What was done, and the operations that were left then."""
        stages = [
            ("the recursion as written, equal values shared", self.written),
            ("constants folded, gravity as lift of the base, factored", self.factored),
        ]
        if not self.program.parameters and self.program.quantity != "regressor":
            stages.append(("inertial parameters regrouped before", self.program.operations))
        return stages


def derive(
    arm: SerialArm, quantity: Quantity = "tau", *, parameters: Parameters = "numeric"
) -> Derivation:
    """The closed form of a quantity, as `trace` finds it, and how it came about.

    Raises UsageError for a quantity that there is none of.
    """
    start = perf_counter()
    written = as_written(arm, quantity, parameters=parameters)
    plain = trace(arm, quantity, parameters=parameters, regroup=False)
    best = plain if parameters == "symbolic" else trace(arm, quantity)
    return Derivation(written, plain.operations, best, perf_counter() - start)
