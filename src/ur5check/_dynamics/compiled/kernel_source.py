"""Generation of a kernel's code: derivation of the program, and its text for LLVM or NumPy.

Imported by the first call only; later processes read the code from disk (`kernel_cache`).
"""

from __future__ import annotations

from collections.abc import Sequence

from ..._robot.serial_arm import SerialArm
from ..symbolic.quantities import Quantity
from ..symbolic.trace import trace, trace_difference
from .numpy_source import numpy_source

__all__ = ["made"]


def made(arms: Sequence[SerialArm], quantity: Quantity, path: str) -> bytes:
    """A quantity of one arm, or the torque difference of two.

    Machine code for the path "llvm", the text of a Python module for "numpy".
    """
    program = trace_difference(*arms) if len(arms) == 2 else trace(arms[0], quantity)
    if path == "numpy":
        return numpy_source(program).encode()
    from .llvm_source import llvm_source
    from .machine_code import machine_code

    return machine_code(llvm_source(program))
