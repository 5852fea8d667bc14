"""A quantity of an arm as a program: the recursion, run once on symbols.

    program = trace(load("paper"), "tau")
    program.operations          # 192 × and 135 +, 327 in all
    program.evaluate(q, qd, qdd)

Three steps keep the program short: the scalars share equal values and fold constants
(`expression_graph`), unidentifiable parameters are set to zero (`parameter_regrouping`), and the
rest is factored (`factoring`).  Gravity enters as an acceleration of the base, which saves a vector
per link.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from ..._arguments import choice, integer
from ..._errors import UsageError
from ..._robot.as_arm import ArmSource, as_arm
from ..._robot.serial_arm import SerialArm
from ..chain_constants import Chain, chain_of
from ..vectors import ZERO, Scalar, Vector
from .expression_graph import Graph
from .factoring import factored
from .graph_nodes import Node
from .known_zeros import vanishing
from .parameter_regrouping import regroupings
from .program import Operations, Program
from .program_assembly import assemble
from .quantities import QUANTITIES, Quantity, Recipe, RecipeInput, symbolic_state
from .sums_of_products import Line, cost, lines_of
from .symbolic_arm import Symbols

__all__ = ["Parameters", "as_written", "trace", "trace_difference"]

Parameters = Literal["numeric", "symbolic"]

_TRIES, _SHORT = 100, 8  # so that a derivation takes a second
_FINALISTS = 3  # last results that are factored, with the first two, to choose the best


def trace(
    arm: ArmSource,
    quantity: Quantity = "tau",
    *,
    parameters: Parameters = "numeric",
    regroup: bool = True,
    tries: int | None = None,
) -> Program:
    """The closed form of one quantity: the recursion, run once on symbols.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    quantity : {"tau", "M", "C", "g", "bias", "regressor"}
        τ, M, C, g, C q̇ + g or Y.
    parameters : {"numeric", "symbolic"}
        The arm's numbers folded in, or as inputs.
    regroup : bool
        Whether unidentifiable parameters may be changed; the values stay the same to rounding.
        Not for symbols, nor for a regressor, which has no inertias.
    tries : int, optional
        Number of regroupings to try beyond the first, 5 ms each for a UR5; when None, 100 for
        arms of up to 8 joints, none for longer ones.

    Returns
    -------
    Program

    Raises
    ------
    InputError
        For an arm that cannot be read, an unknown quantity, or another invalid argument.

    References
    ----------
    Khalil & Kleinfinger 1987; Hosangadi, Fallah & Kastner 2006.

    Examples
    --------
    >>> import ur5check
    >>> program = ur5check.trace("paper", "g")
    >>> program.evaluate([0.0] * 6).shape
    (6,)
    """
    arm, recipe = as_arm(arm), _recipe(quantity)
    choice("parameters", parameters, ("numeric", "symbolic"))
    if parameters == "numeric" and quantity not in ("g", "regressor"):
        arm.require_tensors(recipe.text)
    tries = None if tries is None else integer("tries", tries, least=0)
    graph = Graph()
    symbols = Symbols(graph)
    if parameters == "symbolic":
        chain, gravity = symbols.chain(arm), symbols.gravity(arm)
    else:
        gravity = Vector.of(arm.gravity)
        regroup = regroup and quantity != "regressor"
        chain = _cheapest(arm, gravity, quantity, tries) if regroup else chain_of(arm)
    entries = _entries(graph, chain, gravity, quantity)

    def program(entries: Sequence[Scalar]) -> Program:
        return assemble(
            graph,
            entries,
            arm=arm.name,
            n=arm.n,
            quantity=quantity,
            unit=recipe.unit,
            shape=recipe.shape(arm.n),
            parameters=symbols.values,
        )

    first = program(entries)
    zero = vanishing(first)
    if not zero.any():
        return first
    return program([0.0 if gone else entry for gone, entry in zip(zero, entries, strict=True)])


def as_written(
    arm: SerialArm, quantity: Quantity = "tau", *, parameters: Parameters = "numeric"
) -> Operations:
    """Operations of the recursion as written, with gravity as a vector, equal values shared."""
    graph = Graph(simplify=False)
    symbols = Symbols(graph)
    numeric = parameters == "numeric"
    chain = chain_of(arm) if numeric else symbols.chain(arm)
    gravity = Vector.of(arm.gravity) if numeric else symbols.gravity(arm)
    given = RecipeInput(
        chain, symbolic_state(graph, arm.n), gravity=chain.base.T @ gravity, base_acceleration=ZERO
    )
    return graph.operations(_recipe(quantity).entries(given))


def trace_difference(a: SerialArm, b: SerialArm) -> Program:
    """τ_a − τ_b at the same q, q̇, q̈ as one program.

    The arms must have the same joint coordinates (`_comparison.arm_pair`).  Values that both need
    are computed once.  For arms that differ in their inertias alone, the difference is the torque
    of π_a − π_b, since torque is linear in π.

    Raises UsageError for arms of different length.
    """
    if a.n != b.n:
        raise UsageError(f"arm {a.name!r} has {a.n} joints and {b.name!r} has {b.n}")
    for arm in (a, b):
        arm.require_tensors("torques of a motion")
    graph = Graph()
    if _same_kinematics(a, b):
        gravity = Vector.of(a.gravity)
        entries = _entries(graph, _cheapest(a, gravity, "tau", less=b), gravity, "tau")
    else:
        both = (_entries(graph, chain_of(arm), Vector.of(arm.gravity), "tau") for arm in (a, b))
        entries = [x - y for x, y in zip(*both, strict=True)]
    return assemble(
        graph,
        entries,
        arm=f"{a.name} − {b.name}",
        n=a.n,
        quantity="difference",
        unit="N m",
        shape=(a.n,),
        parameters={},
    )


def _recipe(quantity: Quantity) -> Recipe:
    if quantity not in QUANTITIES:
        raise UsageError(f"no quantity {quantity!r}; choose one of {', '.join(QUANTITIES)}")
    return QUANTITIES[quantity]


def _entries(graph: Graph, chain: Chain, gravity: Vector, quantity: Quantity) -> list[Scalar]:
    base_acceleration = (chain.base.T @ gravity) * -1.0
    given = RecipeInput(
        chain,
        symbolic_state(graph, len(chain.links)),
        gravity=ZERO,
        base_acceleration=base_acceleration,
    )
    return QUANTITIES[quantity].entries(given)


def _same_kinematics(a: SerialArm, b: SerialArm) -> bool:
    """Whether two arms have the same geometry and gravity, to the bit."""
    return (
        np.array_equal(a.gravity, b.gravity)
        and np.array_equal(a.base.matrix(), b.base.matrix())
        and all(
            i.kind == j.kind and np.array_equal(i.axis, j.axis)
            for i, j in zip(a.joints, b.joints, strict=True)
        )
        and all(
            np.array_equal(i.link_tip_frame.matrix(), j.link_tip_frame.matrix())
            for i, j in zip(a.links, b.links, strict=True)
        )
    )


def _cheapest(
    arm: SerialArm,
    gravity: Vector,
    quantity: Quantity,
    tries: int | None = None,
    less: SerialArm | None = None,
) -> Chain:
    """The chain with the fewest operations.

    Factoring takes thirty times as long as tracing, so the search counts operations before it, and
    the last few results are factored.  For C it counts those of the velocity torques.
    """
    guide: Quantity = "bias" if quantity == "C" else quantity

    def lines(chain: Chain, quantity: Quantity) -> tuple[dict[Node, Line], Node]:
        graph = Graph(simplify=False)
        entries = _entries(graph, chain, gravity, quantity)
        return lines_of(graph, entries), len(graph.nodes)

    if tries is None:
        tries = _TRIES if arm.n <= _SHORT else 0
    found = regroupings(arm, lambda chain: _total(lines(chain, guide)[0]), tries=tries, less=less)
    finalists = [*found[:2], *found[2:][-_FINALISTS:]]
    if len(finalists) == 1:
        return finalists[0]
    return min(finalists, key=lambda chain: _total(factored(*lines(chain, quantity))))


def _total(lines: dict[Node, Line]) -> int:
    return sum(cost(line) for line in lines.values())
