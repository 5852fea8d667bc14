"""Random states by machine code: Philox words, each placed in its interval, in one pass.

LLVM text, compiled through llvmlite; imported only where that is installed.  The numbers are those
of NumPy in `random_states`, to the bit: each product and each sum is rounded on its own.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

import numpy as np
from llvmlite import ir

from .._dynamics.compiled.llvm_values import (
    INTEGER,
    LANES,
    VECTOR,
    counted_loop,
    integer,
)
from .._dynamics.compiled.machine_code import MachineCode, machine_code
from .._robot.transforms import Array
from .philox import KEY_STEPS, MULTIPLIERS, ROUNDS

__all__ = ["drawn"]

_WORDS = ir.VectorType(INTEGER, LANES)  # 32-bit words in 64 bits each, as their products need
_GROUP = 4  # rows that one counter fills
_ARGUMENTS = (*[ctypes.c_uint64] * 2, *[ctypes.c_int64] * 2, *[ctypes.c_void_p] * 3)


def drawn(seed: int, block: int, width: Array, lower: Array, length: int) -> Array:
    """`random_states.drawn`, compiled."""
    rows = len(width)
    padded = np.zeros((2, rows + -rows % _GROUP))
    padded[:, :rows] = width, lower
    out = np.empty((padded.shape[1], length + -length % LANES))
    addresses = (array.ctypes.data for array in (*padded, out))
    _compiled()(seed, block, len(out) // _GROUP, out.shape[1], *addresses)
    return out[:rows, :length]


@cache
def _compiled() -> MachineCode:
    return MachineCode(machine_code(_text()), _ARGUMENTS)


def _text() -> str:
    """`run(seed, block, groups, length, width, lower, out)`: out of shape (4 groups, length)."""
    module = ir.Module("philox")
    kinds = [INTEGER] * 4 + [ir.PointerType()] * 3
    run = ir.Function(module, ir.FunctionType(ir.VoidType(), kinds), "run")
    seed, block, groups, length, width, lower, out = run.args
    build = ir.IRBuilder(run.append_basic_block())
    low = integer(0xFFFFFFFF)
    keys = _round_keys(build, seed)
    block_words = [_repeated(build, word) for word in _halves(build, block)]
    lanes = ir.Constant(_WORDS, list(range(LANES)))

    def number(address: Any, index: Any) -> Any:
        return build.gep(address, [index], source_etype=ir.DoubleType())

    with counted_loop(build, groups) as group:
        first = build.mul(group, integer(_GROUP))
        rows = [build.add(first, integer(i)) for i in range(_GROUP)]
        scales = [
            [_repeated(build, build.load(number(given, row), typ=ir.DoubleType())) for row in rows]
            for given in (width, lower)
        ]
        group_word = _repeated(build, build.and_(group, low))
        with counted_loop(build, length, LANES) as k:
            states = build.add(_repeated(build, k), lanes)
            words = _ten_rounds(build, [states, group_word, *block_words], keys)
            for row, word, wide, start in zip(rows, words, *scales, strict=True):
                narrow = build.trunc(word, ir.VectorType(ir.IntType(32), LANES))
                value = build.fadd(build.fmul(build.uitofp(narrow, VECTOR), wide), start)
                place = number(out, build.add(build.mul(row, length), k))
                build.store(value, place, align=8)
    build.ret_void()
    return str(module)


def _ten_rounds(build: ir.IRBuilder, c: list[Any], keys: list[list[Any]]) -> list[Any]:
    """`philox._ten_rounds` of eight counters."""
    first, second = (ir.Constant(_WORDS, [factor] * LANES) for factor in MULTIPLIERS)
    low, half = (ir.Constant(_WORDS, [number] * LANES) for number in (0xFFFFFFFF, 32))
    for k0, k1 in keys:
        p, r = build.mul(first, c[0]), build.mul(second, c[2])
        c = [
            build.xor(build.xor(build.lshr(r, half), c[1]), k0),
            build.and_(r, low),
            build.xor(build.xor(build.lshr(p, half), c[3]), k1),
            build.and_(p, low),
        ]
    return c


def _round_keys(build: ir.IRBuilder, seed: Any) -> list[list[Any]]:
    """The two key words of each round."""
    keys = _halves(build, seed)
    rounds = []
    for _ in range(ROUNDS):
        rounds.append([_repeated(build, key) for key in keys])
        keys = [
            build.and_(build.add(key, integer(step)), integer(0xFFFFFFFF))
            for key, step in zip(keys, KEY_STEPS, strict=True)
        ]
    return rounds


def _halves(build: ir.IRBuilder, word: Any) -> list[Any]:
    """The low and the high 32 bits of 64."""
    return [build.and_(word, integer(0xFFFFFFFF)), build.lshr(word, integer(32))]


def _repeated(build: ir.IRBuilder, value: Any) -> Any:
    """A number or an integer in all lanes."""
    kind = ir.VectorType(value.type, LANES)
    single = build.insert_element(
        ir.Constant(kind, ir.Undefined), value, ir.Constant(ir.IntType(32), 0)
    )
    mask = ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES)
    return build.shuffle_vector(single, ir.Constant(kind, ir.Undefined), mask)
