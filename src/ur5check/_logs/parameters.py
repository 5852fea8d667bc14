"""Base parameters from a recording: how each differs from the model's, and how sure that is.

Weighted least squares of the residual by the regressor's base columns, friction and rotor inertia
free (an inertia about a joint's axis that no torque tells from the rotor's is none of them), with
the covariance of blocks (see `least_squares`).  Intervals are of this recording alone: between
recordings of one robot, values scatter about `BETWEEN_RUNS` times as much, because friction changes
with temperature and load (five recordings of three arms).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._comparison.identifiability.identifiability import identify
from .weighted_problem import WeightedProblem

__all__ = ["BETWEEN_RUNS", "BaseParameter", "base_parameters"]

#: Spread between recordings, over what blocks of one show.
BETWEEN_RUNS = 3.0


@dataclass(frozen=True)
class BaseParameter:
    """One combination of inertial parameters, in the links' frames i, in SI units.

    name : of the parameter that stands for it;  combination : written out
    given : the model's value;  change, half_width : of this recording's value from it, 95 %
    """

    name: str
    combination: str
    given: float
    change: float
    half_width: float

    @property
    def excited(self) -> bool:
        """Whether this recording determines it better than to its own size."""
        return self.half_width < max(abs(self.given), abs(self.given + self.change))

    @property
    def differs(self) -> bool:
        """Whether it differs by more than another recording would show by chance."""
        return abs(self.change) > BETWEEN_RUNS * self.half_width


def base_parameters(problem: WeightedProblem) -> tuple[BaseParameter, ...]:
    """All base parameters of the arm's geometry, from the recording."""
    known = identify(problem.arm, rotors=True)
    columns = np.array(known.base)
    fitted = problem.fitted_parameters(np.zeros(10 * problem.n), np.eye(10 * problem.n)[:, columns])
    given = known.base_parameters(problem.arm.parameters())
    return tuple(
        BaseParameter(known.names[place], text, float(value), float(change), float(width))
        for place, text, value, change, width in zip(
            known.base, known.combinations(), given, fitted.value, fitted.half_width, strict=True
        )
    )
