"""Pinocchio as its users call it: a Python loop over states, or its own parallel loop.

The loops keep no result, which saves Pinocchio a copy per state.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pinocchio as pin

from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._robot.serial_arm import SerialArm, Source
from ur5check._robot.states import States
from ur5check._robot.transforms import Array

__all__ = ["PinocchioCalls"]


class PinocchioCalls:
    """Pinocchio's algorithms on one arm and these states."""

    def __init__(self, arm: SerialArm, states: States, threads: int) -> None:
        self.model = _model(arm)
        self.data = self.model.createData()
        self.states = states
        self._pool = pin.ModelPool(self.model, threads)
        self._columns = [np.asfortranarray(rows.T) for rows in (states.q, states.qd, states.qdd)]
        self._tau = np.empty(self._columns[0].shape, order="F")

    def in_parallel(self, threads: int) -> Array:
        """τ by `pin.rneaInParallel`, shape (N, n)."""
        pin.rneaInParallel(threads, self._pool, *self._columns, self._tau)
        return self._tau.T

    def loop(self, algorithm: str, count: int) -> Callable[[], None]:
        """`algorithm`, "pin.crba", at the first `count` states."""
        call: Any = getattr(pin, algorithm.removeprefix("pin."))
        model, data = self.model, self.data
        parts = (self.states.q, self.states.qd, self.states.qdd)[: _ARGUMENTS[algorithm]]
        rows = [part[:count] for part in parts]

        def run() -> None:
            for state in zip(*rows, strict=True):
                call(model, data, *state)

        return run


_ARGUMENTS = {
    "pin.rnea": 3,
    "pin.crba": 1,
    "pin.computeCoriolisMatrix": 2,
    "pin.computeGeneralizedGravity": 1,
    "pin.computeJointTorqueRegressor": 3,
}


def _model(arm: SerialArm) -> Any:
    """From the arm's own file, where possible: Pinocchio has faster joints for axes along x, y, z.

    An arm whose q differs from Pinocchio's (continuous joints, another order) is built joint by
    joint.
    """
    model = PinocchioEngine(arm).model
    if model.nq == arm.n and list(model.names)[1:] == list(arm.joint_names):
        return model
    return PinocchioEngine(replace(arm, source=Source())).model
