"""A program as LaTeX: one line per assignment, in an align* of amsmath."""

from __future__ import annotations

import re
from collections.abc import Sequence

from .infix_text import comments
from .program import Assignment, Program, Term

__all__ = ["to_latex"]

_STATE = {"q": "q", "c": "c", "s": "s", "qd": r"\dot{q}", "qdd": r"\ddot{q}"}
_SYMBOLS = {"tau": r"\tau", "g": "g", "bias": "h", "difference": r"\Delta\tau", "regressor": "Y"}
_SCIENTIFIC = re.compile(r"(.*)e([-+]\d+)")


def to_latex(program: Program, *, head: Sequence[str] = (), digits: int = 6) -> str:
    """For reading: c_i and s_i are the cosine and sine of q_i, x_i and p_i are shared values.

    digits : of the constants; the other printers write all
    head : lines for the top of the file, such as its provenance, written as comments
    """
    lines = [*program.setup, *program.assignments]
    rows = [f"{_name(line.name)} &= {_sum(line, digits)}" for line in lines]
    rows += [
        f"{_output(program, place)} &= {_sum(line, digits)}"
        for place, line in enumerate(program.outputs)
    ]
    text = [
        *comments("%", program, head),
        f"% Constants to {digits} digits.  Needs amsmath; long forms \\allowdisplaybreaks.",
        r"\begin{align*}",
        *(f"{row} \\\\" for row in rows[:-1]),
        rows[-1],
        r"\end{align*}",
    ]
    return "\n".join(text) + "\n"


def _output(program: Program, place: int) -> str:
    """τ_3, or M_{2,3}."""
    symbol = _SYMBOLS.get(program.quantity, program.quantity)
    indices: list[int] = []
    for size in reversed(program.shape):
        place, index = divmod(place, size)
        indices.insert(0, index + 1)
    return f"{symbol}_{{{','.join(map(str, indices))}}}"


def _sum(line: Assignment, digits: int) -> str:
    if not line.terms:
        return "0"
    first, *others = line.terms
    text = ("-" if first.k < 0.0 else "") + _unsigned(first, digits)
    return text + "".join(f" {'-' if t.k < 0.0 else '+'} {_unsigned(t, digits)}" for t in others)


def _unsigned(term: Term, digits: int) -> str:
    factors = [_name(name) for name in term.factors]
    if abs(term.k) != 1.0 or not factors:
        factors.insert(0, _number(abs(term.k), digits))
    return r"\,".join(factors)


def _number(value: float, digits: int) -> str:
    text = f"{value:.{digits}g}"
    scientific = _SCIENTIFIC.fullmatch(text)
    if scientific is None:
        return text
    return rf"{scientific[1]} \cdot 10^{{{int(scientific[2])}}}"


def _name(name: str) -> str:
    r"""`qd2` as \dot{q}_{2}, `Ixx3` as I_{xx,3}, `x12` as x_{12}."""
    letters = name.rstrip("0123456789")
    number = name.removeprefix(letters)
    if letters in _STATE:
        return f"{_STATE[letters]}_{{{number}}}"
    symbol, *axes = re.fullmatch(r"([A-Za-z])([xyz]*)", letters).groups()  # type: ignore[union-attr]
    return f"{symbol}_{{{','.join(part for part in (*axes, number) if part)}}}"
