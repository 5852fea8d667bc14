"""Our own integrator: SciPy's DOP853, with its tolerances.

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
    """Largest error of a step: rtol · |y| + atol, entry by entry."""

    rtol: float
    atol: float


#: For reports: over seconds of motion the error of the tool stays far below a micrometre.
WORKING = Precision(rtol=1e-9, atol=1e-11)
#: For judging other integrators: as close to rounding as double precision allows.
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
    step : fixed steps of this length [s], whatever their error: to measure the order
    stop : integration ends where this crosses zero; that instant then is the last, in place of the
        times after it

    Raises UsageError if the step shrinks to zero: the state diverges within finite time.
    """
    from scipy.integrate import solve_ivp

    steps = {"rtol": precision.rtol, "atol": precision.atol}
    if step is not None:
        steps = {"rtol": _ANYTHING, "atol": _ANYTHING, "first_step": step, "max_step": step}
    events = None
    if stop is not None:

        def ended(t: float, y: Array) -> float:
            return stop(t, y)

        ended.terminal = True  # type: ignore[attr-defined]  # SciPy's interface
        events = [ended]
    # A state that overflows is reported below, from the solver's own status.
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
            f"the motion diverges before {times[-1]:g} s "
            f"({solution.message.lower().rstrip('.')}); simulate a shorter time"
        )
    t, y = np.asarray(solution.t), np.asarray(solution.y.T)
    if solution.status == 1:  # stopped
        t = np.append(t, solution.t_events[0])
        y = np.vstack([y, solution.y_events[0]])
    return t, y
