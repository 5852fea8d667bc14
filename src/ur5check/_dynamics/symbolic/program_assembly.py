"""Lines to a program: ordered, named, those of parameters separate from those of the state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..vectors import Scalar
from .expression_graph import Graph
from .factoring import factored
from .graph_nodes import Input, Node
from .program import Assignment, Program, Term
from .sums_of_products import Line, lines_of, output_name

__all__ = ["assemble"]


def assemble(
    graph: Graph,
    outputs: Sequence[Scalar],
    *,
    arm: str,
    n: int,
    quantity: str,
    unit: str,
    shape: tuple[int, ...],
    parameters: Mapping[str, float],
) -> Program:
    """The program that computes `outputs`, values of `graph`, factored."""
    lines = factored(lines_of(graph, outputs), len(graph.nodes))
    ends = [output_name(place) for place in range(len(outputs))]
    order = _in_order(lines, ends)
    inputs = {node: made.name for node, made in enumerate(graph.nodes) if isinstance(made, Input)}
    used = {atom for node in (*order, *ends) for atom in _atoms(lines[node])}

    known = {node for node, name in inputs.items() if name in parameters}
    early = []  # lines of parameters alone
    for node in order:
        if known.issuperset(_atoms(lines[node])):
            known.add(node)
            early.append(node)
    late = [node for node in order if node not in known]

    names = dict(inputs)
    names |= {node: f"p{i}" for i, node in enumerate(early, 1)}
    names |= {node: f"x{i}" for i, node in enumerate(late, 1)}
    names |= {node: f"{quantity}_{place}" for place, node in enumerate(ends)}

    def assignments(nodes: Sequence[Node]) -> tuple[Assignment, ...]:
        return tuple(_assignment(names, node, lines[node]) for node in nodes)

    return Program(
        arm=arm,
        n=n,
        quantity=quantity,
        unit=unit,
        shape=shape,
        inputs=tuple(
            name for node, name in inputs.items() if node in used and name not in parameters
        ),
        assignments=assignments(late),
        outputs=assignments(ends),
        setup=assignments(early),
        parameters={
            name: parameters[name]
            for node, name in inputs.items()
            if node in used and name in parameters
        },
    )


def _atoms(line: Line) -> set[Node]:
    return {atom for monomial in line for atom in monomial}


def _assignment(names: Mapping[Node, str], node: Node, line: Line) -> Assignment:
    """Positive terms first, so that few lines begin with a minus."""
    terms = [Term(k, tuple(names[atom] for atom in monomial)) for monomial, k in line.items()]
    return Assignment(names[node], tuple(sorted(terms, key=lambda term: term.k < 0.0)))


def _in_order(lines: Mapping[Node, Line], ends: Sequence[Node]) -> list[Node]:
    """The lines that the outputs need, what a line needs before it; without the outputs' own."""
    order: list[Node] = []
    done: set[Node] = set()
    waiting = [(end, False) for end in reversed(ends)]
    while waiting:
        node, operands_done = waiting.pop()
        if operands_done:
            order.append(node)
        elif node in lines and node not in done:
            done.add(node)
            waiting.append((node, True))
            waiting += ((atom, False) for atom in sorted(_atoms(lines[node]), reverse=True))
    return [node for node in order if node not in set(ends)]
