"""How much of a torque difference comes from rounded numbers, and what remains.

Two kinds of items, kept apart.  *Recomputed*: a number is corrected (π/2 for 1.5707, 1/12 for
0.0833333, 9.80665 for 9.806), the torque is computed again, and the step is exact.  Steps are made
one after the other, angles first, then 1/12, then gravity, side a before side b, so that

    Δτ = Σ recomputed items + remainder      at every state, to rounding.

*Bounds*: the largest effect of the last printed digit of all other numbers.  Which way they were
rounded is unknown, so they explain nothing; a remainder below them needs no explanation.  Numbers
that are equal in both files cancel in Δτ and are omitted.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..._dynamics.recursion import rnea
from ..._dynamics.regressor import torque_regressor
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States
from ..._robot.transforms import Array
from ..alignment import SAME_ANGLE, SAME_LENGTH, arm_in_coordinates_of
from ..arm_pair import Pair, Side, check_pair
from ..rounded_constants.exact_constants import STEPS, Arms, RoundedConstant
from .printed_digits import Mask, printed_numbers, torque_of_inertial_digits, torque_of_lengths

__all__ = ["BudgetItem", "ErrorBudget", "PrintedDigits", "budget"]

_ROUNDING = 64 * float(np.finfo(np.float64).eps)  # as in `attribution`


@dataclass(frozen=True)
class PrintedDigits:
    """The last printed digit of so many numbers of one arm that differ from the other's."""

    quantity: Literal["inertial parameters", "lengths"]
    count: int


@dataclass(frozen=True, eq=False)
class BudgetItem:
    """The torque error of one kind of rounding, over N states.

    Attributes
    ----------
    cause : RoundedConstant or PrintedDigits
        What was rounded.
    side : {"a", "b"}
        The arm that has it.
    rms, maximum : ndarray, shape (n,)
        Of the torque, per joint [N m].
    """

    cause: RoundedConstant | PrintedDigits
    side: Side
    rms: Array
    maximum: Array

    @property
    def exact(self) -> bool:
        """Whether the difference was recomputed; otherwise it is a bound."""
        return isinstance(self.cause, RoundedConstant)


@dataclass(frozen=True, eq=False)
class ErrorBudget:
    """A torque difference, what rounded numbers explain of it, and the rest.

    Attributes
    ----------
    items : tuple of BudgetItem
        Recomputed ones first, in the order of the steps, then bounds.
    total : ndarray, shape (n,)
        RMS of Δτ [N m].
    explained : ndarray, shape (n,)
        RMS of the sum of all recomputed items [N m].
    remainder, remainder_maximum : ndarray, shape (n,)
        RMS and maximum of the unexplained part [N m].
    bound : ndarray, shape (n,)
        RMS of all bounds together, taken as independent [N m].
    rounding : float
        What floating-point rounding alone makes of a difference [N m].
    """

    items: tuple[BudgetItem, ...]
    total: Array
    explained: Array
    remainder: Array
    remainder_maximum: Array
    bound: Array
    rounding: float

    @property
    def digits_suffice(self) -> bool:
        """Whether the remainder is within the bounds of the printed digits, in every joint."""
        most = self.rounding + sum(item.maximum for item in self.items if not item.exact)
        return bool((self.remainder_maximum <= most).all())


def budget(pair: Pair, states: States) -> ErrorBudget:
    """The torque error due to rounded numbers in a pair of arms, at these states.

    Joint signs and offsets stay those of the pair; its base transform turns gravity and arm
    together and plays no part in torque.

    Parameters
    ----------
    pair : Pair
        See `pair_up`.
    states : States, shape (N, n)
        In the coordinates of the pair's first arm.

    Returns
    -------
    ErrorBudget

    Raises
    ------
    InputError
        For other types, no state, or states of another number of joints.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> found = ur5check.error_budget(pair, ur5check.random_states(6, 10, seed=0))
    >>> found.digits_suffice
    False
    """
    check_pair(pair, states)
    arms: Arms = {"a": pair.a, "b": pair.given_b}
    torque = {side: _torque(pair, side, arm, states) for side, arm in arms.items()}
    largest = max(float(np.abs(tau).max()) for tau in torque.values())
    total = left = torque["a"] - torque["b"]
    items = []
    for step in STEPS:
        for found in list(step(arms)):
            arms[found.side] = found.arm
            torque[found.side] = _torque(pair, found.side, found.arm, states)
            before, left = left, torque["a"] - torque["b"]
            part = before - left
            items.append(BudgetItem(found.cause, found.side, _rms(part), _max(part)))
    bounds = [*_bounds(pair, states, "a"), *_bounds(pair, states, "b")]
    return ErrorBudget(
        (*items, *bounds),
        _rms(total),
        _rms(total - left),
        _rms(left),
        _max(left),
        np.sqrt(sum((item.rms**2 for item in bounds), np.zeros(pair.a.n))),
        _ROUNDING * pair.a.n * largest,
    )


def _torque(pair: Pair, side: Side, arm: SerialArm, states: States) -> Array:
    """Torques of a changed arm of one side, as it was given, at states of arm a's coordinates."""
    if side == "b":
        arm = arm_in_coordinates_of(pair.a, arm, pair.alignment)
    return rnea(arm, states.q, states.qd, states.qdd)


def _bounds(pair: Pair, states: States, side: Side) -> Iterator[BudgetItem]:
    arms: Arms = {"a": pair.a, "b": pair.given_b}
    printed = {each: printed_numbers(arm) for each, arm in arms.items()}
    other: Side = "b" if side == "a" else "a"
    numbers = printed[side].without(printed[other], _same_frames(pair))
    moved = pair.a if side == "a" else pair.b
    Y = torque_regressor(moved, states.q, states.qd, states.qdd)
    inertial = torque_of_inertial_digits(arms[side], numbers, Y)
    lengths = torque_of_lengths(arms[side], numbers, lambda arm: _torque(pair, side, arm, states))
    digits = (
        (PrintedDigits("inertial parameters", len(inertial)), inertial),
        (PrintedDigits("lengths", len(lengths)), lengths),
    )
    for cause, parts in digits:
        if cause.count:
            yield BudgetItem(
                cause,
                side,
                np.sqrt((parts**2).sum(axis=0).mean(axis=0) / 3.0),
                np.abs(parts).sum(axis=0).max(axis=0),
            )


def _same_frames(pair: Pair) -> Mask:
    """For each link, whether both sources write it in the same frame, shape (n,) of bool."""
    between = [
        la.source_frame.inverse() @ T @ lb.source_frame
        for la, T, lb in zip(pair.a.links, pair.link_maps, pair.b.links, strict=True)
    ]
    same = [E.angle() < SAME_ANGLE and abs(E.p).max() < SAME_LENGTH for E in between]
    return np.array(same, dtype=np.bool_)


def _rms(part: Array) -> Array:
    return np.asarray(np.sqrt((part**2).mean(axis=0)))


def _max(part: Array) -> Array:
    return np.asarray(np.abs(part).max(axis=0))
