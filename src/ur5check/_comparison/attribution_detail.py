"""A torque difference split finer: parameter by parameter, and term by term."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from .._dynamics.regressor import torque_regressor
from .._robot.inertia import parameter_map
from .._robot.states import States
from .._robot.transforms import Array
from .arm_pair import Pair, Side, check_pair
from .attribution import PARAMETER_CONTRIBUTIONS, Attribution, Contribution, attribute
from .shapley import weight

__all__ = ["TermAttribution", "by_parameter", "by_term"]


@dataclass(frozen=True, eq=False)
class TermAttribution:
    """One attribution for each term of τ = M q̈ + C q̇ + g; their `delta` sum to Δτ.

    Attributes
    ----------
    gravity : Attribution
        Of g(q).
    coriolis : Attribution
        Of C(q, q̇) q̇, the Coriolis and centrifugal torque.
    inertial : Attribution
        Of M(q) q̈.
    """

    gravity: Attribution
    coriolis: Attribution
    inertial: Attribution


def by_parameter(pair: Pair, states: States) -> Attribution:
    """Split Δτ among geometry, gravity, motors and each of the 10 n inertial parameters.

    Contributions of kind "m", "mx", … "Izz" hold Ȳ_k (π_a − π_b)_k, with Ȳ averaged over both
    sides' geometry and gravity as in `attribute`.  Parameters are held in a's link frames, and
    their parts depend on them: a centre of mass that is off shows in mx and in the tensor about the
    origin.

    Parameters
    ----------
    pair : Pair
        See `pair_up`.
    states : States, shape (N, n)
        In the coordinates of the pair's first arm.

    Returns
    -------
    Attribution
        Of 3 + 10 n contributions.

    Raises
    ------
    InputError
        For other types, no state, or states of another number of joints.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> states = ur5check.random_states(6, 10, seed=0)
    >>> len(ur5check.attribute_by_parameter(pair, states).contributions)
    63
    """
    check_pair(pair, states)
    q, qd, qdd = states.q, states.qd, states.qdd
    Y = np.zeros((*q.shape, 10 * pair.a.n))
    sides: tuple[Side, Side] = ("a", "b")
    for geometry, gravity in product(sides, repeat=2):
        part = torque_regressor(pair.arm(geometry, geometry, gravity), q, qd, qdd)
        changed = (geometry, gravity).count("a")
        Y += weight(changed, 3) * (part if geometry == "a" else _in_frames_of_a(part, pair))
    whole = attribute(pair, states)
    parameters = np.moveaxis(Y * pair.parameter_difference(), -1, 0)
    contributions = [
        Contribution(name, link)
        for link in range(1, pair.a.n + 1)
        for name in PARAMETER_CONTRIBUTIONS
    ]
    return Attribution(
        whole.delta,
        (*whole.contributions[:3], *contributions),
        np.concatenate([whole.torque[:3], parameters]),
        whole.rounding,
    )


def by_term(pair: Pair, states: States) -> TermAttribution:
    """Split Δτ into the terms of the equation of motion, and each of them as `attribute` does.

    τ(q, 0, 0) is gravity's, τ(q, q̇, 0) without gravity the Coriolis and centrifugal term's,
    τ(q, 0, q̈) without gravity the inertial term's; torque is the sum of the three, and so is every
    contribution.

    Parameters
    ----------
    pair : Pair
        See `pair_up`.
    states : States, shape (N, n)
        In the coordinates of the pair's first arm.

    Returns
    -------
    TermAttribution

    Raises
    ------
    InputError
        For other types, no state, or states of another number of joints.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> terms = ur5check.attribute_by_term(pair, ur5check.random_states(6, 10, seed=0))
    >>> terms.gravity.delta.shape
    (10, 6)
    """
    check_pair(pair, states)
    rest = np.zeros_like(states.q)
    weightless = replace(
        pair, a=pair.a.with_gravity(np.zeros(3)), b=pair.b.with_gravity(np.zeros(3))
    )
    return TermAttribution(
        gravity=attribute(pair, States(states.q, rest, rest)),
        coriolis=attribute(weightless, States(states.q, states.qd, rest)),
        inertial=attribute(weightless, States(states.q, rest, states.qdd)),
    )


def _in_frames_of_a(Y: Array, pair: Pair) -> Array:
    """A regressor of b's chain, for parameters held in a's link frames."""
    result = np.empty_like(Y)
    for i, T in enumerate(pair.link_maps):
        block = slice(10 * i, 10 * i + 10)
        result[..., block] = Y[..., block] @ parameter_map(T.inverse())
    return result
