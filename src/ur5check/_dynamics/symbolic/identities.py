"""Two identities that reduce a sum of two terms to one.

    a − (a + b)                     =  −b      cancellation
    c (c a − s b) + s (s a + c b)   =   a      a rotation and its inverse: c² + s² = 1

Both occur in the recursion: eq. (15) contains f_i × r_{i−1,ci} and f_{i+1} × r_{i,ci}, whose
difference is short, and eq. (14) may rotate back what eq. (13) rotated.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Protocol

from .graph_nodes import Made, Node, Product, Sum

__all__ = ["Known", "simplified"]

Term = tuple[Node, float]


class Known(Protocol):
    """The part of a graph that the identities read."""

    nodes: list[Made]
    #: the node of sin q for that of cos q, and the other way round
    sine_of: dict[Node, Node]


def simplified(graph: Known, one: Term, other: Term) -> Term | None:
    """The one term that the sum of two equals; None where neither identity applies."""
    return (
        _cancelled(graph.nodes, one, other)
        or _cancelled(graph.nodes, other, one)
        or _rotated_back(graph, one, other)
        or _rotated_back(graph, other, one)
    )


def _cancelled(nodes: Sequence[Made], one: Term, other: Term) -> Term | None:
    made, (node, k) = nodes[other[0]], one
    if isinstance(made, Sum):
        for (a, ka), (b, kb) in ((_left(made), _right(made)), (_right(made), _left(made))):
            if a == node and other[1] * ka == -k:
                return b, other[1] * kb
    return None


def _rotated_back(graph: Known, one: Term, other: Term) -> Term | None:
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
