"""What was rounded, and where, in words."""

from __future__ import annotations

from .._arguments import instance
from .._comparison.rounded_constants.exact_constants import RoundedConstant
from .._comparison.rounding.error_budget import BudgetItem, PrintedDigits

__all__ = ["cause_in_words", "constant_in_words", "places_in_words", "rounding_in_words"]

_QUANTITIES = {"inertial parameters": "masses, centres and tensors", "lengths": "lengths"}


def rounding_in_words(item: BudgetItem) -> str:
    """What was rounded, and where, as "π/2 written as 1.5707 (4 decimals), P1, P4".

    Parameters
    ----------
    item : BudgetItem
        One of `ErrorBudget.items`.

    Returns
    -------
    str

    Raises
    ------
    UsageError
        For another type.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("paper-listing", "paper")
    >>> found = ur5check.error_budget(pair, ur5check.random_states(6, 5, seed=0))
    >>> ur5check.rounding_in_words(found.items[0])
    'π/2 written as 1.5707 (4 decimals), P1, P4, P5'
    """
    instance("item", item, BudgetItem, "see ErrorBudget.items")
    return f"{cause_in_words(item)}, {places_in_words(item)}"


def cause_in_words(item: BudgetItem) -> str:
    """What was rounded: "π/2 written as 1.5707 (4 decimals)"."""
    cause = item.cause
    if isinstance(cause, PrintedDigits):
        return f"last printed digit of {_QUANTITIES[cause.quantity]}"
    return _written(cause)


def constant_in_words(cause: RoundedConstant) -> str:
    """A constant and where it stands: "π/2 written as 1.5707 (4 decimals), P1, P4"."""
    return f"{_written(cause)}, {', '.join(cause.where)}"


def _written(cause: RoundedConstant) -> str:
    decimals = "" if cause.decimals is None else f" ({cause.decimals} decimals)"
    return f"{cause.constant} written as {cause.written}{decimals}"


def places_in_words(item: BudgetItem) -> str:
    """Where: "P1, P4, P5", or "13 numbers" for printed digits."""
    cause = item.cause
    if isinstance(cause, PrintedDigits):
        return f"{cause.count} number{'s' if cause.count > 1 else ''}"
    return ", ".join(cause.where)
