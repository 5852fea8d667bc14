"""Our own integrator: SciPy's DOP853, with the tolerances of the house said here and nowhere else.

Dormand and Prince's pair of order 8 (Hairer et al. 1993, II.5) suits an arm without contact: its
equations are smooth, so a high order pays, and the step adapts to how fast the arm swings.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .._errors import UsageError
from .._robot.transforms import Array

__all__ = ["REFERENCE", "WORKING", "Precision", "Rate", "Stop", "integrate"]

#: dy/dt of a state y at a time t [s].
Rate = Callable[[float, Array], Array]
#: A function of (t, y) that crosses zero where integration has to end.
Stop = Callable[[float, Array], float]


@dataclass(frozen=True)
class Precision:
    """How large an error a step may make: rtol · |y| + atol, entry by entry."""

    rtol: float
    atol: float


#: For answers that are shown: the error of a swing of seconds stays far below a micrometre.
WORKING = Precision(rtol=1e-9, atol=1e-11)
#: For judging other integrators: as close to rounding as steps of double precision come.
REFERENCE = Precision(rtol=1e-12, atol=1e-14)

_ANYTHING = 1e9  # a tolerance that no step of an arm exceeds


def integrate(
    rate: Rate,
    start: Array,
    times: Array,
    *,
    precision: Precision = WORKING,
    step: float | None = None,
    stop: Stop | None = None,
) -> tuple[Array, Array]:
    """The instants reached, shape (K,) [s], and the states there, shape (K, N).

    times : instants to keep, from start to end
    step : fixed steps of this length [s], whatever error they make: to see the order at work
    stop : integration ends where this crosses zero; that instant then is the last, in place of the
        times after it

    Raises UsageError if the step shrinks to nothing: a state that runs away within finite time.
    """
    from scipy.integrate import solve_ivp

    steps = {"rtol": precision.rtol, "atol": precision.atol}
    if step is not None:
        steps = {"rtol": _ANYTHING, "atol": _ANYTHING, "first_step": step, "max_step": step}
    events = None
    if stop is not None:

        def ended(t: float, y: Array) -> float:
            return stop(t, y)

        ended.terminal = True  # type: ignore[attr-defined]  # how SciPy wants to be told
        events = [ended]
    # A state that overflows on its way out is caught below, by the solver's own verdict.
    with np.errstate(over="ignore", invalid="ignore"):
        solution = solve_ivp(
            rate,
            (float(times[0]), float(times[-1])),
            start,
            method="DOP853",
            t_eval=times,
            events=events,
            **steps,
        )
    if not solution.success:
        raise UsageError(
            f"the motion runs away before {times[-1]:g} s "
            f"({solution.message.lower().rstrip('.')}); simulate a shorter time"
        )
    t, y = np.asarray(solution.t), np.asarray(solution.y.T)
    if solution.status == 1:  # stopped
        t = np.append(t, solution.t_events[0])
        y = np.vstack([y, solution.y_events[0]])
    return t, y
