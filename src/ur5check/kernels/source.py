"""What a kernel is made from: a program traced, and written for what is to run it.

Only a first call comes here.  Later processes find the text on disk (`cache`), and need not wait
for what traces and writes it to be imported.
"""

from __future__ import annotations

from collections.abc import Callable

from ..arm.serial_arm import SerialArm
from ..closed_form.program import Program
from ..closed_form.quantities import Quantity
from ..closed_form.trace import trace, trace_difference
from .numba_source import numba_source
from .numpy_source import numpy_source

__all__ = ["difference_source", "source"]

_WRITERS: dict[str, Callable[[Program], str]] = {"numba": numba_source, "numpy": numpy_source}


def source(arm: SerialArm, quantity: Quantity, path: str) -> str:
    """The module's text, of one quantity of an arm."""
    return _WRITERS[path](trace(arm, quantity))


def difference_source(a: SerialArm, b: SerialArm, path: str) -> str:
    """The module's text, of τ_a − τ_b."""
    return _WRITERS[path](trace_difference(a, b))
