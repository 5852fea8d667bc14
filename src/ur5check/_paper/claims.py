"""Every claim of the paper that is tested, in the order of the paper.

A claim is a function from the evidence to outcomes.  To add a claim, write such a function and name
it here: one line.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from .claim import ClaimOutcome
from .control_claims import eq_28_is_the_law, feedback_is_stable, gains_reach_every_joint
from .curve_claims import as_expected, posture_torque, sine, zero_and_constant
from .derivation_claims import listing_runs, newton_euler_is_more_accurate
from .evidence import Evidence
from .geometry_claims import eq_1_is_the_transform, table_1_is_the_robot, vectors_from_dh
from .load_claims import because_light, less_than_case_2, low
from .number_claims import (
    across_the_axis,
    along_the_axis,
    tensors_lie_along_links,
)
from .simulation_claims import posture_is_clear, the_arm_stands
from .soft_limits import soft_limits
from .workspace_claims import cylinder_is_unreachable, sphere_is_the_reach

__all__ = [
    "CLAIMS",
    "OF_CASES",
    "OF_CONTROL",
    "OF_DERIVATION",
    "OF_GEOMETRY",
    "OF_LIMITS",
    "OF_NUMBERS",
    "OF_SIMULATION",
    "ClaimFunction",
]

ClaimFunction = Callable[[Evidence], Iterable[ClaimOutcome]]

#: The workspace, Table 1, eq. (1) and the listing's vectors.
OF_GEOMETRY: tuple[ClaimFunction, ...] = (
    sphere_is_the_reach,
    cylinder_is_unreachable,
    eq_1_is_the_transform,
    table_1_is_the_robot,
    vectors_from_dh,
)

#: The method, and the program.
OF_DERIVATION: tuple[ClaimFunction, ...] = (newton_euler_is_more_accurate, listing_runs)

#: Inertia tensors.
OF_NUMBERS: tuple[ClaimFunction, ...] = (
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
OF_CONTROL: tuple[ClaimFunction, ...] = (
    feedback_is_stable,
    gains_reach_every_joint,
    eq_28_is_the_law,
)

CLAIMS = (
    *OF_GEOMETRY,
    *OF_DERIVATION,
    *OF_NUMBERS,
    *OF_CASES,
    *OF_SIMULATION,
    *OF_CONTROL,
    *OF_LIMITS,
)
