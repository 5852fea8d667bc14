"""Derivatives on the graph: sums term by term, products by Leibniz."""

from __future__ import annotations

from collections.abc import Sequence

from ..vectors import Scalar, plus, times
from .expression_graph import Graph, Value
from .graph_nodes import Input, Node, Product

__all__ = ["derivatives"]


def derivatives(values: Sequence[Scalar], wrt: Value) -> list[Scalar]:
    """∂ value / ∂ wrt of each value, wrt an input; 0.0 for a value that does not depend on it."""
    graph = wrt.graph
    known: dict[Node, Scalar] = {}
    # Operands come before their results, so one pass in order suffices.
    for node in range(max((v.node for v in values if isinstance(v, Value)), default=0) + 1):
        known[node] = _derivative(graph, node, wrt.node, known)
    return [times(known[v.node], v.factor) if isinstance(v, Value) else 0.0 for v in values]


def _derivative(graph: Graph, node: Node, wrt: Node, known: dict[Node, Scalar]) -> Scalar:
    made = graph.nodes[node]
    if isinstance(made, Input):
        return 1.0 if node == wrt else 0.0
    a, b = Value(graph, 1.0, made.a), Value(graph, 1.0, made.b)
    if isinstance(made, Product):
        return plus(times(known[made.a], b), times(a, known[made.b]))
    return plus(times(known[made.a], made.ka), times(known[made.b], made.kb))
