"""Different numbers, same dynamics: do two arms differ only in parameters without effect on torque?

A parameter difference Δπ is split into a part that the base parameters hold, which changes torque,
and a part in the null space, which does not:

    visible[base] = Δπ[base] + β Δπ[dependent],   visible[dependent] = 0,   invisible = Δπ − visible
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..._arguments import instance
from ..._dynamics.recursion import rnea
from ..._dynamics.regressor import torque_regressor
from ..._robot.states import States
from ..._robot.transforms import Array
from ..arm_pair import Pair, check_pair
from .identifiability import Identifiability, identify

__all__ = ["TOLERANCE", "Equivalence", "VisibleSplit", "equivalence", "split"]

#: Part of the largest torque up to which two models agree: `difference.SAME_TORQUE`, written
#: here again because `difference` stands above this file.  A test holds the two equal.
TOLERANCE = 1e-6

_SAME_NUMBER = 1e-12  # of the largest parameter: rounding of a change of frames


@dataclass(frozen=True, eq=False)
class VisibleSplit:
    """A parameter difference Δπ as a part that changes torque and one that does not.

    visible : held by base parameters alone;  invisible : in the null space; both shape (10 n,),
        and their sum is Δπ to rounding
    base : the difference of the base parameters, shape (rank,)
    """

    visible: Array
    invisible: Array
    base: Array


@dataclass(frozen=True, eq=False)
class Equivalence:
    """How arm b's dynamics differ from arm a's.

    Attributes
    ----------
    split : VisibleSplit
        Δπ = π_a − π_b, in a's link frames, as visible and invisible part.
    visible : ndarray, shape (n,)
        Largest torque that the visible part makes with a's geometry, per joint [N m].
    other : ndarray, shape (n,)
        Largest torque difference that is not Y Δπ (geometry and gravity), per joint [N m].
    largest : float
        Largest torque of arm a [N m].
    same_numbers : bool
        Whether Δπ is rounding only.
    """

    split: VisibleSplit
    visible: Array
    other: Array
    largest: float
    same_numbers: bool

    @property
    def dynamically_equivalent(self) -> bool:
        """Whether neither part makes more torque than TOLERANCE of arm a's largest."""
        return float(max(self.visible.max(), self.other.max())) <= TOLERANCE * self.largest


def split(identifiability: Identifiability, dpi: ArrayLike) -> VisibleSplit:
    """The parts of Δπ, shape (10 n,), that do and do not change torque.

    Δπ must be expressed in the frames that `identify` used.
    """
    base = identifiability.base_parameters(dpi)
    visible = np.zeros(identifiability.columns)
    visible[list(identifiability.base)] = base
    return VisibleSplit(visible, np.asarray(dpi, dtype=np.float64) - visible, base)


def equivalence(
    pair: Pair, states: States, identifiability: Identifiability | None = None
) -> Equivalence:
    """Judge a pair of arms by the torques that their difference makes at these states.

    Parameters
    ----------
    pair : Pair
        See `pair_up`.
    states : States, shape (N, n)
        In the coordinates of the pair's first arm.
    identifiability : Identifiability, optional
        `identify(pair.a)`, where it is known already.

    Returns
    -------
    Equivalence

    Raises
    ------
    InputError
        For other types, no state, or states of another number of joints.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> found = ur5check.equivalence(pair, ur5check.random_states(6, 10, seed=0))
    >>> found.dynamically_equivalent
    False
    """
    check_pair(pair, states)
    if identifiability is not None:
        instance("identifiability", identifiability, Identifiability, "see ur5check.identify")
    dpi = pair.parameter_difference()
    parts = split(identifiability or identify(pair.a), dpi)
    q, qd, qdd = states.q, states.qd, states.qdd
    Y = torque_regressor(pair.a, q, qd, qdd)
    tau_a, tau_b = rnea(pair.a, q, qd, qdd), rnea(pair.b, q, qd, qdd)
    largest_parameter = float(np.abs(pair.a.parameters()).max())
    return Equivalence(
        parts,
        np.abs(Y @ parts.visible).max(axis=0),
        np.abs(tau_a - tau_b - Y @ dpi).max(axis=0),
        float(np.abs(tau_a).max()),
        bool(np.abs(dpi).max() <= _SAME_NUMBER * largest_parameter),
    )
