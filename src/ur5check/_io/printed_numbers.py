"""Numbers as they were printed: a value, and how far rounding may have moved it.

A file prints an inertia with so many digits, and a tensor that broke no law before it was printed
may break one after.  How far it may, the digits themselves say.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal

__all__ = ["Printed", "common_rounding", "plain_number"]

# float() also takes "nan", "inf", "1_000" and " 1 "; a model file may not.
_PLAIN = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\Z", re.ASCII)

# Programs that print the shortest text of a number drop trailing zeros: "0.1" may be known to many
# digits.  So a text of one digit is not taken as a number known to one digit: that would let
# the moments (0.1, 0.1, 0.3), impossible by half of the largest, pass as rounding.
_LEAST_DIGITS = 2


class Printed(float):
    """A number that remembers its text."""

    text: str

    def __new__(cls, text: str) -> Printed:
        number = super().__new__(cls, text)
        number.text = text
        return number

    @property
    def exact(self) -> bool:
        """Whether it is zero or whole: an inertia is not rounded to whole kg m²."""
        return self == 0.0 or not any(mark in self.text for mark in ".eE")


def plain_number(text: str) -> Printed:
    """The number that `text` writes in plain decimal notation.

    Raises ValueError, saying what is wrong, for anything else: nan, inf, a decimal comma, digits
    grouped with underscores, an expression, a number beyond a double's range.
    """
    stripped = text.strip()
    if not _PLAIN.match(stripped):
        raise ValueError(_reason(stripped))
    number = Printed(stripped)
    if number in (float("inf"), float("-inf")):
        raise ValueError("is larger than a double can hold")
    return number


def _reason(text: str) -> str:
    if not text:
        return "is empty where a number belongs"
    if "${" in text or "$(" in text:
        return "is an unexpanded xacro expression"
    if text.lstrip("+-").lower() in ("nan", "inf", "infinity"):
        return "is not finite"
    if re.fullmatch(r"[+-]?\d+,\d+", text):
        return "has a decimal comma"
    return "is not a plain number"


def common_rounding(numbers: Mapping[str, float]) -> dict[str, float]:
    """How far each of several numbers that one program printed may lie from the number meant.

    A program prints either so many decimals or so many significant digits, and drops zeros at the
    end.  Of the two, the way that explains the texts with fewer dropped zeros is taken; either way
    the largest is known to two digits at least.  Numbers that are exact, or not `Printed`, get 0.
    """
    inexact = {
        name: Decimal(number.text)
        for name, number in numbers.items()
        if isinstance(number, Printed) and not number.exact
    }
    places = {name: -int(value.as_tuple().exponent) for name, value in inexact.items()}
    digits = {name: len(value.as_tuple().digits) for name, value in inexact.items()}
    most_places = max(places.values(), default=0)
    most_digits = max(_LEAST_DIGITS, *digits.values()) if digits else 0
    largest = max((value.adjusted() for value in inexact.values()), default=0)
    last_place = min(-most_places, largest - (_LEAST_DIGITS - 1))
    dropped_places = sum(most_places - n for n in places.values())
    dropped_digits = sum(most_digits - n for n in digits.values())
    rounding = dict.fromkeys(numbers, 0.0)
    for name, value in inexact.items():
        by_digits = value.adjusted() - most_digits + 1
        last_digit = last_place if dropped_places <= dropped_digits else by_digits
        rounding[name] = float(Decimal(5).scaleb(last_digit - 1))
    return rounding
