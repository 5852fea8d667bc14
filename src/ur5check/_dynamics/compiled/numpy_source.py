"""A program as a module for NumPy: blocks of states, one contiguous row per joint."""

from __future__ import annotations

from ..symbolic.infix_text import description, right_hand_side
from ..symbolic.program import Program, read_input

__all__ = ["BLOCK", "numpy_source"]

BLOCK = 4096  # states: a row of 32 kB, of which many fit into the second-level cache


def numpy_source(program: Program) -> str:
    """The module's text; its `run(q, qd, qdd, out)` takes float64 arrays, any strides.

    q, qd, qdd : shape (N, n), those of `program.arguments`; others are ignored
    out : shape (N, entries of the result)
    """
    body = [
        f"results = np.empty(({len(program.outputs)}, min({BLOCK}, len(q))))",
        f"for start in range(0, len(q), {BLOCK}):",
        f"    block = slice(start, start + {BLOCK})",
        "    here = results[:, : len(q) - start]",
        *(f"    rows_{name} = np.ascontiguousarray({name}[block].T)" for name in program.arguments),
        *(f"    {name} = {_read(name)}" for name in program.inputs),
        *(f"    {line.name} = {right_hand_side(line)}" for line in program.assignments),
        *(f"    here[{i}] = {right_hand_side(line)}" for i, line in enumerate(program.outputs)),
        "    out[block] = here.T",
    ]
    lines = [
        *(f"# {line}" for line in description(program)),
        "import numpy as np",
        "",
        "",
        '@np.errstate(over="ignore", invalid="ignore")  # machine code does not warn either',
        "def run(q, qd, qdd, out):",
        *(f"    {text}" for text in body),
    ]
    return "\n".join(lines) + "\n"


def _read(name: str) -> str:
    kind, joint = read_input(name)
    if kind in ("c", "s"):
        return f"np.{'cos' if kind == 'c' else 'sin'}(rows_q[{joint}])"
    return f"rows_{kind}[{joint}]"
