"""Motion from a given state: our equations of motion under DOP853, or an engine's own steps.

Both return a `Motion`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .._dynamics.equations import acceleration_of
from .._engines.engine import Stepper
from .._errors import EngineError
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .integration import WORKING, Precision, integrate
from .joint_range import JointRange
from .motion_result import Motion
from .torque_sources import TorqueSource

__all__ = ["Progress", "integrated", "no_progress", "stepped"]

#: Receives a line of progress.
Progress = Callable[[str], None]


def no_progress(line: str) -> None:
    """Ignore the line."""


def integrated(
    arm: SerialArm,
    torque: TorqueSource,
    q: Array,
    qd: Array,
    times: Array,
    *,
    joint_range: JointRange | None = None,
    precision: Precision = WORKING,
    step: float | None = None,
    progress: Progress = no_progress,
) -> Motion:
    """The motion by our own dynamics; torques follow the state continuously.

    q, qd : the initial state, shape (n,) [rad], [rad/s];  times : shape (K,) [s], from 0
    joint_range : the motion ends where a joint leaves it
    step : fixed steps of this length [s] instead of a precision

    The work is integrated beside the state, dW/dt = τ · q̇.  Raises as `integrate` does.
    """
    n, accelerate = arm.n, acceleration_of(arm)
    reached = _Clock(float(times[-1]), progress)

    def rate(t: float, y: Array) -> Array:
        reached(t)
        q, qd = y[:n], y[n : 2 * n]
        tau = torque(q, qd)
        return np.concatenate([qd, accelerate(q, qd, tau), [tau @ qd]])

    stop = None if joint_range is None else lambda t, y: joint_range.margin(y[:n])
    start = np.concatenate([q, qd, [0.0]])
    t, y = integrate(rate, start, times, precision=precision, step=step, stop=stop)
    q_t, qd_t = y[:, :n], y[:, n : 2 * n]
    tau_t = np.array([torque(*state) for state in zip(q_t, qd_t, strict=True)])
    return Motion(t, q_t, qd_t, tau_t, y[:, 2 * n], stopped=bool(t[-1] < times[-1]))


def stepped(
    engine: Stepper,
    torque: TorqueSource,
    q: Array,
    qd: Array,
    *,
    dt: float,
    steps: int,
    integrator: str | None = None,
    every: int = 1,
    joint_range: JointRange | None = None,
    progress: Progress = no_progress,
) -> Motion:
    """The motion by an engine's own integrator; the torque is constant during each step.

    dt : the step [s];  every : number of steps between the instants that are kept
    integrator : one of `engine.integrators`, the engine's default when None
    joint_range : the motion ends with the step in which a joint leaves it

    A torque that is constant over a step does the work τ · Δq, exactly.  Raises EngineError if the
    engine's state is no longer finite.
    """
    reached = _Clock(steps * dt, progress)
    work, kept = 0.0, []
    for k in range(steps + 1):
        tau = torque(q, qd)
        stopped = joint_range is not None and joint_range.margin(q) < 0.0
        if k % every == 0 or k == steps or stopped:
            kept.append((k * dt, q, qd, tau, work))
        if k == steps or stopped:
            break
        reached(k * dt)
        q_next, qd_next = engine.step(q, qd, tau, dt, integrator)
        if not (np.isfinite(q_next).all() and np.isfinite(qd_next).all()):
            raise EngineError(
                f"{engine.name} diverged after {k * dt:.4g} s: its state is no longer finite; "
                "take a smaller step"
            )
        work += float(tau @ (q_next - q))
        q, qd = q_next, qd_next
    t, q_t, qd_t, tau_t, work_t = (np.array(column) for column in zip(*kept, strict=True))
    return Motion(t, q_t, qd_t, tau_t, work_t, stopped)


class _Clock:
    """Reports every tenth of the simulated time, once."""

    def __init__(self, end: float, progress: Progress) -> None:
        self._end, self._progress, self._reported = end, progress, 0

    def __call__(self, t: float) -> None:
        tenth = int(10.0 * t / self._end)
        if tenth > self._reported:
            self._reported = tenth
            self._progress(f"{t:.2f} of {self._end:g} s")
