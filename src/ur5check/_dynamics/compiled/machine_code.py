"""LLVM's text to machine code for this processor, kept as bytes; and machine code, called.

Compiling takes a tenth of a second, loading what was kept two milliseconds.  LLVM comes with
llvmlite, the compiler beneath Numba.  Numba itself would read the same lines as Python, which takes
it ten times as long, and its start alone takes a quarter of a second in every process.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numpy as np

from ..._robot.transforms import Array

__all__ = ["ARRAYS", "BLOCK", "MachineCode", "machine_code", "processor"]

#: What `run` takes, in order; see `llvm_source`.
ARRAYS = ("q", "qd", "qdd", "out")

BLOCK = 64  # states that go through the line together
_STATE_ROWS = 5  # of scratch for each joint: q, cos, sin, q̇, q̈
_ALIGNED = 64  # bytes, as vector registers like it

_RUN = ctypes.CFUNCTYPE(
    None,
    ctypes.c_int64,
    ctypes.c_void_p,
    *[ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64] * len(ARRAYS),
)


def processor() -> str:
    """Whom machine code is for, and who made it: it is of no use to others."""
    features = llvm.get_host_cpu_features().flatten()
    return f"llvmlite {llvmlite.__version__} {llvm.get_host_cpu_name()} {features}"


def machine_code(text: str) -> bytes:
    """An object file of a module's text.  Raises RuntimeError, from LLVM, for what is no module."""
    machine, module = _machine(), llvm.parse_assembly(text)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    # The text is as wide and as long as it should be: made longer, it takes longer to compile only.
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_unrolling = options.loop_vectorization = options.slp_vectorization = False
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    return bytes(machine.emit_object(module))


class MachineCode:
    """A compiled `run`, to be called from any thread; it works outside Python's lock."""

    def __init__(self, code: bytes) -> None:
        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        self._engine.finalize_object()
        self._run = _RUN(self._engine.get_function_address("run"))

    def __call__(self, q: Array, qd: Array | None, qdd: Array | None, out: Array) -> None:
        """Every array float64 of shape (N, …), with any strides; None where none is read."""
        count, entries = out.shape
        scratch = _scratch((_STATE_ROWS * q.shape[1] + entries) * BLOCK)
        arrays: list[Any] = []
        for array in (q, qd, qdd, out):
            arrays += [None, 0, 0] if array is None else [array.ctypes.data, *array.strides]
        self._run(count, scratch.ctypes.data, *arrays)


def _machine() -> Any:
    """LLVM's idea of this processor; a new one each time, since whoever takes one keeps it."""
    _start()
    return llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=llvm.get_host_cpu_features().flatten(),
        opt=3,
        codemodel="jitdefault",
        jit=True,
    )


@cache
def _start() -> None:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def _scratch(size: int) -> Array:
    spare = _ALIGNED // 8
    room = np.zeros(size + spare)
    first = -room.ctypes.data % _ALIGNED // 8
    return room[first : first + size]
