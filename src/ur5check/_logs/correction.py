"""The corrected model: physically feasible, and nearest to the given one.

Torques determine combinations of parameters only.  So among all bodies that explain the recording
the nearest to the given ones are taken: each link's pseudo-inertia J stays positive definite, and
the log-det divergence from the given J0,

    D(J, J0) = tr(J0⁻¹ J) − log det(J0⁻¹ J) − 4,

is added to the sum of squares (Lee, Wensing & Park, IEEE T-RO 36(2), 2020).  It is a convex problem
with linear matrix inequalities (Sousa & Cortesão, IJRR 33(6), 2014).
"""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._errors import UsageError
from .._robot.inertia import Inertia, parameters_from_pseudo_inertia, pseudo_inertia
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .normal_equations import NormalEquations

__all__ = ["Change", "Correction", "corrected"]

#: A link whose pseudo-inertia changes by this part in one direction costs as much as one standard
#: deviation of the data: models are known to about ten per cent.
_KNOWN = 0.1

#: A body whose pseudo-inertia has a smaller eigenvalue, after scaling its diagonal to 1, is flat or
#: has no mass: it has no neighbours to choose from, and stays.
_FLAT = 1e-9

_PAIRS = tuple((row, column) for row in range(4) for column in range(row + 1))


@dataclass(frozen=True, eq=False)
class Change:
    """One link's correction, in the frame in which its source gives the numbers.

    before, after : mass [kg], centre (3) [m] and tensor Ixx Ixy Iyy Ixz Iyz Izz about it [kg m²]
    half_width : 95 % of `after`, with the given model as prior knowledge to ten per cent
    """

    link: str
    before: Array
    after: Array
    half_width: Array


@dataclass(frozen=True, eq=False)
class Correction:
    """The corrected arm.

    changes : of the links that were free;  fixed : names of links that could not be changed
    explained : the part of what free parameters explain
    """

    arm: SerialArm
    changes: tuple[Change, ...]
    fixed: tuple[str, ...]
    explained: float


def corrected(arm: SerialArm, normal: NormalEquations) -> Correction:
    """Solve for the nearest feasible model.

    Raises UsageError without cvxpy and Clarabel.
    """
    try:
        cvxpy: Any = importlib.import_module("cvxpy")
    except ImportError:
        raise UsageError("--repair needs cvxpy: pip install 'ur5check[logs]'") from None
    factors = {i: L for i in range(arm.n) if (L := _factor(arm.links[i].inertia)) is not None}
    if not factors:
        raise UsageError("no link of this model is a body with mass: there is nothing to correct")
    own = arm.parameters()
    A = np.zeros((10 * arm.n, 10 * len(factors)))
    for block, (i, L) in enumerate(factors.items()):
        A[10 * i : 10 * i + 10, 10 * block : 10 * block + 10] = _parameter_columns(L)
    H, y = _square_root(normal)
    Z = [cvxpy.Variable((4, 4), symmetric=True) for _ in factors]
    z = cvxpy.hstack([block[row, column] for block in Z for row, column in _PAIRS])
    one = np.tile([float(row == column) for row, column in _PAIRS], len(factors))
    weight = 1.0 / _KNOWN**2
    misfit = 0.5 * normal.independent * cvxpy.sum_squares(H @ A @ (z - one) - y)
    distance = sum(cvxpy.trace(block) - cvxpy.log_det(block) for block in Z)
    problem = cvxpy.Problem(cvxpy.Minimize(misfit + weight * distance))
    problem.solve(solver=cvxpy.CLARABEL)
    found = np.concatenate([[block.value[pair] for pair in _PAIRS] for block in Z])
    pi = own + A @ (found - one)
    inertias = [
        Inertia.from_parameters(pi[10 * i : 10 * i + 10]) if i in factors else link.inertia
        for i, link in enumerate(arm.links)
    ]
    repaired = arm.with_inertias(inertias)
    covariance = np.linalg.inv(normal.independent * A.T @ normal.G @ A + weight * _curvature(found))
    changes = []
    for block, (i, L) in enumerate(factors.items()):
        part = slice(10 * block, 10 * block + 10)
        J = _slopes(arm, i, L, found[part])
        spread = 1.96 * np.sqrt(np.einsum("ij,jk,ik->i", J, covariance[part, part], J))
        before, after = (_numbers(a, i, a.links[i].inertia) for a in (arm, repaired))
        changes.append(Change(arm.links[i].name, before, after, spread))
    rest = float(normal.rest(pi - own))
    explained = (normal.base - rest) / max(normal.base - normal.floor, 1e-300)
    fixed = tuple(link.name for i, link in enumerate(arm.links) if i not in factors)
    return Correction(repaired, tuple(changes), fixed, explained)


def _factor(inertia: Inertia) -> Array | None:
    """L with L Lᵀ the pseudo-inertia; None for a flat body."""
    J = pseudo_inertia(inertia.parameters())
    scale = np.sqrt(np.maximum(np.diag(J), 0.0))
    if not scale.all() or np.linalg.eigvalsh(J / np.outer(scale, scale))[0] < _FLAT:
        return None
    return np.asarray(np.linalg.cholesky(J))


def _unit(row: int, column: int) -> Array:
    unit = np.zeros((4, 4))
    unit[row, column] = unit[column, row] = 1.0
    return unit


def _parameter_columns(L: Array) -> Array:
    """Ten parameters of L Z Lᵀ are these times Z's lower triangle, shape (10, 10)."""
    return np.stack(
        [parameters_from_pseudo_inertia(L @ _unit(*pair) @ L.T) for pair in _PAIRS], axis=1
    )


def _square_root(normal: NormalEquations) -> tuple[Array, Array]:
    """H and y with |H x − y|² = xᵀ G x − 2 xᵀ g + const."""
    values, vectors = np.linalg.eigh(normal.G)
    kept = values > 1e-14 * values[-1]
    root = np.sqrt(values[kept])
    H = root[:, None] * vectors[:, kept].T
    return H, (vectors[:, kept].T @ normal.g) / root


def _curvature(z: Array) -> Array:
    """Second derivative of Σ D at Z: tr(Z⁻¹ dZ Z⁻¹ dZ), one block a link."""
    full = np.zeros((len(z), len(z)))
    units = [_unit(*pair) for pair in _PAIRS]
    for k in range(0, len(z), 10):
        Z = sum(value * unit for value, unit in zip(z[k : k + 10], units, strict=True))
        halves = [np.linalg.solve(Z, unit) for unit in units]
        full[k : k + 10, k : k + 10] = [[np.trace(a @ b) for a in halves] for b in halves]
    return full


def _numbers(arm: SerialArm, i: int, inertia: Inertia) -> Array:
    """Mass, centre and tensor in the source's frame, shape (10,)."""
    own = inertia.expressed_in(arm.links[i].source_frame.inverse())
    return np.array([own.mass, *own.com, *own.tensor[[0, 0, 1, 0, 1, 2], [0, 1, 1, 2, 2, 2]]])


def _slopes(arm: SerialArm, i: int, L: Array, z: Array) -> Array:
    """Derivative of `_numbers` by Z's lower triangle, by central differences, shape (10, 10)."""
    columns, step = _parameter_columns(L), 1e-5
    return np.stack(
        [
            (
                _numbers(arm, i, Inertia.from_parameters(columns @ (z + step * e)))
                - _numbers(arm, i, Inertia.from_parameters(columns @ (z - step * e)))
            )
            / (2.0 * step)
            for e in np.eye(10)
        ],
        axis=1,
    )
