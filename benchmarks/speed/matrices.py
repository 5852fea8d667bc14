"""Mass matrix, Coriolis matrix, gravity torque and regressor, against Pinocchio's algorithms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ur5check._dynamics import equations, regressor
from ur5check._dynamics.compiled import kernel
from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.states import States

from .inverse_dynamics import LLVM, NUMPY, with_threads
from .pinocchio_calls import PinocchioCalls
from .result import Chapter, Comparison
from .timing import Contestant, race

__all__ = ["matrices"]

_MOST = 20_000  # states: their regressors are 58 MB

#: Pinocchio's name, our function, the kernel's method, their arguments.
_QUANTITIES: dict[str, tuple[str, Callable[..., Any], str, tuple[str, ...]]] = {
    "mass matrix": ("pin.crba", equations.mass_matrix, "mass_matrix", ("q",)),
    "Coriolis matrix": (
        "pin.computeCoriolisMatrix",
        equations.coriolis_matrix,
        "coriolis_matrix",
        ("q", "qd"),
    ),
    "gravity torque": (
        "pin.computeGeneralizedGravity",
        equations.gravity_torque,
        "gravity_torque",
        ("q",),
    ),
    "torque regressor": (
        "pin.computeJointTorqueRegressor",
        regressor.torque_regressor,
        "torque_regressor",
        ("q", "qd", "qdd"),
    ),
}


def matrices(arm: SerialArm, states: States, rounds: int) -> Chapter:
    """One comparison per quantity, on one thread."""
    few = States(*(part[:_MOST] for part in (states.q, states.qd, states.qdd)))
    calls = PinocchioCalls(arm, few, 1)
    return Chapter(
        "matrices",
        "Matrices",
        "state",
        f"{len(few.q):,} states, one thread. Our Coriolis matrix is that of Christoffel symbols, "
        "whichever Pinocchio's is.",
        tuple(_compared(arm, calls, name, rounds) for name in _QUANTITIES),
    )


def _compared(arm: SerialArm, calls: PinocchioCalls, name: str, rounds: int) -> Comparison:
    algorithm, function, method, arguments = _QUANTITIES[name]
    given = [getattr(calls.states, argument) for argument in arguments]
    count = len(given[0])
    loop = Contestant(f"Python loop over {algorithm}", calls.loop(algorithm, count), count)
    ours = Contestant(f"ur5check.{method}", lambda: function(arm, *given), count)
    made = [(NUMPY, kernel.compile(arm, path="numpy"))]
    if kernel.default_path() == "llvm":
        made.append((LLVM, kernel.compile(arm, path="llvm")))
    generated = [
        Contestant(with_threads(title, 1), _filled(compiled, method, given), count)
        for title, compiled in made
    ]
    return race(name, [loop, ours, *generated], rounds)


def _filled(compiled: kernel.Kernel, method: str, given: list[Any]) -> Callable[[], Any]:
    """Into an existing array."""
    ask = getattr(compiled, method)
    out = np.empty_like(ask(*given))
    return lambda: ask(*given, out=out)
