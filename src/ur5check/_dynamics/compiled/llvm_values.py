"""Python's arithmetic as LLVM instructions on vectors of `LANES` float64."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from llvmlite import ir

__all__ = [
    "INTEGER",
    "LANES",
    "VECTOR",
    "Values",
    "constant",
    "counted_loop",
    "integer",
    "transposed",
]

#: One AVX-512 register; LLVM splits it where registers are shorter.
LANES = 8

VECTOR = ir.VectorType(ir.DoubleType(), LANES)
INTEGER = ir.IntType(64)
_ALL = range(LANES)

#: A product and a sum may become a fused multiply-add; nothing else may be reordered, since the
#: reduction of angles depends on every rounding (`sincos`).
_FLAGS = ("contract",)


@dataclass(frozen=True, slots=True)
class Values:
    """Eight values in a register; a number combined with them is repeated eight times."""

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


def integer(value: Any) -> Any:
    """A whole number; what is an integer of LLVM already is returned as it is."""
    return ir.Constant(INTEGER, value) if isinstance(value, int) else value


@contextmanager
def counted_loop(builder: ir.IRBuilder, stop: Any, step: int = 1) -> Iterator[Any]:
    """Instructions written inside are executed for k = 0, step, 2 step, … below stop."""
    before = builder.block
    head, body, after = (builder.append_basic_block(name) for name in ("head", "body", "after"))
    builder.branch(head)
    builder.position_at_end(head)
    k = builder.phi(INTEGER)
    k.add_incoming(integer(0), before)
    builder.cbranch(builder.icmp_signed("<", k, integer(stop)), body, after)
    builder.position_at_end(body)
    yield k
    k.add_incoming(builder.add(k, integer(step)), builder.block)
    builder.branch(head)
    builder.position_at_end(after)


def transposed(rows: Sequence[Values]) -> list[Values]:
    """The transpose of eight rows of eight: swaps neighbours, then pairs, then fours."""
    rows = list(rows)
    for step in (1, 2, 4):
        for i in (i for i in range(LANES) if not i & step):
            pair = rows[i], rows[i + step]
            rows[i] = _chosen(*pair, [j if not j & step else j - step + LANES for j in _ALL])
            rows[i + step] = _chosen(*pair, [j + LANES if j & step else j + step for j in _ALL])
    return rows


def _chosen(first: Values, second: Values, places: Sequence[int]) -> Values:
    """Values of two registers: places 0 … 7 are the first's, 8 … 15 the second's."""
    mask = ir.Constant(ir.VectorType(ir.IntType(32), LANES), list(places))
    register = first.builder.shuffle_vector(first.register, second.register, mask)
    return Values(first.builder, register)


def _register(value: Values | float) -> Any:
    return value.register if isinstance(value, Values) else constant(value)
