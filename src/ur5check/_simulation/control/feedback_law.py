"""Three forms of the feedback: the stable one, and two that the paper prints.

With the error e = θ_d − θ (eq. 21), the commanded joint acceleration is

    as it must be    K = θ̈_d + K_p e + K_i ∫e dt + K_d ė
    eqs (22), (23)   K = θ̈_d − K_p e − K_i ∫e dt − K_d ė      as printed
    eq. (28)         K =       K_p e + K_i ∫e dt + K_d ė      as printed
"""

from __future__ import annotations

from enum import Enum

__all__ = ["FeedbackLaw"]


class FeedbackLaw(Enum):
    """Form of the feedback; the value is its name in reports.

    Examples
    --------
    >>> from ur5check import FeedbackLaw
    >>> FeedbackLaw("eqs (22), (23) as printed").sign
    -1.0
    """

    RIGHT = "as it must be"
    PRINTED_22 = "eqs (22), (23) as printed"
    PRINTED_28 = "eq. (28) as printed"

    @property
    def sign(self) -> float:
        """Sign of the feedback: +1 reduces an error, −1 increases it."""
        return -1.0 if self is FeedbackLaw.PRINTED_22 else 1.0

    @property
    def feeds_forward(self) -> bool:
        """Whether K contains θ̈_d."""
        return self is not FeedbackLaw.PRINTED_28
