"""Convergence of the engines' motions: they must agree in the limit of step zero.

Each integrator computes the same motion with steps that are halved repeatedly.  Its error against a
reference of our own (DOP853 at the tightest tolerance) must fall with the step at the integrator's
order p.  The final positions have an expansion in the step,

    q(h) = q(0) + c_p hᵖ + c_{p+1} hᵖ⁺¹ + …

whose terms Richardson's extrapolation removes one after the other (Hairer et al. 1993, II.9).  The
limit depends on the engine's *equations of motion* only, not on its integrator.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._arguments import callback, names, number, number_array
from .._dynamics.batching import joint_array
from .._robot.as_arm import ArmSource, as_arm
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array, frozen
from .free_motion import Progress, integrated, no_progress, stepped
from .integration import REFERENCE
from .require_same_model import checked_stepper
from .torque_sources import ConstantTorque

__all__ = ["HALVINGS", "OWN_HALVINGS", "Convergence", "Refinement", "convergence", "extrapolated"]

#: Steps of an engine: 2⁻⁷ … 2⁻¹³ s, from 8 ms down to an eighth of a millisecond.
HALVINGS = range(7, 14)
#: Our own integrator is of order 8: it meets rounding with a few hundred steps a second.
OWN_HALVINGS = range(6, 10)


@dataclass(frozen=True, eq=False)
class Refinement:
    """One integrator with ever smaller steps.

    order : as its authors state it
    dt : shape (L,) [s], each half of the one before
    q : final positions, shape (L, n) [rad]
    error : largest joint error against the reference, shape (L,) [rad]
    limit : q extrapolated to step zero, shape (n,) [rad]
    limit_error : largest joint error of the limit against the reference [rad]
    """

    engine: str
    integrator: str
    order: int
    dt: Array
    q: Array
    error: Array
    limit: Array
    limit_error: float

    @property
    def measured_order(self) -> Array:
        """log₂ of the error ratio of each halving, shape (L − 1,)."""
        return np.asarray(np.log2(self.error[:-1] / self.error[1:]))

    @property
    def overall_order(self) -> float:
        """The same from the first step to the last, per halving."""
        return float(np.log2(self.error[0] / self.error[-1]) / (len(self.error) - 1))


@dataclass(frozen=True, eq=False)
class Convergence:
    """One motion by every integrator.

    Attributes
    ----------
    arm : SerialArm
    seconds : float
        Duration of the motion [s].
    turned : float
        Largest rotation of a joint [rad].
    reference_error : float
        Of the reference, from one at a looser tolerance [rad].
    refinements : tuple of Refinement
        One per integrator.
    """

    arm: SerialArm
    seconds: float
    turned: float
    reference_error: float
    refinements: tuple[Refinement, ...]

    @property
    def apart(self) -> float:
        """Largest distance between any two limits, or a limit and the reference [rad]."""
        limits = np.array([refinement.limit for refinement in self.refinements])
        spread = np.ptp(limits, axis=0).max()
        return float(max(spread, *(r.limit_error for r in self.refinements)))


def convergence(
    arm: ArmSource,
    q: ArrayLike,
    tau: ArrayLike,
    *,
    seconds: float = 1.0,
    engines: Sequence[str] = ("mujoco", "dart"),
    halvings: Sequence[int] = HALVINGS,
    own_halvings: Sequence[int] = OWN_HALVINGS,
    progress: Progress = no_progress,
) -> Convergence:
    """The motion of an arm from rest under constant torques, by every integrator.

    Each integrator computes it with steps that are halved repeatedly.  Constant torques keep the
    equations smooth: a torque that is recomputed once per step would add an error of first order.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    q, tau : array-like, shape (n,)
        Initial position [rad] and constant torques [N m].
    seconds : float
        Duration [s], positive.
    engines : sequence of str
        Keys of engines that can step (`steppers`).
    halvings, own_halvings : sequence of int
        k for steps of seconds · 2⁻ᵏ, of the engines and of our own integrator, which is left out
        if empty.
    progress : callable, optional
        Called with a line before each integrator.

    Returns
    -------
    Convergence

    Raises
    ------
    InputError
        For an arm that cannot be read, or an invalid argument.
    EngineError
        For an engine that is not installed, or that would simulate another arm.

    References
    ----------
    Hairer et al. 1993, II.9.

    Examples
    --------
    >>> import ur5check
    >>> result = ur5check.convergence(
    ...     "paper", [0.0] * 6, [0.0] * 6, seconds=0.1, engines=(), own_halvings=(2, 3)
    ... )
    >>> result.apart < 1e-8
    True
    """
    arm, progress = as_arm(arm), callback("progress", progress)
    seconds = number("seconds", seconds, positive=True)
    engines = names("engines", engines)
    start = frozen(joint_array(arm, "q", number_array("q", q)), (arm.n,), "q")
    torque = ConstantTorque(
        frozen(joint_array(arm, "tau", number_array("tau", tau)), (arm.n,), "tau")
    )
    rest, ends = np.zeros(arm.n), np.array([0.0, seconds])
    progress("the reference: DOP853 at its tightest tolerance")
    reference = integrated(arm, torque, start, rest, ends, precision=REFERENCE).q[-1]
    looser = integrated(arm, torque, start, rest, ends).q[-1]

    def engine_ends() -> Iterator[tuple[str, str, int, Array, list[Array]]]:
        if own_halvings:
            progress("our own integrator with fixed steps")
            dt = seconds * 2.0 ** -np.array(own_halvings, dtype=np.float64)
            last = [integrated(arm, torque, start, rest, ends, step=h).q[-1] for h in dt]
            yield "ur5check", "DOP853", 8, dt, last
        dt = seconds * 2.0 ** -np.array(halvings, dtype=np.float64)
        for key in engines:
            engine = checked_stepper(key, arm).engine
            for name, order in engine.integrators.items():
                progress(f"{engine.name}, {name}")
                last = [
                    stepped(
                        engine, torque, start, rest,
                        dt=h, steps=2**k, integrator=name, every=2**k,
                    ).q[-1]
                    for h, k in zip(dt, halvings, strict=True)
                ]  # fmt: skip
                yield engine.name, name, order, dt, last

    refinements = tuple(
        _refinement(engine, name, order, dt, np.array(last), reference)
        for engine, name, order, dt, last in engine_ends()
    )
    return Convergence(
        arm,
        seconds,
        float(np.abs(reference - start).max()),
        float(np.abs(reference - looser).max()),
        refinements,
    )


def extrapolated(q: Array, order: int) -> Array:
    """The limit for step zero of q(h), shape (L, n), each row of half the step of the one before.

    order : p of the first term of the expansion; each column removes one more term.
    """
    column = np.asarray(q)
    for p in range(order, order + len(q) - 1):
        column = column[1:] + (column[1:] - column[:-1]) / (2.0**p - 1.0)
    return np.asarray(column[-1])


def _refinement(
    engine: str, integrator: str, order: int, dt: Array, q: Array, reference: Array
) -> Refinement:
    limit = extrapolated(q, order)
    return Refinement(
        engine,
        integrator,
        order,
        dt,
        q,
        np.abs(q - reference).max(axis=1),
        limit,
        float(np.abs(limit - reference).max()),
    )
