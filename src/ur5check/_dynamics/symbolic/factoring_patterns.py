"""The patterns of `factoring`: finding them in a line, and replacing them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

from .graph_nodes import Node
from .sums_of_products import Line, Monomial

__all__ = [
    "FactorPair",
    "Pattern",
    "Place",
    "Scaled",
    "TermPair",
    "line_of",
    "patterns_in",
    "placed",
]

_DIGITS = 14  # constants equal to so many digits differ by rounding only


class TermPair(NamedTuple):
    """x + ρ y, with x before y; ρ to 14 digits."""

    x: Monomial
    y: Monomial
    ratio: float


class FactorPair(NamedTuple):
    """x y."""

    x: Node
    y: Node


@dataclass(frozen=True, slots=True)
class Scaled:
    """k x, with k > 0.  Not a tuple: (3.0, 3) would equal the pair of factors (3, 3)."""

    k: float
    x: Node


Pattern = TermPair | FactorPair | Scaled
Place = tuple[Monomial, ...]  #: the term, or the two terms, of a line that a pattern covers


def patterns_in(line: Line) -> Iterator[tuple[Pattern, Place]]:
    """Every pattern of a line, and its place."""
    for term, k in line.items():
        if len(term) > 1:
            for factors in dict.fromkeys(combinations(term, 2)):
                yield FactorPair(*factors), (term,)
        if abs(k) != 1.0:
            for atom in dict.fromkeys(term):
                yield Scaled(abs(k), atom), (term,)
    for (s, ks), (t, kt) in combinations(line.items(), 2):
        common = _common(s, t)
        x, y = _without(s, common), _without(t, common)
        if x < y:
            yield TermPair(x, y, _rounded(kt / ks)), (s, t)
        else:
            yield TermPair(y, x, _rounded(ks / kt)), (t, s)


def line_of(pattern: Pattern, places: Sequence[tuple[Line, Place]]) -> list[Line]:
    """The pattern as a line: for a pair of terms one for each scale that may be the best."""
    if isinstance(pattern, FactorPair):
        return [{tuple(pattern): 1.0}]
    if isinstance(pattern, Scaled):
        return [{(pattern.x,): pattern.k}]
    x, y = pattern.x, pattern.y
    kx, ky = (places[0][0][term] for term in places[0][1])
    lines = [{x: 1.0, y: ky / kx}, {x: kx / ky, y: 1.0}]
    for line, (s, t) in places:
        lines.append({x: abs(line[s]), y: line[t] if line[s] > 0.0 else -line[t]})
    return lines


def placed(
    pattern: Pattern, made: Line, line: Line, place: Place, name: Node
) -> tuple[Monomial, float]:
    """The term that replaces `place` in `line` once the pattern is the line `made`."""
    taken = (
        pattern.x
        if isinstance(pattern, TermPair)
        else tuple(pattern)
        if isinstance(pattern, FactorPair)
        else (pattern.x,)
    )
    k = line[place[0]] / made[taken]
    if _rounded(abs(k)) == 1.0:
        k = 1.0 if k > 0.0 else -1.0
    return tuple(sorted((*_without(place[0], taken), name))), k


def _common(s: Monomial, t: Monomial) -> Monomial:
    common, rest = [], list(t)
    for atom in s:
        if atom in rest:
            rest.remove(atom)
            common.append(atom)
    return tuple(common)


def _without(monomial: Monomial, taken: Monomial) -> Monomial:
    rest = list(monomial)
    for atom in taken:
        rest.remove(atom)
    return tuple(rest)


def _rounded(number: float) -> float:
    return float(f"{number:.{_DIGITS}g}")
