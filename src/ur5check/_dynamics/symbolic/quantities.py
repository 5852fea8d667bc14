"""What can be had in closed form, and how each is asked of the one recursion."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from ..batching import JointState
from ..chain_constants import Chain
from ..equations import mass_columns
from ..recursion import joint_torques, outward
from ..regressor import regressor_rows
from ..vectors import ZERO, Scalar, Vector
from .derivative import derivatives
from .expression_graph import Graph
from .program import state_names

__all__ = ["QUANTITIES", "Asked", "Quantity", "Recipe", "symbolic_state"]

Quantity = Literal["tau", "M", "C", "g", "bias", "regressor"]


@dataclass(frozen=True, slots=True)
class Asked:
    """What a recipe works with: an arm's chain, a symbolic state, and gravity g_0.

    Gravity may come as `gravity`, which every link then hears of, or as `base_acceleration` −g_0 of
    the base.
    """

    chain: Chain
    state: JointState
    gravity: Vector
    base_acceleration: Vector

    @property
    def still(self) -> list[Scalar]:
        return [0.0] * len(self.chain.links)


@dataclass(frozen=True, slots=True)
class Recipe:
    """A quantity's name in words, its unit, its shape for n joints, and its entries, row by row."""

    text: str
    unit: str
    shape: Callable[[int], tuple[int, ...]]
    entries: Callable[[Asked], list[Scalar]]


def symbolic_state(graph: Graph, n: int) -> JointState:
    """q, cos, sin, q̇, q̈ as inputs of a graph."""
    q, qd, qdd = (
        [graph.input(name) for name in state_names(kind, n)] for kind in ("q", "qd", "qdd")
    )
    names = zip(state_names("c", n), state_names("s", n), strict=True)
    cos, sin = zip(*(graph.angle(*pair) for pair in names), strict=True)
    return JointState(q, cos, sin, qd, qdd)


def _tau(asked: Asked) -> list[Scalar]:
    return joint_torques(asked.chain, asked.state, asked.gravity, asked.base_acceleration)


def _bias(asked: Asked) -> list[Scalar]:
    state = asked.state.with_motion(asked.state.qd, asked.still)
    return joint_torques(asked.chain, state, asked.gravity, asked.base_acceleration)


def _gravity(asked: Asked) -> list[Scalar]:
    return joint_torques(asked.chain, asked.state.resting(), asked.gravity, asked.base_acceleration)


def _mass(asked: Asked) -> list[Scalar]:
    """Entry (i, j) from column max(i, j), which starts moving later: M is symmetric."""
    columns = mass_columns(asked.chain, asked.state)
    places = range(len(columns))
    return [columns[max(i, j)][min(i, j)] for i in places for j in places]


def _coriolis(asked: Asked) -> list[Scalar]:
    """C_ij = ½ ∂h_i/∂q̇_j with h the velocity torque: for h_i = Σ c_ijk q̇_j q̇_k, Christoffel's C.

    The same matrix as `equations.coriolis_matrix`, which takes the quadratic form's differences.
    """
    state = asked.state.with_motion(asked.state.qd, asked.still)
    h = joint_torques(asked.chain, state, ZERO)
    columns = [derivatives(h, rate) for rate in state.qd]
    return [0.5 * entry for row in zip(*columns, strict=True) for entry in row]


def _regressor(asked: Asked) -> list[Scalar]:
    return regressor_rows(
        asked.chain, outward(asked.chain, asked.state, asked.gravity, asked.base_acceleration)
    )


QUANTITIES: dict[Quantity, Recipe] = {
    "tau": Recipe("joint torques M q̈ + C q̇ + g", "N m", lambda n: (n,), _tau),
    "M": Recipe("mass matrix", "kg m²", lambda n: (n, n), _mass),
    "C": Recipe("Coriolis matrix, Christoffel's", "N m s", lambda n: (n, n), _coriolis),
    "g": Recipe("gravity torques", "N m", lambda n: (n,), _gravity),
    "bias": Recipe("torques without acceleration, C q̇ + g", "N m", lambda n: (n,), _bias),
    "regressor": Recipe(
        "torque regressor, less armature", "N m a unit", lambda n: (n, 10 * n), _regressor
    ),
}
