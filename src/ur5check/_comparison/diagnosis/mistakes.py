"""All known mistakes.  Each stands in the file of what it spoils, the likelier first: where two
explain a difference equally well, the earlier is named first.

Sources: what users reported (docs/diagnosis.md lists the threads) and the paper's own mistakes.
"""

from __future__ import annotations

from .arm_mistakes import ARM_MISTAKES, ROUNDED
from .body_mistakes import BODY_MISTAKES
from .centre_mistakes import CENTRE_MISTAKES
from .geometry_mistakes import GEOMETRY_MISTAKES
from .mass_mistakes import MASS_MISTAKES
from .mistake import LinkMistake, Mistake
from .tensor_mistakes import TENSOR_MISTAKES

__all__ = ["LINK_MISTAKES", "MISTAKES"]

LINK_MISTAKES: tuple[LinkMistake, ...] = (
    *BODY_MISTAKES,
    *MASS_MISTAKES,
    *CENTRE_MISTAKES,
    *TENSOR_MISTAKES,
    *GEOMETRY_MISTAKES,
)

MISTAKES: tuple[Mistake, ...] = (*LINK_MISTAKES, *ROUNDED, *ARM_MISTAKES)
