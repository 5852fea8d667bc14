"""A program as a module for Numba: states in, blocks of 64 through a straight line, results out.

    gather   64 states are laid out in a scratch array, one row a joint's q, q̇ or q̈
    turn     angles become sines and cosines (`sincos`)
    line     the program itself, once a state of the block: no call, no branch, every row at a
             constant distance in one array, so that the compiler can take 4 or 8 states at a time.
             A long program is cut into several (`pieces`), since compiling one takes more than
             twice as long when it is twice as long
    scatter  its rows go to the result

Turn and line go to the compiler as they stand (`straight_line`); Numba reads only the loops around
them.  The scratch array (36 rows for a UR5's torques, 18 kB) stays in the processor's first cache.
"""

from __future__ import annotations

from ..closed_form.infix import description, right_hand_side
from ..closed_form.program import STATE, Program, read_input
from .pieces import LENGTH, Piece, pieces
from .sincos import FAR, turn_source

__all__ = ["BLOCK", "numba_source"]

BLOCK = 64  # states; 32 and 128 take 5 to 10 % longer


def numba_source(program: Program, length: int = LENGTH) -> str:
    """The module's text; its `run(*arrays, out)` takes float64 arrays of shape (N, n), any strides.

    arrays : those of `program.arguments`;  out : shape (N, entries of the result)
    length : of the program's pieces, in lines
    """
    parts = pieces(program, length)
    carried = sorted({name for part in parts for name in part.given})
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
        f"CARRIED = {len(carried)}  # rows from one piece of the program to the next",
        "",
        *_straight("turn", _turn(program.n)),
        *_lines(program, parts, carried),
        *_run(program, len(parts)),
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


def _lines(program: Program, parts: list[Piece], carried: list[str]) -> list[str]:
    """One straight line a piece: `line0`, `line1`, …"""
    n, entries = program.n, len(program.outputs)
    place = {name: _place(*read_input(name), n) for name in program.inputs}
    place |= {line.name: _place("out", i, n) for i, line in enumerate(program.outputs)}
    place |= {name: _place("out", entries + i, n) for i, name in enumerate(carried)}
    text: list[str] = []
    for number, part in enumerate(parts):
        statements = [f"{name} = {place[name]}" for name in (*part.inputs, *part.taken)]
        for line in part.lines:
            if not line.terms:
                continue  # its row is zero from the start
            kept = f"{place[line.name]} = " if line.name in place else ""
            statements.append(f"{kept}{line.name} = {right_hand_side(line)}")
        text += _straight(f"line{number}", statements)
    return text


def _run(program: Program, parts: int) -> list[str]:
    n, arguments = program.n, (*program.arguments, "out")
    first = {kind: _row(kind, 0, n) * BLOCK for kind in (*program.arguments, "out")}
    lines = [
        text
        for number in range(parts)
        for text in ("    for k in range(BLOCK):", f"        line{number}(w, k)")
    ]
    body = [
        f"w = np.zeros({first['out']} + (ENTRIES + CARRIED) * BLOCK)",
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
        *lines,
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
