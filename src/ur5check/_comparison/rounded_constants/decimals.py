"""Numbers as they were written: how many decimals, and which constant was rounded.

A float does not keep its text, but of all numbers near it the shortest decimal is taken as what was
written: 0.089159 has six decimals, and one that needs more than nine digits was computed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import floor, log10, ulp

__all__ = ["MOST_DIGITS", "Writing", "decimals_of", "half_units", "written_as"]

#: A person, or a table, writes no more significant digits than this; a program writes 12 to 17.
MOST_DIGITS = 9

# Moving a number to another frame and back leaves this rounding error, relative and absolute.
_RELATIVE_ZERO_TOLERANCE, _ABSOLUTE_ZERO_TOLERANCE = 1e-13, 1e-15


@dataclass(frozen=True)
class Writing:
    """A constant written with so many decimals, rounded or cut off."""

    text: str
    decimals: int
    value: float


def written_as(
    value: float, constant: float, *, least: int = 1, tolerance: float = 0.0
) -> Writing | None:
    """How `value` writes `constant`: 1.5707 is π/2 with 4 decimals, cut off.

    None if it is the constant itself, or no rounding of it with at least `least` decimals.
    """
    close = max(tolerance, 4.0 * ulp(constant))
    if abs(value - constant) <= close:
        return None
    for decimals in range(least, 14):
        below = floor(constant * 10**decimals)
        for whole in (below, below + 1):
            candidate = whole / 10**decimals
            # Rounded is the nearer of the two, cut off is the lower; the third is a mistake.
            is_rounding = abs(candidate - constant) <= 0.5 * 10.0**-decimals
            if (is_rounding or whole == below) and abs(value - candidate) <= close:
                return Writing(f"{candidate:.{decimals}f}", decimals, candidate)
    return None


def decimals_of(value: float, most: int = MOST_DIGITS) -> int | None:
    """Decimals of the shortest number that `value` can be.

    None for zero, and for a number of more than `most` significant digits.
    """
    zero_tolerance = max(_ABSOLUTE_ZERO_TOLERANCE, _RELATIVE_ZERO_TOLERANCE * abs(value))
    if abs(value) <= zero_tolerance:
        return None
    leading = floor(log10(abs(value)))  # place of the first significant digit
    for decimals in range(max(0, most - leading)):
        if abs(round(value, decimals) - value) <= zero_tolerance:
            return decimals
    return None


def half_units(values: Sequence[float], beside: Sequence[float] = ()) -> list[float]:
    """Half a unit in the last place of each of these numbers, which one table prints.

    beside : other numbers of the same unit in the same file, printed to as many decimals

    A column is printed with one number of decimals, and trailing zeros are lost: the
    3.7 beside 0.1879 was 3.7000.  So the finest number gives the place for all of them.  Zeros are
    exact.  If one of the numbers needs more than MOST_DIGITS digits, a program computed them, and
    all are exact.
    """
    places = []
    for value in values:
        decimals = decimals_of(value)
        if decimals is not None:
            places.append(decimals)
        elif abs(value) > _ABSOLUTE_ZERO_TOLERANCE:
            return [0.0] * len(values)
    places += [d for value in beside if (d := decimals_of(value)) is not None]
    half = 0.5 * 10.0 ** -max(places, default=0)
    return [half if abs(value) > _ABSOLUTE_ZERO_TOLERANCE else 0.0 for value in values]
