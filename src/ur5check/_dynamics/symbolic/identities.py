"""Two identities that a sum is tried against as it is formed; each leaves one term of it.

    a − (a + b)                     =  −b      what was added is taken away again
    c (c a − s b) + s (s a + c b)   =   a      a vector turned into a frame and back: c² + s² = 1

The recursion does both.  Eq. (15) writes f_i × r_{i−1,ci} and f_{i+1} × r_{i,ci}, whose difference
is short; and what eq. (13) turns outward, eq. (14) may turn back unchanged.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Protocol

from .graph_nodes import Made, Node, Product, Sum

__all__ = ["Known", "simplified"]

Term = tuple[Node, float]


class Known(Protocol):
    """What is asked of a graph."""

    nodes: list[Made]
    #: the node of sin q for that of cos q, and the other way round
    sine_of: dict[Node, Node]


def simplified(graph: Known, one: Term, other: Term) -> Term | None:
    """The one term that the sum of two comes down to; None where neither identity fits."""
    return (
        _taken_away(graph.nodes, one, other)
        or _taken_away(graph.nodes, other, one)
        or _turned_back(graph, one, other)
        or _turned_back(graph, other, one)
    )


def _taken_away(nodes: Sequence[Made], one: Term, other: Term) -> Term | None:
    made, (node, k) = nodes[other[0]], one
    if isinstance(made, Sum):
        for (a, ka), (b, kb) in ((_left(made), _right(made)), (_right(made), _left(made))):
            if a == node and other[1] * ka == -k:
                return b, other[1] * kb
    return None


def _turned_back(graph: Known, one: Term, other: Term) -> Term | None:
    """`one` is c · (…) and `other` s · (…), or the other way round."""
    p, q = graph.nodes[one[0]], graph.nodes[other[0]]
    if not (isinstance(p, Product) and isinstance(q, Product)):
        return None
    c, s = p.a, graph.sine_of.get(p.a)
    if s is None or s not in (q.a, q.b):
        return None
    squares: dict[tuple[Node, ...], float] = {}
    for trig, inner, k in ((c, p.b, one[1]), (s, q.b if q.a == s else q.a, other[1])):
        for monomial, factor in _expanded(graph.nodes, inner):
            key = tuple(sorted((trig, *monomial)))
            squares[key] = squares.get(key, 0.0) + k * factor
    left = [(Counter(monomial), k) for monomial, k in squares.items() if k != 0.0]
    if len(left) != 2 or left[0][1] != left[1][1]:
        return None
    (u, k), (w, _) = left
    rest = list((u & w).elements())
    if len(rest) == 1 and {*(u - w).items(), *(w - u).items()} == {(c, 2), (s, 2)}:
        return rest[0], k
    return None


def _expanded(nodes: Sequence[Made], node: Node) -> list[tuple[tuple[Node, ...], float]]:
    """A sum as its two products, anything else as itself."""
    made = nodes[node]
    terms = [_left(made), _right(made)] if isinstance(made, Sum) else [(node, 1.0)]
    return [(_factors(nodes, part), k) for part, k in terms]


def _factors(nodes: Sequence[Made], node: Node) -> tuple[Node, ...]:
    made = nodes[node]
    return (made.a, made.b) if isinstance(made, Product) else (node,)


def _left(made: Sum) -> Term:
    return made.a, made.ka


def _right(made: Sum) -> Term:
    return made.b, made.kb
