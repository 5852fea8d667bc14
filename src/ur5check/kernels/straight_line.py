"""A straight line inside a Numba function, without Numba's reading of it.

Numba infers the type of every name and rewrites every statement several times, which takes two
seconds for the thousand lines of a regressor.  Here every name is a float64 and no line branches,
so each operation is handed to LLVM as it stands, and LLVM does to it what it would have done
anyway: unroll the loop around the line, and take 4 or 8 states at a time.

The lines are Python, of one kind only: `name = …` or `w[k + 64] = …`, of names, numbers, + − ×,
signs, and entries `w[k + 128]`.  Generated modules import this; nothing else does, for it needs
Numba.
"""

from __future__ import annotations

import ast
from typing import Any

from llvmlite import ir
from numba import types
from numba.core.errors import NumbaTypeError
from numba.extending import intrinsic

__all__ = ["straight_line"]

_DOUBLE = ir.DoubleType()

#: A product and a sum may become one fused multiply-add; nothing else may be moved or dropped.
_FLAGS = ("contract",)

_SCRATCH = types.Array(types.float64, 1, "C")


def straight_line(text: str) -> Any:
    """`line(w, k)`, to be called in a Numba function: runs the lines on w, from index k on.

    text : lines as above;  w : float64, shape (rows,), contiguous;  k : an integer

    A caller's compilation raises Numba's LoweringError, with the line, for text of another kind.
    """

    @intrinsic
    def line(_typing: Any, w: Any, k: Any) -> Any:
        if w != _SCRATCH or not isinstance(k, types.Integer):
            raise NumbaTypeError(f"a straight line takes {_SCRATCH} and an integer, not {w}, {k}")

        def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            data = context.make_array(signature.args[0])(context, builder, arguments[0]).data
            writer = _Writer(builder, data, arguments[1])
            for statement in ast.parse(text).body:  # not before: code on disk needs none
                writer.write(statement)
            return context.get_dummy_value()

        return types.void(w, k), build

    return line


class _Writer:
    """Writes statements as operations of LLVM."""

    def __init__(self, builder: Any, data: Any, k: Any) -> None:
        self._builder, self._data, self._k = builder, data, k
        self._names: dict[str, Any] = {}

    def write(self, statement: ast.stmt) -> None:
        try:
            match statement:
                case ast.Assign(targets=targets):
                    value = self._value(statement.value)
                    for target in targets:
                        self._give(target, value)
                case _:
                    raise TypeError("no assignment")
        except (TypeError, KeyError) as error:
            raise ValueError(f"no straight line: {ast.unparse(statement)} ({error})") from None

    def _give(self, target: ast.expr, value: Any) -> None:
        match target:
            case ast.Name(name):
                self._names[name] = value
            case _:
                self._builder.store(value, self._place(target))

    def _value(self, node: ast.expr) -> Any:
        builder, value = self._builder, self._value
        match node:
            case ast.Name(name):
                return self._names[name]
            case ast.Constant(float(number)):
                return ir.Constant(_DOUBLE, number)
            case ast.UnaryOp(ast.USub(), operand):
                return builder.fneg(value(operand), flags=_FLAGS)
            case ast.BinOp(left, ast.Add(), right):
                return builder.fadd(value(left), value(right), flags=_FLAGS)
            case ast.BinOp(left, ast.Sub(), right):
                return builder.fsub(value(left), value(right), flags=_FLAGS)
            case ast.BinOp(left, ast.Mult(), right):
                return builder.fmul(value(left), value(right), flags=_FLAGS)
        return builder.load(self._place(node))

    def _place(self, node: ast.expr) -> Any:
        match node:
            case ast.Subscript(ast.Name("w"), ast.Name("k")):
                row = 0
            case ast.Subscript(
                ast.Name("w"), ast.BinOp(ast.Name("k"), ast.Add(), ast.Constant(int(row)))
            ):
                pass
            case _:
                raise TypeError(f"{ast.unparse(node)} is neither w[k] nor w[k + 64]")
        index = self._builder.add(self._k, ir.Constant(self._k.type, row))
        return self._builder.gep(self._data, [index], inbounds=True)
