"""Shapley's average: a difference split among the factors that changed.

A value f depends on several factors, and each can be taken from side a or from side b.  Changing
one factor after another from b to a splits f(a, …, a) − f(b, …, b) exactly, but the split depends
on the order.  Averaged over all orders (Shapley 1953) it depends on no order, and swapping the
names a and b only flips every sign.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from math import factorial

from .._robot.transforms import Array

__all__ = ["shares", "weight"]


def weight(changed_before: int, factors: int) -> float:
    """Share of the orders in which exactly a given set of `changed_before` factors came first."""
    return factorial(changed_before) * factorial(factors - changed_before - 1) / factorial(factors)


def shares(value: Callable[[tuple[bool, ...]], Array], factors: int) -> list[Array]:
    """Each factor's share of value(all True) − value(all False); they sum to it.

    value : of a choice per factor, True for side a
    """
    values = {choice: value(choice) for choice in product((False, True), repeat=factors)}
    result = []
    for k in range(factors):
        share = 0.0 * values[(False,) * factors]
        for choice, without in values.items():
            if not choice[k]:
                step = values[(*choice[:k], True, *choice[k + 1 :])] - without
                share = share + weight(sum(choice), factors) * step
        result.append(share)
    return result
