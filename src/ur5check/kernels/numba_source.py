"""A program as a module for Numba: states in, blocks of 64 through a straight line, results out.

    gather   64 states are laid out in a scratch array, one row a joint's q, q̇ or q̈
    turn     angles become sines and cosines (`sincos`)
    line     the program itself, once a state of the block: no call, no branch, every row at a
             constant distance in one array, so that the compiler can take 4 or 8 states at a time.
             A long program is cut into several (`pieces`), since compiling one takes more than
             twice as long when it is twice as long
    scatter  its rows go to the result

The scratch array (36 rows for a UR5's torques, 18 kB) stays in the processor's first cache.  Only
contraction to fused multiply-add is allowed (`contract`): the reduction of angles needs every other
rounding where it stands.
"""

from __future__ import annotations

from ..closed_form.infix import description, right_hand_side
from ..closed_form.program import STATE, Program, read_input
from .pieces import LENGTH, Piece, pieces
from .sincos import FAR, turn_source

__all__ = ["BLOCK", "numba_source"]

BLOCK = 64  # states; 32 and 128 take 5 to 10 % longer

_QUIET = "nogil=True, cache=True, error_model='numpy'"


def numba_source(program: Program, length: int = LENGTH) -> str:
    """The module's text; its `run(*arrays, out)` takes float64 arrays of shape (N, n), any strides.

    arrays : those of `program.arguments`;  out : shape (N, entries of the result)
    length : of the program's pieces, in lines
    """
    lines, carried = _lines(program, pieces(program, length))
    text = [
        *(f"# {line}" for line in description(program)),
        "import math",
        "",
        "import numpy as np",
        "from numba import float64, njit, void",
        "from numba.types import Array",
        "",
        "GIVEN = Array(float64, 2, 'A', readonly=True)  # one that may be written is taken, too",
        f"ARGUMENTS = {program.arguments!r}",
        f"SHAPE = {program.shape!r}",
        f"BLOCK, JOINTS, ENTRIES = {BLOCK}, {program.n}, {len(program.outputs)}",
        f"CARRIED = {carried}  # rows from one piece of the program to the next",
        "",
        *_turn(),
        "",
        *lines,
        "",
        *_run(program),
    ]
    return "\n".join(text) + "\n"


def _row(kind: str, index: int, n: int) -> int:
    """Rows of the scratch array: q of every joint, cosines, sines, q̇, q̈, then the results."""
    return (*STATE, "out").index(kind) * n + index


def _place(kind: str, index: int, n: int) -> str:
    """State k of the block."""
    return f"w[k + {_row(kind, index, n) * BLOCK}]"


def _turn() -> list[str]:
    return [
        f"@njit('void(f8[::1])', fastmath={{'contract'}}, {_QUIET})",
        "def turn(w):",
        "    for k in range(JOINTS * BLOCK):",
        "        x = w[k]",
        *(f"        {line}" for line in turn_source()),
        "        w[k + JOINTS * BLOCK] = cosine",
        "        w[k + 2 * JOINTS * BLOCK] = sine",
        "",
    ]


def _lines(program: Program, parts: list[Piece]) -> tuple[list[str], int]:
    """One function a piece, and how many rows they need between them."""
    n, entries = program.n, len(program.outputs)
    place = {name: _place(*read_input(name), n) for name in program.inputs}
    place |= {line.name: _place("out", i, n) for i, line in enumerate(program.outputs)}
    carried = sorted({name for part in parts for name in part.given})
    place |= {name: _place("out", entries + i, n) for i, name in enumerate(carried)}
    text: list[str] = []
    for number, part in enumerate(parts):
        body = [f"{name} = {place[name]}" for name in (*part.inputs, *part.taken)]
        for line in part.lines:
            if not line.terms:
                continue  # its row is zero from the start
            kept = f"{place[line.name]} = " if line.name in place else ""
            body.append(f"{kept}{line.name} = {right_hand_side(line)}")
        text += [
            f"@njit('void(f8[::1])', fastmath={{'contract'}}, {_QUIET})",
            f"def line{number}(w):",
            "    for k in range(BLOCK):",
            *(f"        {statement}" for statement in body or ["pass"]),  # all may be zero
            "",
            "",
        ]
    calls = [f"    line{number}(w)" for number in range(len(parts))]
    return [*text, "@njit('void(f8[::1])', " + _QUIET + ")", "def line(w):", *calls, ""], len(
        carried
    )


def _run(program: Program) -> list[str]:
    n, arguments = program.n, (*program.arguments, "out")
    first = {kind: _row(kind, 0, n) * BLOCK for kind in (*program.arguments, "out")}
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
        "        turn(w)",
        "    else:",
        "        for k in range(JOINTS * BLOCK):",
        "            w[k + JOINTS * BLOCK] = math.cos(w[k])",
        "            w[k + 2 * JOINTS * BLOCK] = math.sin(w[k])",
        "    line(w)",
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
        f"@njit(void({kinds}), {_QUIET})",
        f"def run({', '.join(arguments)}):",
        *(f"    {text}" for text in body),
    ]
