"""The paper's test 9: apply the torques that hold the arm according to a model.

If the model is right, the arm stands; if it is not, it moves.  Torques are constant, as the paper
published them to Gazebo, or recomputed for the posture of every instant.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from .._arguments import callback, number, number_array
from .._comparison.arm_pair import Pair, pair_up
from .._dynamics.batching import joint_array
from .._dynamics.equations import gravity_torque
from .._dynamics.kinematics import forward_kinematics
from .._engines.registry import REFERENCE, steppers
from .._errors import UsageError
from .._result import Result
from .._robot.as_arm import ArmSource, as_arm
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .._version import __version__
from .equilibrium import growth_rate
from .free_motion import Progress, integrated, no_progress, stepped
from .integration import WORKING
from .joint_range import joint_range_of
from .motion_result import EnergyBalance, Motion, energy_balance
from .require_same_model import checked_stepper
from .torque_sources import ConstantTorque, GravityCompensation, TorqueSource

__all__ = ["ENGINES", "STILL", "Mover", "StaticHold", "stand"]

#: The repeatability of a UR5 by its data sheet [m]: a tool that moves less stands as still as the
#: real arm can show.
STILL = 1e-4

#: Keys of the engines that can move the arm; our own integrator first.
ENGINES = steppers()

#: An alignment that leaves more than this of the torques is no evidence that the two count their
#: joints differently: a lost sign in a length has the same axes as a reversed joint.
_ANOTHER_ARM = 0.5


_KEPT = 5_000  # instants of a motion: every millisecond of five seconds
_MOST_STEPS = 10_000_000  # minutes of work


@dataclass(frozen=True)
class Mover:
    """The engine that moved the arm.

    integrator : by name;  dt : its step [s], None where the step adapts
    repaired : what the engine would have imported otherwise from the file as it is, in words
    """

    name: str
    version: str
    integrator: str
    dt: float | None
    repaired: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False, repr=False)
class StaticHold(Result):
    """The result of the paper's test 9: does the arm stand under the torques of a model?

    Attributes
    ----------
    pair : Pair
        `a` the plant, `b` the model whose torques were applied, in the plant's coordinates.
    mover : Mover
        The engine that moved the arm, and its integrator.
    held : bool
        Whether the torques were constant, otherwise recomputed.
    seconds : float
        The duration asked for [s].
    motion : Motion
        Of the plant at K instants, up to `seconds` or to a joint's limit.
    needed : ndarray, shape (n,)
        g(q) of the plant at the start [N m].
    tool_drift : ndarray, shape (K,)
        Distance of the tool from its start [m].
    growth : float
        How fast a small deviation grows under constant torques [1/s].
    energy : EnergyBalance
        Of the plant.
    """

    pair: Pair
    mover: Mover
    held: bool
    seconds: float
    motion: Motion
    needed: Array
    tool_drift: Array
    growth: float
    energy: EnergyBalance

    @property
    def given(self) -> Array:
        """The torques at the start, shape (n,) [N m]."""
        return np.asarray(self.motion.tau[0])

    @property
    def joint_drift(self) -> Array:
        """Distance of each joint from its start, shape (K, n) [rad]."""
        return np.asarray(self.motion.q - self.motion.q[0])

    @property
    def still_angle(self) -> float:
        """The angle that moves the tool of the stretched arm by STILL [rad].

        Where the tool lies on every axis, the angle that moves the links' centres of mass so far.
        """
        links = self.pair.a.links
        length = sum(float(np.linalg.norm(link.link_tip_frame.p)) for link in links)
        if length == 0.0:
            length = sum(float(np.linalg.norm(link.inertia.com)) for link in links)
        return STILL / length if length > 0.0 else STILL

    @property
    def left_after(self) -> float | None:
        """The first instant at which the arm has visibly moved [s]; None if it stands."""
        angle = np.abs(self.joint_drift).max(axis=1)
        away = np.flatnonzero((self.tool_drift > STILL) | (angle > self.still_angle))
        return float(self.motion.t[away[0]]) if len(away) else None

    @property
    def tool_left_after(self) -> float | None:
        """The instant at which the tool has moved by STILL [s]; None if it never does.

        Between instants the displacement is taken as quadratic in time, as from rest.
        """
        away = np.flatnonzero(self.tool_drift > STILL)
        if not len(away):
            return None
        until = slice(away[0] - 1, away[0] + 1)
        root = np.sqrt(self.tool_drift[until])
        return float(np.interp(np.sqrt(STILL), root, self.motion.t[until]))

    @property
    def stands(self) -> bool:
        """Whether neither the tool nor a joint moved visibly."""
        return self.left_after is None


def stand(
    plant: ArmSource,
    model: ArmSource,
    q: ArrayLike,
    *,
    engine: str = REFERENCE,
    held: bool = True,
    seconds: float = 5.0,
    dt: float = 1e-3,
    integrator: str | None = None,
    progress: Progress = no_progress,
) -> StaticHold:
    """Apply the torques that hold `model` at `q` to `plant`, and simulate its motion.

    Parameters
    ----------
    plant : name, path, pin.Model or SerialArm
        The arm that moves (see `load`).
    model : name, path, pin.Model or SerialArm
        The arm whose torques are applied; its joint angles and base are mapped to the plant's as
        `pair_up` finds them, or taken as written if that leaves torques as different as those of
        two arms.
    q : array-like, shape (n,)
        The plant's posture at the start, at rest [rad].
    engine : str
        "ur5check" or one of `steppers()`.
    held : bool
        Whether the torques stay those of the start, otherwise g(q) of the model at each step.
    seconds : float
        Simulated time [s], positive.
    dt : float
        Step of an engine [s]; our own integrator adapts its steps.
    integrator : str, optional
        Of an engine; its default when None.
    progress : callable, optional
        Called with a line every tenth of the simulated time.

    Returns
    -------
    StaticHold

    Raises
    ------
    InputError
        For an arm that cannot be read, an option without meaning, a posture beyond a joint limit,
        or a `q` of the wrong length.
    EngineError
        For an engine that is not installed, or that would simulate another arm.

    References
    ----------
    Paper, test 9.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.static_hold("appendix", "appendix", [0.0] * 6, seconds=0.1).stands
    True
    """
    plant, model, progress = as_arm(plant), as_arm(model), callback("progress", progress)
    seconds, dt = number("seconds", seconds), number("dt", dt)
    pair = pair_up(plant, model)
    if pair.alignment.relative_difference > _ANOTHER_ARM:
        pair = pair_up(plant, model, as_written=True)
    if _is_same_model(plant, model):  # under its own torques: nothing to tell apart
        a, b, given_b = (
            replace(arm, given_label=plant.label) for arm in (pair.a, pair.b, pair.given_b)
        )
        pair = replace(pair, a=a, b=b, given_b=given_b)
    q_0 = joint_array(plant, "q", number_array("q", q)).astype(np.float64)
    if q_0.ndim != 1:
        raise UsageError(f"one posture is simulated at a time, not an array of shape {q_0.shape}")
    _refuse_times(seconds, dt)
    joint_range = joint_range_of(plant, q_0)
    torque: TorqueSource = (
        ConstantTorque(gravity_torque(pair.b, q_0)) if held else GravityCompensation(pair.b)
    )
    rest, steps = np.zeros(plant.n), round(seconds / dt)
    if engine == REFERENCE:
        if integrator is not None:
            raise UsageError(
                f"--integrator is for other engines than {REFERENCE}, whose own is DOP853 with "
                "adaptive steps; leave it out"
            )
        mover = Mover("ur5check", __version__, f"DOP853, rtol {WORKING.rtol:g}", None)
        times = np.linspace(0.0, seconds, min(steps, _KEPT) + 1)
        motion = integrated(
            plant, torque, q_0, rest, times, joint_range=joint_range, progress=progress
        )
    else:
        checked = checked_stepper(engine, plant)
        stepper = checked.engine
        chosen = integrator or next(iter(stepper.integrators))
        if chosen not in stepper.integrators:
            known = ", ".join(stepper.integrators)
            raise UsageError(f"{stepper.name} has no integrator {chosen!r}; choose from {known}")
        mover = Mover(stepper.name, stepper.version, chosen, dt, checked.repaired)
        motion = stepped(
            stepper, torque, q_0, rest,
            dt=dt, steps=steps, integrator=chosen,
            every=max(1, steps // _KEPT), joint_range=joint_range, progress=progress,
        )  # fmt: skip
    tool = forward_kinematics(plant, motion.q)[:, :3, 3]
    return StaticHold(
        pair,
        mover,
        held,
        seconds,
        motion,
        gravity_torque(plant, q_0),
        np.linalg.norm(tool - tool[0], axis=1),
        growth_rate(plant, q_0),
        energy_balance(plant, motion),
    )


def _is_same_model(a: SerialArm, b: SerialArm) -> bool:
    same_file = bool(a.source.inputs) and a.source.inputs == b.source.inputs
    return a is b or (same_file and np.array_equal(a.parameters(), b.parameters()))


def _refuse_times(seconds: float, dt: float) -> None:
    for name, value in (("seconds", seconds), ("step", dt)):
        if not (np.isfinite(value) and value > 0.0):
            raise UsageError(f"--{name} must be a positive number of seconds, not {value:g}")
    if dt > seconds:
        raise UsageError(f"a step of {dt:g} s does not fit into {seconds:g} s; take a smaller one")
    if seconds / dt > _MOST_STEPS:
        raise UsageError(
            f"{seconds:g} s in steps of {dt:g} s are more than {_MOST_STEPS:,} steps; take larger "
            "ones"
        )
