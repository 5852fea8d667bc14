"""A long program in pieces of a length that compilers like."""

from __future__ import annotations

from dataclasses import dataclass

from ..closed_form.program import Assignment, Program

__all__ = ["LENGTH", "Piece", "pieces"]

LENGTH = 400  # lines; a UR5's torques have some 200


@dataclass(frozen=True)
class Piece:
    """Some lines of a program, in order.

    inputs : of the state, that these lines read
    taken : values of earlier pieces that they read;  given : values that later pieces read
    """

    lines: tuple[Assignment, ...]
    inputs: tuple[str, ...]
    taken: tuple[str, ...]
    given: tuple[str, ...]


def pieces(program: Program, length: int = LENGTH) -> list[Piece]:
    """The assignments and outputs of a program, at most `length` at a time; at least one piece.

    An output stands where its last factor is known, so that few values are carried on.
    """
    lines = _as_soon_as_known(program)
    parts = [lines[i : i + length] for i in range(0, max(len(lines), 1), length)]
    read = [
        {name for line in part for term in line.terms for name in term.factors} for part in parts
    ]
    made = [{line.name for line in part} for part in parts]
    found = []
    for i, part in enumerate(parts):
        before = set().union(*made[:i])
        later = set().union(*read[i + 1 :])
        found.append(
            Piece(
                tuple(part),
                tuple(name for name in program.inputs if name in read[i]),
                tuple(sorted(read[i] & before)),
                tuple(sorted(made[i] & later)),
            )
        )
    return found


def _as_soon_as_known(program: Program) -> list[Assignment]:
    place = {line.name: i for i, line in enumerate(program.assignments)}

    def known(line: Assignment) -> int:
        return max((place.get(f, -1) for term in line.terms for f in term.factors), default=-1)

    waiting: dict[int, list[Assignment]] = {}
    for line in program.outputs:
        waiting.setdefault(known(line), []).append(line)
    ordered = waiting.pop(-1, [])
    for i, line in enumerate(program.assignments):
        ordered += [line, *waiting.pop(i, [])]
    return ordered
