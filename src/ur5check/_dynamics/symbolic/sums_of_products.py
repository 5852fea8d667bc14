"""The graph as sums of products, the lines of a program.

A line is Σ k · (product of atoms); an atom is an input or another line.  A sum that is used once,
as a term of another, is merged into it, so that `factoring` finds the common factors of all its
terms.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from ..vectors import Scalar
from .expression_graph import Graph, Value
from .graph_nodes import ONE, Input, Node, Product, Sum

__all__ = ["Line", "Monomial", "added", "cost", "lines_of", "output_name", "term_cost"]

Monomial = tuple[Node, ...]  #: atoms, ascending; () is the number 1
Line = dict[Monomial, float]  #: Σ k · monomial; empty where the line is zero


def output_name(place: int) -> Node:
    """The name of the line of output number `place`: −1, −2, …"""
    return -1 - place


def term_cost(monomial: Monomial, k: float) -> int:
    """Multiplications of one term; a factor of ±1 is a sign, and signs are free."""
    factors = len(monomial) + (abs(k) != 1.0)
    return max(factors - 1, 0)


def cost(line: Line) -> int:
    """Operations of one line, × and +."""
    return sum(term_cost(*term) for term in line.items()) + max(len(line) - 1, 0)


def lines_of(graph: Graph, outputs: Sequence[Scalar]) -> dict[Node, Line]:
    """The lines that the outputs need, and one line per output, named `output_name(place)`.

    outputs : values of `graph`, or plain numbers
    """
    values = [v if isinstance(v, Value) else graph.constant(v) for v in outputs]
    needed = graph.reached([value.node for value in values])
    uses, as_term = _uses(graph, needed, values)
    lines: dict[Node, Line] = {}
    monomials: dict[Node, tuple[float, Monomial]] = {}

    def taken(node: Node, k: float) -> Line:
        """k times a node, as terms; a line with no other use is merged."""
        if node in lines and uses[node] == as_term[node] == 1:
            return {monomial: k * factor for monomial, factor in lines.pop(node).items()}
        factor, monomial = monomials[node]
        return {monomial: k * factor}

    for node in needed:
        made = graph.nodes[node]
        if isinstance(made, Product):
            (ka, a), (kb, b) = monomials[made.a], monomials[made.b]
            monomials[node] = ka * kb, tuple(sorted(a + b))
        elif isinstance(made, Sum):
            line = added(taken(made.a, made.ka), taken(made.b, made.kb))
            if len(line) > 1:
                lines[node], monomials[node] = line, (1.0, (node,))
            else:  # terms that cancelled in the merger
                ((monomial, k),) = line.items() or [((), 0.0)]
                monomials[node] = k, monomial
        else:
            monomials[node] = 1.0, () if node == ONE else (node,)
    for place, value in enumerate(values):
        lines[output_name(place)] = added(taken(value.node, value.factor), {})
    return lines


def added(left: Line, right: Line) -> Line:
    """The sum of two lines; terms that cancel are dropped."""
    line = dict(left)
    for monomial, k in right.items():
        line[monomial] = line.get(monomial, 0.0) + k
    return {monomial: k for monomial, k in line.items() if k != 0.0}


def _uses(
    graph: Graph, needed: Sequence[Node], outputs: Sequence[Value]
) -> tuple[Counter[Node], Counter[Node]]:
    """Number of uses of each node, and of these as a term of a sum or as an output."""
    uses = Counter(value.node for value in outputs)
    as_term = Counter(uses)
    for node in needed:
        made = graph.nodes[node]
        if not isinstance(made, Input):
            uses.update((made.a, made.b))
        if isinstance(made, Sum):
            as_term.update((made.a, made.b))
    return uses, as_term
