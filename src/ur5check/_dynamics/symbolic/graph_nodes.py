"""The nodes of a graph: inputs, products of two nodes, weighted sums of two nodes."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["ONE", "Input", "Made", "Node", "Product", "Sum"]

Node = int  #: an index of `Graph.nodes`

ONE: Node = 0  #: the node with the value 1


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


Made = Input | Product | Sum
