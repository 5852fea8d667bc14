"""LLVM text compiled for this processor, and calls of the machine code.

Compiling a kernel takes 0.1 s, loading its object file from disk 2 ms.  LLVM comes with llvmlite.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from functools import cache
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numpy as np

from ..._robot.transforms import Array

__all__ = ["ARRAYS", "BLOCK", "KernelCode", "MachineCode", "machine_code", "processor"]

#: The arrays of `run`, in order; see `llvm_source`.
ARRAYS = ("q", "qd", "qdd", "out")

BLOCK = 64  # states of one block
_STATE_ROWS = 5  # of scratch for each joint: q, cos, sin, q̇, q̈
_ALIGNED = 64  # bytes, alignment of a vector register

_RUN = (
    ctypes.c_int64,
    ctypes.c_void_p,
    *[ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64] * len(ARRAYS),
)


def processor() -> str:
    """The processor and the compiler that machine code depends on."""
    features = llvm.get_host_cpu_features().flatten()
    return f"llvmlite {llvmlite.__version__} {llvm.get_host_cpu_name()} {features}"


def machine_code(text: str) -> bytes:
    """An object file of a module's text.  Raises RuntimeError, from LLVM, for what is no module."""
    machine, module = _machine(), llvm.parse_assembly(text)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    # The text is vectorised and unrolled already: doing it again only costs compilation time.
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    options.loop_unrolling = options.loop_vectorization = options.slp_vectorization = False
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    return bytes(machine.emit_object(module))


class MachineCode:
    """The function `run` of an object file, for any thread; a call releases the GIL.

    arguments : its types, of ctypes
    """

    def __init__(self, code: bytes, arguments: Sequence[Any]) -> None:
        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        self._engine.finalize_object()
        prototype = ctypes.CFUNCTYPE(None, *arguments)
        self._run = prototype(self._engine.get_function_address("run"))

    def __call__(self, *arguments: Any) -> None:
        self._run(*arguments)


class KernelCode:
    """The compiled program of a kernel."""

    def __init__(self, code: bytes) -> None:
        self._run = MachineCode(code, _RUN)

    def __call__(self, q: Array, qd: Array | None, qdd: Array | None, out: Array) -> None:
        """float64 arrays of shape (N, …), any strides; None for one the program does not read."""
        count, entries = out.shape
        scratch = _scratch((_STATE_ROWS * q.shape[1] + entries) * BLOCK)
        arrays: list[Any] = []
        for array in (q, qd, qdd, out):
            arrays += [None, 0, 0] if array is None else [array.ctypes.data, *array.strides]
        self._run(count, scratch.ctypes.data, *arrays)


def _machine() -> Any:
    """LLVM's target machine; a new one each time, since its user takes ownership."""
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
    memory = np.zeros(size + spare)
    first = -memory.ctypes.data % _ALIGNED // 8
    return memory[first : first + size]
