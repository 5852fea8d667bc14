"""A program for SymPy, as source text and as expressions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..._arguments import instance
from .infix_text import comments, right_hand_side
from .program import Assignment, Program, read_input, state_names

__all__ = ["expressions", "to_sympy"]


def to_sympy(program: Program, *, head: Sequence[str] = ()) -> str:
    """A module that builds the closed form: `replacements` and a Matrix named after the quantity.

    They have the form of the result of SymPy's `cse`: each replacement is (symbol, expression),
    written in joint symbols q1, qd1, qdd1 and in symbols defined before it.

    head : lines for the top of the file, such as its provenance, written as comments
    """
    lines = [line.name for line in (*program.setup, *program.assignments)]
    rows, columns = (*program.shape, 1)[:2]
    text = [
        *comments("#", program, head),
        "import sympy",
        "",
        *(
            f"{''.join(f'{name}, ' for name in state_names(kind, program.n))}"
            f'= sympy.symbols("{kind}1:{program.n + 1}")'
            for kind in program.arguments
        ),
        *(f'{name} = sympy.Symbol("{name}")' for name in (*program.parameters, *lines)),
        *(f"{name} = {_read(name)}" for name in program.inputs if _read(name) != name),
        "replacements = [",
        *(f"    ({line.name}, {_exact(line)})," for line in (*program.setup, *program.assignments)),
        "]",
        f"{program.quantity} = sympy.Matrix({rows}, {columns}, [",
        *(f"    {_exact(line)}," for line in program.outputs),
        "])",
    ]
    return "\n".join(text) + "\n"


def expressions(program: Program) -> Any:
    """The expanded closed form as a SymPy matrix in q1, qd1, qdd1 and parameters alone.

    For M and g.  The expanded torques of a UR5 are too long: `ur5check derive --to sympy` writes
    them with replacements.

    Parameters
    ----------
    program : Program
        See `trace`.

    Returns
    -------
    sympy.Matrix

    Raises
    ------
    UsageError
        For another type of program.

    Examples
    --------
    >>> import ur5check
    >>> g = ur5check.sympy_matrix(ur5check.trace("paper", "g"))
    >>> g.shape, g[0]
    ((6, 1), 0)
    """
    instance("program", program, Program, "see ur5check.trace")
    module: dict[str, Any] = {}
    exec(to_sympy(program), module)  # noqa: S102 - the text of `to_sympy`
    known: dict[Any, Any] = {}
    for symbol, value in module["replacements"]:
        known[symbol] = value.xreplace(known)
    return module[program.quantity].xreplace(known)


def _exact(line: Assignment) -> str:
    """Zero as an Integer: a Float zero would not be `sympy.S.Zero`."""
    return right_hand_side(line) if line.terms else "0"


def _read(name: str) -> str:
    kind, joint = read_input(name)
    return {"c": "sympy.cos(q{})", "s": "sympy.sin(q{})"}.get(kind, kind + "{}").format(joint + 1)
