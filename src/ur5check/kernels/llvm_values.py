"""Python's arithmetic, written down as LLVM's instructions: on `LANES` float64 side by side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from llvmlite import ir

__all__ = ["LANES", "VECTOR", "Values", "constant"]

#: One AVX-512 register; LLVM makes two or four of it where registers are shorter.
LANES = 8

VECTOR = ir.VectorType(ir.DoubleType(), LANES)

#: A product and a sum may become one fused multiply-add; nothing else may be moved or dropped,
#: since the reduction of angles needs every rounding where it stands (`sincos`).
_FLAGS = ("contract",)


@dataclass(frozen=True, slots=True)
class Values:
    """Eight values in a register.  Numbers beside them stand for eight of the same."""

    builder: ir.IRBuilder
    register: Any

    def __neg__(self) -> Values:
        return Values(self.builder, self.builder.fneg(self.register, flags=_FLAGS))

    def __add__(self, other: Values | float) -> Values:
        return self._written(self.builder.fadd, self, other)

    def __radd__(self, other: float) -> Values:
        return self._written(self.builder.fadd, other, self)

    def __sub__(self, other: Values | float) -> Values:
        return self._written(self.builder.fsub, self, other)

    def __rsub__(self, other: float) -> Values:
        return self._written(self.builder.fsub, other, self)

    def __mul__(self, other: Values | float) -> Values:
        return self._written(self.builder.fmul, self, other)

    def __rmul__(self, other: float) -> Values:
        return self._written(self.builder.fmul, other, self)

    def _written(
        self, instruction: Callable[..., Any], left: Values | float, right: Values | float
    ) -> Values:
        operands = (_register(side) for side in (left, right))
        return Values(self.builder, instruction(*operands, flags=_FLAGS))


def constant(number: float) -> Any:
    """A number, eight times."""
    return ir.Constant(VECTOR, [float(number)] * LANES)


def _register(value: Values | float) -> Any:
    return value.register if isinstance(value, Values) else constant(value)
