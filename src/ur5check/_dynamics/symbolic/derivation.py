"""A closed form with its operation counts at each stage, and the time of its derivation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter

from ..._arguments import choice
from ..._robot.as_arm import ArmSource, as_arm
from .program import Operations, Program
from .quantities import Quantity
from .trace import Parameters, as_written, trace

__all__ = ["Derivation", "derive"]


@dataclass(frozen=True, eq=False)
class Derivation:
    """A closed form and the operation counts of its derivation.

    Attributes
    ----------
    written : Operations
        Of the recursion as written, equal values shared.
    factored : Operations
        With the arm's own numbers, factored.
    program : Program
        With inertial parameters regrouped before, where they are numeric.
    seconds : float
        Time of the derivation [s].
    """

    written: Operations
    factored: Operations
    program: Program
    seconds: float

    @property
    def stages(self) -> Sequence[tuple[str, Operations]]:
        """Each step of the derivation, and the operations after it."""
        stages = [
            ("the recursion as written, equal values shared", self.written),
            ("constants folded, gravity as base acceleration, factored", self.factored),
        ]
        if not self.program.parameters and self.program.quantity != "regressor":
            stages.append(("inertial parameters regrouped before", self.program.operations))
        return stages


def derive(
    arm: ArmSource, quantity: Quantity = "tau", *, parameters: Parameters = "numeric"
) -> Derivation:
    """The closed form of a quantity by `trace`, with its operation counts.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    quantity : {"tau", "M", "C", "g", "bias", "regressor"}
        τ, M, C, g, C q̇ + g or Y.
    parameters : {"numeric", "symbolic"}
        The arm's numbers folded in, or as inputs.

    Returns
    -------
    Derivation

    Raises
    ------
    InputError
        For an arm that cannot be read, or an unknown quantity.

    Examples
    --------
    >>> import ur5check
    >>> derivation = ur5check.derive("paper", "g")
    >>> derivation.written.total > derivation.program.operations.total
    True
    """
    arm, start = as_arm(arm), perf_counter()
    choice("parameters", parameters, ("numeric", "symbolic"))
    written = as_written(arm, quantity, parameters=parameters)
    plain = trace(arm, quantity, parameters=parameters, regroup=False)
    best = plain if parameters == "symbolic" else trace(arm, quantity)
    return Derivation(written, plain.operations, best, perf_counter() - start)
