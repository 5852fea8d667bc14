"""A program as C99, which needs only cos and sin of the standard library."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from .infix_text import comments, right_hand_side
from .program import Program, read_input

__all__ = ["to_c"]


def to_c(program: Program, *, head: Sequence[str] = ()) -> str:
    """One function, `void tau(const double q[6], …, double result[6])`; it allocates nothing.

    The result is stored row by row.  Parameters left as symbols come in a struct, `tau_parameters`,
    whose values for the arm itself are `tau_defaults`.

    head : lines for the top of the file, such as its provenance, written as comments
    """
    name = program.quantity
    takes = [f"const double {argument}[{program.n}]" for argument in program.arguments]
    if program.parameters:
        takes.append(f"const struct {name}_parameters *parameters")
    takes.append(f"double result[{prod(program.shape)}]")
    read = {
        **{name: _read(name) for name in program.inputs},
        **{name: f"parameters->{name}" for name in program.parameters},
    }
    lines = (*program.setup, *program.assignments)
    body = [
        *(f"const double {local} = {value};" for local, value in read.items()),
        *(f"const double {line.name} = {right_hand_side(line)};" for line in lines),
        *(f"result[{i}] = {right_hand_side(line)};" for i, line in enumerate(program.outputs)),
    ]
    text = [
        *comments("//", program, head),
        "#include <math.h>",
        "",
        *_struct(program),
        f"void {name}({', '.join(takes)})",
        "{",
        *(f"    {line}" for line in body),
        "}",
    ]
    return "\n".join(text) + "\n"


def _struct(program: Program) -> list[str]:
    if not program.parameters:
        return []
    name = program.quantity
    return [
        f"struct {name}_parameters {{",
        *(f"    double {parameter};" for parameter in program.parameters),
        "};",
        "",
        f"const struct {name}_parameters {name}_defaults = {{",
        *(f"    .{parameter} = {value!r}," for parameter, value in program.parameters.items()),
        "};",
        "",
    ]


def _read(name: str) -> str:
    """An input from the joint arrays: `c2` is cos(q[1])."""
    kind, joint = read_input(name)
    return {"c": "cos(q[{}])", "s": "sin(q[{}])"}.get(kind, kind + "[{}]").format(joint)
