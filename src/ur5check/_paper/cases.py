"""The paper's nine test cases: posture, joint that turns, joint whose torque is examined.

Static throughout: q̇ = q̈ = 0, only gravity acts.  In cases 1 to 8 one joint makes a full turn in
steps of 1°; case 9 is one posture.  (SSRN 3939013, section "Results & Simulation".)
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians

import numpy as np

from .._arguments import integer
from .._errors import UsageError
from .._robot.transforms import Array

__all__ = ["CASES", "SWEEP", "Case", "case"]

#: 0° … 360° in steps of 1° [rad], shape (361,).
SWEEP = np.radians(np.arange(361.0))


@dataclass(frozen=True)
class Case:
    """One test case.

    number : 1 … 9
    posture : joint angles [rad], one per joint; None for the one that turns
    watched : the joint whose torque is examined, from 1; None for all
    claim : what the paper says of the curve, in our words
    """

    number: int
    posture: tuple[float | None, ...]
    watched: int | None
    claim: str

    @property
    def swept(self) -> int | None:
        """The joint that turns, from 1; None where none does."""
        return self.posture.index(None) + 1 if None in self.posture else None

    def joint_angles(self) -> Array:
        """Every state of the case, shape (361, n) or (1, n) [rad]."""
        steps = 1 if self.swept is None else len(SWEEP)
        columns = [SWEEP if q is None else np.full(steps, q) for q in self.posture]
        return np.stack(columns, axis=-1)

    def in_words(self) -> str:
        """The posture as text: `0°, θ2, 90°, 0°, 0°, 0°`."""
        if self.swept is None:
            return ", ".join(f"{q:g}" for q in self.posture if q is not None) + " rad"
        return ", ".join(
            f"θ{i}" if q is None else f"{round(np.degrees(q))}°"
            for i, q in enumerate(self.posture, 1)
        )


def _sweep(number: int, watched: int, claim: str, *degrees: float | None) -> Case:
    posture = tuple(None if angle is None else radians(angle) for angle in degrees)
    return Case(number, posture, watched, claim)


CASES = (
    _sweep(1, 3, "a sine curve", 0, 90, None, 0, 0, 0),
    _sweep(2, 2, "as expected", 0, None, 0, 0, 0, 0),
    _sweep(3, 2, "less torque than in case 2", 0, None, 90, 0, 0, 0),
    _sweep(4, 1, "zero and constant", None, 0, 0, 0, 0, 0),
    _sweep(5, 4, "a sine curve", 0, 90, 90, None, 0, 0),
    _sweep(6, 5, "as expected", 0, 90, 0, 0, None, 0),
    _sweep(7, 5, "low: link 5 is light", 0, 90, 90, 90, None, 0),
    _sweep(8, 6, "low: link 6 is light", 0, 90, 90, 90, 90, None),
    Case(9, (0.0, 0.9, -1.0, 1.0, 3.5, -1.9), None, "the arm stands or moves"),
)


def case(number: int) -> Case:
    """One of the paper's nine test cases.

    Parameters
    ----------
    number : int
        1 … 9

    Returns
    -------
    Case
        Posture, the joint that turns, and the joint whose torque is examined.

    Raises
    ------
    UsageError
        For another number.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.paper_case(2).in_words()
    '0°, θ2, 0°, 0°, 0°, 0°'
    """
    if integer("number", number, least=1) > len(CASES):
        raise UsageError(f"the paper has cases 1 to {len(CASES)}, not {number}")
    return CASES[number - 1]
