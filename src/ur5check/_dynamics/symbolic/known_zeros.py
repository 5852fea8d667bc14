"""Entries that are zero for all states, found numerically.

Gravity makes no torque on a vertical joint, but proving it takes c² + s² = 1 along the whole arm.
A polynomial that is zero at random points is zero (Schwartz 1980, Zippel 1979), so entries are
evaluated at random states and random values of the symbols.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..._robot.states import random_states
from .program import Program

__all__ = ["vanishing"]

_STATES = 20

#: A smaller share of the largest entry is rounding, of about a hundred operations.
_ROUNDING = 64 * float(np.finfo(np.float64).eps)


def vanishing(program: Program, seed: int = 0) -> NDArray[np.bool_]:
    """Which outputs are zero at every state, shape (number of outputs,), though they have terms."""
    states = random_states(program.n, _STATES, seed)
    rng = np.random.default_rng(seed)
    values = {name: v * rng.uniform(0.5, 2.0) for name, v in program.parameters.items()}
    at = {name: getattr(states, name) for name in program.arguments}
    entries = np.abs(program.evaluate(**at, **values)).reshape(_STATES, -1).max(axis=0)
    written = np.array([bool(line.terms) for line in program.outputs])
    return np.asarray(written & (entries <= _ROUNDING * entries.max()))
