"""The quantities with a closed form, each computed by the recursion."""

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

__all__ = ["QUANTITIES", "Quantity", "Recipe", "RecipeInput", "symbolic_state"]

Quantity = Literal["tau", "M", "C", "g", "bias", "regressor"]


@dataclass(frozen=True, slots=True)
class RecipeInput:
    """The input of a recipe: an arm's chain, a symbolic state, and gravity g_0.

    Gravity is given either as `gravity`, applied at every link, or as `base_acceleration` −g_0.
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
    entries: Callable[[RecipeInput], list[Scalar]]


def symbolic_state(graph: Graph, n: int) -> JointState:
    """q, cos, sin, q̇, q̈ as inputs of a graph."""
    q, qd, qdd = (
        [graph.input(name) for name in state_names(kind, n)] for kind in ("q", "qd", "qdd")
    )
    names = zip(state_names("c", n), state_names("s", n), strict=True)
    cos, sin = zip(*(graph.angle(*pair) for pair in names), strict=True)
    return JointState(q, cos, sin, qd, qdd)


def _tau(given: RecipeInput) -> list[Scalar]:
    return joint_torques(given.chain, given.state, given.gravity, given.base_acceleration)


def _bias(given: RecipeInput) -> list[Scalar]:
    state = given.state.with_motion(given.state.qd, given.still)
    return joint_torques(given.chain, state, given.gravity, given.base_acceleration)


def _gravity(given: RecipeInput) -> list[Scalar]:
    return joint_torques(given.chain, given.state.resting(), given.gravity, given.base_acceleration)


def _mass(given: RecipeInput) -> list[Scalar]:
    """Entry (i, j) from column max(i, j), which has fewer moving links: M is symmetric."""
    columns = mass_columns(given.chain, given.state)
    places = range(len(columns))
    return [columns[max(i, j)][min(i, j)] for i in places for j in places]


def _coriolis(given: RecipeInput) -> list[Scalar]:
    """C_ij = ½ ∂h_i/∂q̇_j with h the velocity torque: for h_i = Σ c_ijk q̇_j q̇_k, Christoffel's C.

    The same matrix as `equations.coriolis_matrix`, which takes the quadratic form's differences.
    """
    state = given.state.with_motion(given.state.qd, given.still)
    h = joint_torques(given.chain, state, ZERO)
    columns = [derivatives(h, rate) for rate in state.qd]
    return [0.5 * entry for row in zip(*columns, strict=True) for entry in row]


def _regressor(given: RecipeInput) -> list[Scalar]:
    return regressor_rows(
        given.chain, outward(given.chain, given.state, given.gravity, given.base_acceleration)
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
