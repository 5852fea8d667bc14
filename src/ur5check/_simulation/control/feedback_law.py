"""Three forms of the paper's feedback: its equations disagree with each other, and with stability.

With the error e = θ_d − θ (eq. 21), the joint accelerations asked for are

    as it must be    K = θ̈_d + K_p e + K_i ∫e dt + K_d ė
    eqs (22), (23)   K = θ̈_d − K_p e − K_i ∫e dt − K_d ė      as printed
    eq. (28)         K =       K_p e + K_i ∫e dt + K_d ė      as printed
"""

from __future__ import annotations

from enum import Enum

__all__ = ["FeedbackLaw"]


class FeedbackLaw(Enum):
    """Which form; the value is its name in reports."""

    RIGHT = "as it must be"
    PRINTED_22 = "eqs (22), (23) as printed"
    PRINTED_28 = "eq. (28) as printed"

    @property
    def sign(self) -> float:
        """Of the feedback: +1 pushes an error down, −1 up."""
        return -1.0 if self is FeedbackLaw.PRINTED_22 else 1.0

    @property
    def feeds_forward(self) -> bool:
        """Whether θ̈_d is part of it."""
        return self is not FeedbackLaw.PRINTED_28
