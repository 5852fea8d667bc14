"""Lines of a program as text, in the syntax common to Python and C."""

from __future__ import annotations

from collections.abc import Sequence

from ..._version import __version__
from .program import Assignment, Program, Term
from .quantities import QUANTITIES

__all__ = ["comments", "description", "right_hand_side"]


def comments(mark: str, program: Program, head: Sequence[str]) -> list[str]:
    """The head of a generated file: the caller's lines, then the description."""
    blank = [""] if head else []
    return [f"{mark} {line}".rstrip() for line in (*head, *blank, *description(program))]


def right_hand_side(line: Assignment) -> str:
    """`0.5*c2*x3 - x4`: constants with all their digits, so that reading them back is exact."""
    if not line.terms:
        return "0.0"
    first, *others = line.terms
    text = ("-" if first.k < 0.0 else "") + _unsigned(first)
    return text + "".join(f" {'-' if t.k < 0.0 else '+'} {_unsigned(t)}" for t in others)


def description(program: Program) -> list[str]:
    """What a program computes, for the head of a generated file."""
    recipe = QUANTITIES.get(program.quantity)  # type: ignore[call-overload]
    text = recipe.text if recipe else "difference of two arms' joint torques"
    size = "shape (" + ", ".join(map(str, program.shape)) + ("," * (len(program.shape) == 1)) + ")"
    lines = [
        f"{program.quantity} of arm {program.arm}: {text}, {size} [{program.unit}].",
        f"Derived by ur5check {__version__} from the recursion of Newton and Euler.",
        f"{program.operations}; signs are free, cosines and sines come on top.",
    ]
    if program.setup:
        lines.append(f"Once an arm: {program.setup_operations}.")
    return lines


def _unsigned(term: Term) -> str:
    size = abs(term.k)
    number = [] if size == 1.0 and term.factors else [repr(size)]
    return "*".join([*number, *term.factors])
