"""A closed form as plain values for JSON.  Every field is documented in docs/json.md."""

from __future__ import annotations

from collections.abc import Sequence

from .._dynamics.symbolic.derivation import Derivation
from .._dynamics.symbolic.program import Assignment, Operations
from .._robot.serial_arm import SerialArm
from .json_head import json_head
from .json_values import Report, model_value, strict

__all__ = ["derive_json"]


def derive_json(arm: SerialArm, derivation: Derivation, *, command: str = "") -> Report:
    """`derive --to json` as ur5check.closed-form/1."""
    program = derivation.program
    return strict(
        {
            **json_head("closed-form", [arm], command),
            "model": model_value(arm),
            "quantity": program.quantity,
            "unit": program.unit,
            "shape": program.shape,
            "arguments": program.arguments,
            "names": program.inputs,
            "parameters": dict(program.parameters),
            "setup": _lines(program.setup),
            "assignments": _lines(program.assignments),
            "outputs": _lines(program.outputs),
            "operations": _operations(program.operations),
            "setup_operations": _operations(program.setup_operations),
            "stages": [
                {"stage": stage, "operations": _operations(operations)}
                for stage, operations in derivation.stages
            ],
            "seconds": derivation.seconds,
        }
    )


def _lines(lines: Sequence[Assignment]) -> list[Report]:
    return [
        {
            "name": line.name,
            "terms": [{"k": term.k, "factors": term.factors} for term in line.terms],
        }
        for line in lines
    ]


def _operations(operations: Operations) -> Report:
    return {
        "multiplications": operations.multiplications,
        "additions": operations.additions,
        "total": operations.total,
    }
