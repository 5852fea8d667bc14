"""A scalar that records its operations as a graph.

The recursion runs on any scalar with + − ×.  Run on `Value`s, it builds a graph of all its sums and
products, in which equal ones are the same node.  Nothing is expanded, so the graph grows linearly
with the number of joints.

A `Value` is a number times a node.  Numbers therefore are no nodes: signs and constants are
multiplied at once, and 0.5·(2·x) is x.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ..vectors import Scalar
from .graph_nodes import ONE, Input, Made, Node, Product, Sum
from .identities import simplified
from .program import Operations

__all__ = ["Graph", "Value"]

#: A smaller factor is zero.  No number of a robot is as small in any unit; products of such factors
#: would underflow below 1e-308, and `factoring` divides them by each other.
_ZERO_FACTOR = 1e-60


@dataclass(slots=True)
class Graph:
    """All nodes, operands before their results, without duplicates.

    simplify : whether `identities` are applied to sums
    """

    simplify: bool = True
    nodes: list[Made] = field(default_factory=lambda: [Input("1")])
    sine_of: dict[Node, Node] = field(default_factory=dict)
    _place: dict[Made, Node] = field(default_factory=dict)

    def input(self, name: str) -> Value:
        """The input of this name."""
        return Value(self, 1.0, self.place(Input(name)))

    def angle(self, cos: str, sin: str) -> tuple[Value, Value]:
        """Cosine and sine of one angle, as inputs of these names."""
        c, s = self.input(cos), self.input(sin)
        self.sine_of |= {c.node: s.node, s.node: c.node}
        return c, s

    def place(self, node: Made) -> Node:
        """The index of this node, which is added if it is new."""
        found = self._place.get(node)
        if found is None:
            found = self._place[node] = len(self.nodes)
            self.nodes.append(node)
        return found

    def reached(self, outputs: Sequence[Node]) -> list[Node]:
        """Every node that some output depends on, operands first."""
        found, waiting = set(), list(outputs)
        while waiting:
            node = waiting.pop()
            if node not in found:
                found.add(node)
                made = self.nodes[node]
                if not isinstance(made, Input):
                    waiting += (made.a, made.b)
        return sorted(found)

    def operations(self, outputs: Sequence[Scalar]) -> Operations:
        """× and + needed for the outputs, each node once."""
        needed = self.reached([value.node for value in outputs if isinstance(value, Value)])
        made = [self.nodes[node] for node in needed]
        sums = [node for node in made if isinstance(node, Sum)]
        scaled = sum((abs(node.ka) != 1.0) + (abs(node.kb) != 1.0) for node in sums)
        products = sum(isinstance(node, Product) for node in made)
        return Operations(products + scaled, len(sums))

    def constant(self, number: float) -> Value:
        """A number as a value of this graph."""
        return Value(self, float(number), ONE)


@dataclass(frozen=True, slots=True, eq=False)
class Value:
    """`factor` times `node`: a scalar for `_dynamics.vectors`.

    A result that is zero for all inputs is returned as the constant 0.0, which `vectors` omits.
    """

    graph: Graph
    factor: float
    node: Node

    def __neg__(self) -> Value:
        return Value(self.graph, -self.factor, self.node)

    def __mul__(self, other: Scalar) -> Scalar:
        if not isinstance(other, Value):
            return _value(self.graph, self.factor * float(other), self.node)
        factor = self.factor * other.factor
        if ONE in (self.node, other.node):
            return _value(self.graph, factor, max(self.node, other.node))
        a, b = sorted((self.node, other.node))
        return _value(self.graph, factor, self.graph.place(Product(a, b)))

    __rmul__ = __mul__

    def __add__(self, other: Scalar) -> Scalar:
        if not isinstance(other, Value):
            number = float(other)
            return self if abs(number) < _ZERO_FACTOR else self + self.graph.constant(number)
        if self.node == other.node:
            return _value(self.graph, self.factor + other.factor, self.node)
        graph = self.graph
        if graph.simplify:
            term = simplified(graph, (self.node, self.factor), (other.node, other.factor))
            if term is not None:
                return Value(graph, term[1], term[0])
        first, last = sorted((self, other), key=lambda value: value.node)
        sign = 1.0 if first.factor > 0.0 else -1.0
        node = Sum(sign * first.factor, first.node, sign * last.factor, last.node)
        return Value(graph, sign, graph.place(node))

    __radd__ = __add__

    def __sub__(self, other: Scalar) -> Scalar:
        return self + (-other)

    def __rsub__(self, other: Scalar) -> Scalar:
        return (-self) + other


def _value(graph: Graph, factor: float, node: Node) -> Scalar:
    return Value(graph, factor, node) if abs(factor) >= _ZERO_FACTOR else 0.0
