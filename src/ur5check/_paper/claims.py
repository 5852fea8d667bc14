"""Every claim of the paper that is put to the test, in the order of the paper.

A claim is a function from the evidence to outcomes.  To add a family, write a file of such
functions and name them here: one line each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from .claim import ClaimOutcome
from .control_claims import eq_28_is_the_law, feedback_is_stable
from .curve_claims import as_expected, posture_torque, sine, zero_and_constant
from .evidence import Evidence
from .load_claims import because_light, less_than_case_2, low
from .number_claims import (
    across_the_axis,
    along_the_axis,
    tensors_lie_along_links,
    vectors_from_dh,
)
from .simulation_claims import posture_is_clear, the_arm_stands
from .soft_limits import soft_limits

__all__ = [
    "CLAIMS",
    "OF_CASES",
    "OF_CONTROL",
    "OF_LIMITS",
    "OF_NUMBERS",
    "OF_SIMULATION",
    "ClaimFunction",
]

ClaimFunction = Callable[[Evidence], Iterable[ClaimOutcome]]

#: Lengths and inertia tensors.
OF_NUMBERS: tuple[ClaimFunction, ...] = (
    vectors_from_dh,
    across_the_axis,
    along_the_axis,
    tensors_lie_along_links,
)

#: The nine test cases.
OF_CASES: tuple[ClaimFunction, ...] = (
    sine,
    as_expected,
    less_than_case_2,
    zero_and_constant,
    low,
    because_light,
    posture_torque,
)

#: The appendix's joint limits.
OF_LIMITS: tuple[ClaimFunction, ...] = (soft_limits,)

#: What was published to the simulator.
OF_SIMULATION: tuple[ClaimFunction, ...] = (the_arm_stands, posture_is_clear)

#: The controller of the section on future work.
OF_CONTROL: tuple[ClaimFunction, ...] = (feedback_is_stable, eq_28_is_the_law)

CLAIMS = (*OF_NUMBERS, *OF_CASES, *OF_SIMULATION, *OF_CONTROL, *OF_LIMITS)
