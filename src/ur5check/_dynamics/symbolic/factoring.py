"""Greedy reduction of operations: factoring, grouping and sharing.

Three rewrites, each of which defines a new line and uses it wherever it occurs:

    a pair of terms     k g x + ρ k g y  =  k g · p,   p = x + ρ y     in one line or in many
    a pair of factors   x y …            =  p …,       p = x y
    a scaled factor     k x …            =  p …,       p = k x

A pair of terms covers three cases: a shared sub-sum (g empty, several lines), a
factored product (c x + c y = c (x + y)), and a grouped constant.  The rewrite that saves most
operations is applied first, until none saves any: the greedy algorithm of Hosangadi, Fallah &
Kastner, "Optimizing polynomial expressions by algebraic factorization and common subexpression
elimination", IEEE TCAD 25(10), 2006, with constants.  Only lines that a rewrite changed are indexed
again, so that the work is linear in the length of the program.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Iterable, Iterator
from functools import reduce
from typing import NamedTuple

from .factoring_patterns import Pattern, Place, TermPair, line_of, patterns_in, placed
from .graph_nodes import Node
from .sums_of_products import Line, Monomial, added, cost, term_cost

__all__ = ["factored"]


class Rewrite(NamedTuple):
    """A pattern as a line, the operations it saves, and the places it replaces."""

    saving: int
    line: Line
    places: list[tuple[Node, Place]]


def factored(lines: dict[Node, Line], fresh: Node) -> dict[Node, Line]:
    """The same lines with fewer operations, and new ones named `fresh`, `fresh + 1`, …."""
    rewriter = _Rewriter(lines, fresh)
    rewriter.run()
    return _without_aliases(rewriter.lines)


def _without_aliases(lines: dict[Node, Line]) -> dict[Node, Line]:
    """Replace lines that are ± another line by that line; outputs are kept."""
    alias: dict[Node, tuple[Node, float]] = {}
    for name, line in lines.items():
        if name >= 0 and len(line) == 1:
            ((monomial, k),) = line.items()
            if len(monomial) == 1 and abs(k) == 1.0:
                alias[name] = monomial[0], k

    def renamed(monomial: Monomial, k: float) -> tuple[Monomial, float]:
        atoms = []
        for atom in monomial:
            while atom in alias:
                atom, sign = alias[atom]
                k *= sign
            atoms.append(atom)
        return tuple(sorted(atoms)), k

    kept: dict[Node, Line] = {}
    for name, line in lines.items():
        if name not in alias:
            terms = ({monomial: k} for monomial, k in (renamed(*term) for term in line.items()))
            kept[name] = reduce(added, terms, {})
    return kept


class _Rewriter:
    """The lines, and an index of every pattern in them."""

    def __init__(self, lines: dict[Node, Line], fresh: Node) -> None:
        self.lines = {name: dict(line) for name, line in lines.items()}
        self.fresh = fresh
        self.where: defaultdict[Pattern, dict[Node, list[Place]]] = defaultdict(dict)
        self.patterns: dict[Node, list[Pattern]] = {}
        self.queue: list[tuple[int, bool, int, Pattern]] = []
        self.pushed = 0

    def run(self) -> None:
        self.index(self.lines)
        while self.queue:
            promised, *_, pattern = heapq.heappop(self.queue)
            rewrite = self.best(pattern)
            if rewrite.saving == -promised:
                self.apply(pattern, rewrite)
            else:  # its lines have changed
                self.push(pattern, rewrite.saving)

    def push(self, pattern: Pattern, saving: int) -> None:
        """Of equal savings, pairs of terms first (better in the end), then earlier ones."""
        if saving > 0:
            self.pushed += 1
            order = (-saving, not isinstance(pattern, TermPair), self.pushed)
            heapq.heappush(self.queue, (*order, pattern))

    def index(self, names: Iterable[Node]) -> None:
        """Index these lines again."""
        touched: dict[Pattern, None] = {}
        for name in names:
            for pattern in self.patterns.get(name, ()):
                del self.where[pattern][name]
            found: defaultdict[Pattern, list[Place]] = defaultdict(list)
            for pattern, place in patterns_in(self.lines[name]):
                found[pattern].append(place)
            for pattern, places in found.items():
                self.where[pattern][name] = places
            self.patterns[name] = list(found)
            touched |= dict.fromkeys(found)
        for pattern in touched:
            self.push(pattern, self.best(pattern).saving)

    def best(self, pattern: Pattern) -> Rewrite:
        """The rewrite of a pattern, in the form that saves most."""
        places = list(self.disjoint(pattern))
        if len(places) < (1 if isinstance(pattern, TermPair) else 2):
            return Rewrite(0, {}, [])  # a product or a multiple that occurs once saves nothing
        before = sum(
            sum(term_cost(term, self.lines[name][term]) for term in place) + len(place) - 1
            for name, place in places
        )
        rewrites = []
        for line in line_of(pattern, [(self.lines[name], place) for name, place in places]):
            after = cost(line)
            for name, place in places:
                after += term_cost(*placed(pattern, line, self.lines[name], place, self.fresh))
            rewrites.append(Rewrite(before - after, line, places))
        return max(rewrites, key=lambda rewrite: rewrite.saving)

    def disjoint(self, pattern: Pattern) -> Iterator[tuple[Node, Place]]:
        """The pattern's places, no term used twice."""
        for name, places in self.where[pattern].items():
            used: set[Monomial] = set()
            for place in places:
                if used.isdisjoint(place):
                    used.update(place)
                    yield name, place

    def apply(self, pattern: Pattern, rewrite: Rewrite) -> None:
        new, self.fresh = self.fresh, self.fresh + 1
        self.lines[new] = rewrite.line
        for name, place in rewrite.places:
            line = self.lines[name]
            monomial, k = placed(pattern, rewrite.line, line, place, new)
            for term in place:
                del line[term]
            line[monomial] = k
        self.index([new, *dict.fromkeys(name for name, _ in rewrite.places)])
