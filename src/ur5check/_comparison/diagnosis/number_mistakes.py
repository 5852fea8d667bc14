"""Ways in which single numbers and vectors go wrong, whatever they stand for."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from ..._robot.transforms import Array
from .mistake import Repair

__all__ = ["DECADES", "axis_swaps", "digit_swaps", "shifted_decimals", "sign_flips", "words_of"]

#: Powers of ten by which units and decimal points mistake; 1000 is kg for g, m for mm.
DECADES = (1e-3, 1e3, 1e-1, 1e1, 1e-2, 1e2, 1e-4, 1e4, 1e-6, 1e6)

_AXES = "xyz"


def sign_flips(v: Array) -> Iterator[Repair]:
    """One component with its sign changed."""
    for k in range(3):
        if v[k] != 0.0:
            flipped = v.copy()
            flipped[k] = -v[k]
            yield f"sign of {_AXES[k]}", flipped


def axis_swaps() -> Iterator[tuple[str, Array]]:
    """Permutations of the axes, as matrices: the swaps first, then the two cycles."""
    for order in ((1, 0, 2), (2, 1, 0), (0, 2, 1), (1, 2, 0), (2, 0, 1)):
        yield f"xyz read as {''.join(_AXES[k] for k in order)}", np.eye(3)[list(order)]


def digit_swaps(value: float) -> Iterator[Repair]:
    """Two neighbouring digits of a printed number exchanged.

    Printed numbers have at most eight digits; one that has more was computed.
    """
    text = repr(abs(value))
    if "e" in text or len(text.replace(".", "").lstrip("0")) > 8:
        return
    digits = [k for k, character in enumerate(text) if character.isdigit()]
    for one, other in pairwise(digits):
        if text[one] != text[other]:
            swapped = list(text)
            swapped[one], swapped[other] = swapped[other], swapped[one]
            repaired = "".join(swapped)
            yield f"{repaired} for {text}", float(np.copysign(float(repaired), value))


def shifted_decimals(v: Array) -> Iterator[Repair]:
    """One component with its decimal point moved."""
    for k in range(3):
        if v[k] != 0.0:
            for factor in DECADES:
                shifted = v.copy()
                shifted[k] = factor * v[k]
                yield f"{_AXES[k]} {words_of(factor)}", shifted


def words_of(factor: float) -> str:
    """A repairing factor as what went wrong: 1e-3 repairs what is a thousand times too large."""
    ratio = 1.0 / factor if factor < 1.0 else factor
    return f"{ratio:g} times too {'large' if factor < 1.0 else 'small'}"
