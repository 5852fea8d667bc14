"""A program as a module for Numba: states in, blocks of 64 through a straight line, results out.

    gather   64 states are laid out in a scratch array, one row a joint's q, q̇ or q̈
    turn     angles become sines and cosines (`sincos`)
    line     the program itself, once a state of the block: no call, no branch, every row at a
             constant distance in one array, so that the compiler can take 4 or 8 states at a time
    scatter  its rows go to the result

Turn and line go to the compiler as they stand (`straight_line`); Numba reads only the loops around
them.  The scratch array (36 rows for a UR5's torques, 18 kB) stays in the processor's first cache.
"""

from __future__ import annotations

from ..closed_form.infix import description, right_hand_side
from ..closed_form.program import STATE, Program, read_input
from .sincos import FAR, turn_source

__all__ = ["BLOCK", "numba_source"]

BLOCK = 64  # states; 32 and 128 take 5 to 10 % longer


def numba_source(program: Program) -> str:
    """The module's text; its `run(*arrays, out)` takes float64 arrays of shape (N, n), any strides.

    arrays : those of `program.arguments`;  out : shape (N, entries of the result)
    """
    text = [
        *(f"# {line}" for line in description(program)),
        "import math",
        "",
        "import numpy as np",
        "from numba import float64, njit, void",
        "from numba.types import Array",
        "from ur5check.kernels.straight_line import straight_line",
        "",
        "GIVEN = Array(float64, 2, 'A', readonly=True)  # one that may be written is taken, too",
        f"ARGUMENTS = {program.arguments!r}",
        f"SHAPE = {program.shape!r}",
        f"BLOCK, JOINTS, ENTRIES = {BLOCK}, {program.n}, {len(program.outputs)}",
        "",
        *_straight("turn", _turn(program.n)),
        *_straight("line", _line(program)),
        *_run(program),
    ]
    return "\n".join(text) + "\n"


def _row(kind: str, index: int, n: int) -> int:
    """Rows of the scratch array: q of every joint, cosines, sines, q̇, q̈, then the results."""
    return (*STATE, "out").index(kind) * n + index


def _place(kind: str, index: int, n: int) -> str:
    """State k of the block."""
    return f"w[k + {_row(kind, index, n) * BLOCK}]"


def _straight(name: str, statements: list[str]) -> list[str]:
    return [f'{name} = straight_line("""', *statements, '""")', ""]


def _turn(n: int) -> list[str]:
    cosine, sine = (_place(kind, 0, n) for kind in ("c", "s"))
    return ["x = w[k]", *turn_source(), f"{cosine} = cosine", f"{sine} = sine"]


def _line(program: Program) -> list[str]:
    n = program.n
    return [
        *(f"{name} = {_place(*read_input(name), n)}" for name in program.inputs),
        *(f"{line.name} = {right_hand_side(line)}" for line in program.assignments),
        *(
            f"{_place('out', i, n)} = {right_hand_side(line)}"
            for i, line in enumerate(program.outputs)
            if line.terms  # else its row is zero from the start
        ),
    ]


def _run(program: Program) -> list[str]:
    n, arguments = program.n, (*program.arguments, "out")
    first = {kind: _row(kind, 0, n) * BLOCK for kind in (*program.arguments, "out")}
    body = [
        f"w = np.zeros({first['out']} + ENTRIES * BLOCK)",
        "for start in range(0, q.shape[0], BLOCK):",
        "    count = min(BLOCK, q.shape[0] - start)",
        "    far = 0.0",
        "    for j in range(JOINTS):",
        "        for k in range(count):",
        *(f"            w[{first[a]} + j * BLOCK + k] = {a}[start + k, j]" for a in arguments[:-1]),
        "    for k in range(JOINTS * BLOCK):",
        "        far = max(far, abs(w[k]))",
        f"    if far <= {FAR!r}:",
        "        for k in range(JOINTS * BLOCK):",
        "            turn(w, k)",
        "    else:",
        "        for k in range(JOINTS * BLOCK):",
        "            w[k + JOINTS * BLOCK] = math.cos(w[k])",
        "            w[k + 2 * JOINTS * BLOCK] = math.sin(w[k])",
        "    for k in range(BLOCK):",
        "        line(w, k)",
        "    if out.strides[0] >= out.strides[1]:  # a state's entries lie together",
        "        for k in range(count):",
        "            for i in range(ENTRIES):",
        f"                out[start + k, i] = w[{first['out']} + i * BLOCK + k]",
        "    else:",
        "        for i in range(ENTRIES):",
        "            for k in range(count):",
        f"                out[start + k, i] = w[{first['out']} + i * BLOCK + k]",
    ]
    kinds = ", ".join(["GIVEN"] * (len(arguments) - 1) + ["float64[:, :]"])
    return [
        f"@njit(void({kinds}), nogil=True, cache=True, error_model='numpy')",
        f"def run({', '.join(arguments)}):",
        *(f"    {text}" for text in body),
    ]
