"""`ur5check derive --to json`: a closed form as JSON."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from .._dynamics.symbolic.derivation import Derivation
from .._dynamics.symbolic.program import Assignment, Operations
from .._robot.serial_arm import SerialArm
from .json_report import Report, head
from .json_values import Model, OperationsValue, model_value

__all__ = ["DeriveReport", "derive_json"]


class TermValue(msgspec.Struct, frozen=True):
    """k times the product of the factors."""

    k: float
    factors: list[str]


class AssignmentValue(msgspec.Struct, frozen=True):
    """name = Σ terms."""

    name: str
    terms: list[TermValue]


class StageValue(msgspec.Struct, frozen=True):
    """A stage of the derivation, and the operations after it."""

    stage: str
    operations: OperationsValue


class DeriveReport(Report, frozen=True, kw_only=True, tag="ur5check.derive/2"):
    """A closed form as assignments in order."""

    model: Model
    quantity: str
    unit: str
    shape: list[int]
    arguments: list[str]
    names: list[str]
    parameters: dict[str, float]
    setup: list[AssignmentValue]
    assignments: list[AssignmentValue]
    outputs: list[AssignmentValue]
    operations: OperationsValue
    setup_operations: OperationsValue
    stages: list[StageValue]
    seconds: float


def derive_json(arm: SerialArm, derivation: Derivation, *, command: str = "") -> DeriveReport:
    """The report of `ur5check derive`."""
    program = derivation.program
    return DeriveReport(
        **head([arm], command),
        model=model_value(arm),
        quantity=program.quantity,
        unit=program.unit,
        shape=list(program.shape),
        arguments=list(program.arguments),
        names=list(program.inputs),
        parameters=dict(program.parameters),
        setup=_assignments(program.setup),
        assignments=_assignments(program.assignments),
        outputs=_assignments(program.outputs),
        operations=_operations(program.operations),
        setup_operations=_operations(program.setup_operations),
        stages=[StageValue(stage, _operations(count)) for stage, count in derivation.stages],
        seconds=derivation.seconds,
    )


def _assignments(lines: Sequence[Assignment]) -> list[AssignmentValue]:
    return [
        AssignmentValue(line.name, [TermValue(term.k, list(term.factors)) for term in line.terms])
        for line in lines
    ]


def _operations(count: Operations) -> OperationsValue:
    return OperationsValue(count.multiplications, count.additions, count.total)
