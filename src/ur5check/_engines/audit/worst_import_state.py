"""The state where the arm as written and the arm as imported differ most."""

from __future__ import annotations

import numpy as np

from ..._comparison.arm_pair import pair_up
from ..._comparison.worst_case.worst_case import worst_cases
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States

__all__ = ["join_states", "worst_state"]

# The comparison needs a bad state, not proof of the worst: fewer ascents than `diff` makes.
_STARTS, _RANDOM = 3, 3_000


def worst_state(arm: SerialArm, imported_arm: SerialArm, seed: int) -> States:
    """The one state, within the arm's limits, where a single joint's torque differs most."""
    cases = worst_cases(
        pair_up(arm, imported_arm), seed=seed, starts=_STARTS, random_states=_RANDOM
    )
    single = [case for case in cases if case.joint is not None and not case.static]
    state = max(single, key=lambda case: case.value).state
    return States(*(np.array([state[name]]) for name in ("q", "qd", "qdd")))


def join_states(*several: States) -> States:
    """All states, one after the other."""
    return States(
        *(np.concatenate([getattr(s, name) for s in several]) for name in ("q", "qd", "qdd"))
    )
