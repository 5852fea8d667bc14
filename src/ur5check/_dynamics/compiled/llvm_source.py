"""A program as a module for LLVM, on blocks of 64 states.

    gather   copies 64 states to a scratch array, one row per q, q̇ or q̈ of a joint
    turn     computes sines and cosines (`sincos`)
    line     runs the program on eight states at a time, without calls or branches
    scatter  copies its rows to the result

The scratch array (36 rows for a UR5's torques, 18 kB) fits into the first-level cache.
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from typing import Any

from llvmlite import ir

from ..symbolic.infix_text import description
from ..symbolic.program import STATE, Program, read_input, value_of
from .llvm_values import INTEGER, LANES, VECTOR, Values, constant, counted_loop, integer, transposed
from .machine_code import ARRAYS, BLOCK
from .sincos import FAR, turned

__all__ = ["llvm_source"]

_BYTE, _DOUBLE, _ADDRESS = ir.IntType(8), ir.DoubleType(), ir.PointerType()


def llvm_source(program: Program) -> str:
    """The module's text.  Its one function is called by `machine_code.MachineCode`:

    run(count, scratch, and of q, qd, qdd and the result: address, bytes from state to state, bytes
    from entry to entry).  Arrays that the program does not read may be null.
    """
    return "\n".join(
        [*(f"; {line}" for line in description(program)), str(_Writer(program).module)]
    )


class _Writer:
    """Writes `run`, from its first instruction to its last."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.module = ir.Module("kernel")
        kinds = [INTEGER, _ADDRESS, *[_ADDRESS, INTEGER, INTEGER] * len(ARRAYS)]
        run = ir.Function(self.module, ir.FunctionType(ir.VoidType(), kinds), "run")
        count, self.scratch, *rest = run.args
        self.arrays = {name: rest[3 * i : 3 * i + 3] for i, name in enumerate(ARRAYS)}
        self.build = ir.IRBuilder(run.append_basic_block())
        self.largest = self.build.alloca(VECTOR)
        with self.loop(count, BLOCK) as start:
            here = self.call("llvm.smin.i64", self.build.sub(count, start), integer(BLOCK))
            for name in program.arguments:
                self.gather(name, start, here)
            self.turn()
            self.line()
            self.scatter(start, here)
        self.build.ret_void()

    def gather(self, name: str, start: Any, here: Any) -> None:
        """States start, start + 1, … of an array, to its rows; the rest of a row is unchanged."""
        with self.loop(self.program.n) as joint, self.loop(here) as k:
            entry = self.entry(name, self.build.add(start, k), joint)
            value = self.build.load(entry, typ=_DOUBLE, align=1)
            self.build.store(value, self.place(name, joint, k))

    def turn(self) -> None:
        """Rows of cosines and sines: by `sincos`, and by libm for each angle beyond `FAR`.

        Angle by angle, so that a state's digits do not depend on others in its block.
        """
        angles = self.program.n * BLOCK  # the rows of all joints, one after the other
        self.build.store(constant(0.0), self.largest)
        with self.loop(angles, LANES) as k:
            cosine, sine = turned(self.load("q", 0, k))
            self.store(cosine, "c", 0, k)
            self.store(sine, "s", 0, k)
            size = self.call("llvm.fabs.v8f64", self.load("q", 0, k).register)
            largest = self.build.load(self.largest, typ=VECTOR)
            self.build.store(self.call("llvm.maxnum.v8f64", largest, size), self.largest)
        largest = self.build.load(self.largest, typ=VECTOR)
        largest = self.call("llvm.vector.reduce.fmax.v8f64", largest, gives=_DOUBLE)
        with self.build.if_then(self.too_large(largest)), self.loop(angles) as k:
            angle = self.build.load(self.place("q", 0, k), typ=_DOUBLE)
            with self.build.if_then(self.too_large(self.call("llvm.fabs.f64", angle))):
                for row, function in (("c", "llvm.cos.f64"), ("s", "llvm.sin.f64")):
                    self.build.store(self.call(function, angle), self.place(row, 0, k))

    def line(self) -> None:
        """The program, for eight states at a time."""
        with self.loop(BLOCK, LANES) as k:
            values: dict[str, Values | float] = {
                name: self.load(*read_input(name), k) for name in self.program.inputs
            }
            for line in self.program.assignments:
                values[line.name] = value_of(line, values)
            for place, line in enumerate(self.program.outputs):
                self.store(value_of(line, values), "out", place, k)

    def scatter(self, start: Any, here: Any) -> None:
        """Copy the rows of results to the caller's array, along its contiguous axis."""
        build, (_, state_step, entry_step) = self.build, self.arrays["out"]
        done = self.scatter_eights(start, here)
        left = build.sub(integer(len(self.program.outputs)), done)

        def move(k: Any, index: Any) -> None:
            place = build.add(done, index)
            value = build.load(self.place("out", place, k), typ=_DOUBLE)
            build.store(value, self.entry("out", build.add(start, k), place), align=1)

        states_apart = build.icmp_signed(">=", state_step, entry_step)
        with build.if_else(states_apart) as (state_by_state, entry_by_entry):
            with (
                state_by_state,
                self.loop(here) as k,
                self.loop(left) as index,
            ):
                move(k, index)
            with (
                entry_by_entry,
                self.loop(left) as index,
                self.loop(here) as k,
            ):
                move(k, index)

    def scatter_eights(self, start: Any, here: Any) -> Any:
        """Of a whole block with contiguous entries, copy eight at once; returns how many entries.

        One by one, copying a matrix would take as long as computing it.
        """
        build, (_, _, entry_step) = self.build, self.arrays["out"]
        whole = build.icmp_signed("==", here, integer(BLOCK))
        together = build.and_(whole, build.icmp_signed("==", entry_step, integer(8)))
        eights = len(self.program.outputs) // LANES * LANES
        with (
            build.if_then(together),
            self.loop(BLOCK, LANES) as k,
            self.loop(eights, LANES) as first,
        ):
            rows = [self.load("out", build.add(first, integer(i)), k) for i in range(LANES)]
            for i, state in enumerate(transposed(rows)):
                k_i = build.add(start, build.add(k, integer(i)))
                build.store(state.register, self.entry("out", k_i, first), align=1)
        return build.select(together, integer(eights), integer(0))

    def loop(self, stop: Any, step: int = 1) -> AbstractContextManager[Any]:
        """`counted_loop` at the current position."""
        return counted_loop(self.build, stop, step)

    def entry(self, name: str, state: Any, index: Any) -> Any:
        """The address of one entry of the caller's array."""
        address, state_step, entry_step = self.arrays[name]
        offset = self.build.add(
            self.build.mul(state, state_step), self.build.mul(index, entry_step)
        )
        return self.build.gep(address, [offset], source_etype=_BYTE)

    def place(self, name: str, index: Any, k: Any) -> Any:
        """The address of state k in a scratch row: those of STATE, joint by joint, then results."""
        first = (*STATE, "out").index(name) * self.program.n
        row = self.build.add(integer(index), integer(first))
        place = self.build.add(self.build.mul(row, integer(BLOCK)), k)
        return self.build.gep(self.scratch, [place], inbounds=True, source_etype=_DOUBLE)

    def load(self, name: str, index: Any, k: Any) -> Values:
        """Eight states' values, from state k on."""
        register = self.build.load(self.place(name, index, k), typ=VECTOR, align=8 * LANES)
        return Values(self.build, register)

    def store(self, value: Values | float, name: str, index: int, k: Any) -> None:
        register = value.register if isinstance(value, Values) else constant(value)
        self.build.store(register, self.place(name, index, k), align=8 * LANES)

    def too_large(self, size: Any) -> Any:
        """Whether an angle is too large for `sincos`; false for nan."""
        return self.build.fcmp_ordered(">", size, ir.Constant(_DOUBLE, FAR))

    def call(self, name: str, *arguments: Any, gives: ir.Type | None = None) -> Any:
        """Call an intrinsic of LLVM; by default it returns the type of its first argument."""
        if name not in self.module.globals:
            takes = [argument.type for argument in arguments]
            ir.Function(self.module, ir.FunctionType(gives or takes[0], takes), name)
        return self.build.call(self.module.globals[name], arguments)
