"""What each quantity must equal: the recursion on numbers, and Pinocchio."""

from __future__ import annotations

import numpy as np

import ur5check
from ur5check._dynamics.equations import bias_torque
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._robot.states import random_states

RECURSION = {
    "tau": ur5check.rnea,
    "M": ur5check.mass_matrix,
    "C": ur5check.coriolis_matrix,
    "g": ur5check.gravity_torque,
    "bias": bias_torque,
    "regressor": ur5check.torque_regressor,
}

PINOCCHIO = {
    "tau": PinocchioEngine.inverse_dynamics,
    "M": PinocchioEngine.mass_matrix,
    "C": PinocchioEngine.coriolis_matrix,
    "g": PinocchioEngine.gravity_torque,
    "bias": PinocchioEngine.bias_torque,
    "regressor": PinocchioEngine.torque_regressor,
}


def reference(quantity):
    """The quantity as Pinocchio has it, asked like the recursion: arm first."""
    return lambda arm, *at: PINOCCHIO[quantity](PinocchioEngine(arm), *at)


def states(arm, count=1000):
    return random_states(arm.n, count, seed=0)


def arguments(program, at):
    return [getattr(at, name) for name in program.arguments]


def distance(program, arm, reference, at=None, evaluate=None):
    """Largest difference over random states, of the program and its reference."""
    at = at or states(arm)
    given = arguments(program, at)
    result = (evaluate or program.evaluate)(*given)
    expected = reference(arm, *given)
    assert result.shape == expected.shape
    return float(np.abs(result - expected).max())
