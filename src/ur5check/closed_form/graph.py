"""A scalar that writes down what is done to it.

The recursion of `dynamics` runs on whatever has + − ×.  Run on `Value`s, it leaves a graph behind:
every sum and product that it formed, each formed once (equal ones are the same node).  Nothing is
expanded, so a chain of 48 joints leaves 48 times what one joint leaves.

A `Value` is a number times a node.  Numbers therefore never become nodes: signs and constants
multiply out as they are met, and 0.5·(2·x) is x itself.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ..dynamics.vectors import Scalar

__all__ = ["ONE", "Graph", "Input", "Node", "Product", "Sum", "Value"]

Node = int  #: a place in `Graph.nodes`

ONE: Node = 0  #: the node whose value is 1


@dataclass(frozen=True, slots=True)
class Input:
    """A named number: `q1`, `c1`, a parameter."""

    name: str


@dataclass(frozen=True, slots=True)
class Product:
    """The product of two nodes."""

    a: Node
    b: Node


@dataclass(frozen=True, slots=True)
class Sum:
    """ka · a + kb · b, with a < b and ka > 0."""

    ka: float
    a: Node
    kb: float
    b: Node


@dataclass(slots=True)
class Graph:
    """All nodes, operands before what is made of them, none of them twice."""

    nodes: list[Input | Product | Sum] = field(default_factory=lambda: [Input("1")])
    _place: dict[Input | Product | Sum, Node] = field(default_factory=dict)

    def input(self, name: str) -> Value:
        """The input of this name."""
        return Value(self, 1.0, self.place(Input(name)))

    def place(self, node: Input | Product | Sum) -> Node:
        """Where this node stands; it is added when it is new."""
        found = self._place.get(node)
        if found is None:
            found = self._place[node] = len(self.nodes)
            self.nodes.append(node)
        return found

    def constant(self, number: float) -> Value:
        """A number as a value of this graph."""
        return Value(self, float(number), ONE)


@dataclass(frozen=True, slots=True, eq=False)
class Value:
    """`factor` times `node`: a scalar for `dynamics.vectors`.

    A result that is zero whatever the inputs are comes back as the constant 0.0, which `vectors`
    then drops.
    """

    graph: Graph
    factor: float
    node: Node

    def __neg__(self) -> Value:
        return Value(self.graph, -self.factor, self.node)

    def __mul__(self, other: Scalar) -> Scalar:
        if not isinstance(other, Value):
            factor = self.factor * float(other)
            return Value(self.graph, factor, self.node) if factor != 0.0 else 0.0
        factor = self.factor * other.factor
        if ONE in (self.node, other.node):
            return Value(self.graph, factor, max(self.node, other.node))
        a, b = sorted((self.node, other.node))
        return Value(self.graph, factor, self.graph.place(Product(a, b)))

    __rmul__ = __mul__

    def __add__(self, other: Scalar) -> Scalar:
        if not isinstance(other, Value):
            return self if float(other) == 0.0 else self + self.graph.constant(other)
        if self.node == other.node:
            factor = self.factor + other.factor
            return Value(self.graph, factor, self.node) if factor != 0.0 else 0.0
        first, last = sorted((self, other), key=lambda value: value.node)
        sign = 1.0 if first.factor > 0.0 else -1.0
        node = Sum(sign * first.factor, first.node, sign * last.factor, last.node)
        return Value(self.graph, sign, self.graph.place(node))

    __radd__ = __add__

    def __sub__(self, other: Scalar) -> Scalar:
        return self + (-other)

    def __rsub__(self, other: Scalar) -> Scalar:
        return (-self) + other
