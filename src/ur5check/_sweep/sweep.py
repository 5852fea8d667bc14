"""`ur5check.sweep`: the torque difference of two arms at any number of states, in constant memory.

    states of block k → Δτ → statistics ─┐
    states of block l → Δτ → statistics ─┴→ one statistics → Sweep

No digit of the result depends on which process computes a block, or in which order.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from os import PathLike
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from .._arguments import callback, instance, integer, number
from .._comparison.arm_pair import Pair, pair_up
from .._comparison.difference import under_gravity
from .._comparison.worst_case.state_box import StateBox, state_box
from .._dynamics.recursion import rnea
from .._errors import UsageError
from .._io.loading import ArmSource, load
from .._robot.states import MAX_ACCELERATION, MAX_ANGLE, MAX_RATE
from .._robot.transforms import Array
from .checkpoint import load as load_checkpoint
from .executor import Executor
from .executor import threads as thread_executor
from .progress import SweepProgress
from .sobol_sample import SobolSample
from .state_log import is_log, log_sample
from .state_sample import GridSample, RandomSample, Sample
from .statistics import Statistics
from .sweep_plan import Plan, plan_of
from .sweep_result import Sweep

__all__ = ["SampleKind", "run", "sweep"]

SampleKind = Literal["random", "sobol", "grid"]

_STATES = 1_000_000


def sweep(
    a: ArmSource,
    b: ArmSource,
    *,
    states: int | None = None,
    sample: SampleKind | str | PathLike[str] = "random",
    seed: int = 0,
    within_limits: bool = False,
    tolerance: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    threads: int = 1,
    batch: int | None = None,
    scheduler: str | None = None,
    checkpoint: str | PathLike[str] | None = None,
    checkpoint_every: float = 30.0,
    progress: Callable[[str], None] | None = None,
) -> Sweep:
    """Torque difference of two arms over a large number of states, in constant memory.

    No digit of the result depends on `threads`, `batch`, `scheduler` or `checkpoint`.

    Parameters
    ----------
    a, b : name, path, pin.Model or SerialArm
        See `load`.
    states : int, optional
        Their number, 1e6 when None; a grid is the largest with no more; not for a log.
    sample : {"random", "sobol", "grid"} or path
        A grid is one of postures at rest; a path is a .csv or .parquet log of a's joints.
    seed : int
        Of random and Sobol states.
    within_limits : bool
        Draw positions and velocities within the joint limits (a's, else b's, else the default
        bounds); otherwise |q| ≤ π rad, |q̇| ≤ 3.2 rad/s; always |q̈| ≤ 10 rad/s².
    tolerance : float or array-like, shape (n,), optional
        Of |Δτ| [N m]: the share of the states above it is reported.
    gravity : array-like, shape (3,), optional
        In each arm's base frame [m/s²]; each arm's own when None.
    threads : int
        Of this process, without a scheduler.
    batch : int, optional
        Blocks of 16,384 states per task of a thread or worker; chosen when None.
    scheduler : str, optional
        Address of a Dask scheduler ("tcp://…:8786"), whose workers compute the blocks.
    checkpoint : path, optional
        File for intermediate results; the sweep resumes from it if it exists.
    checkpoint_every : float
        Time between two checkpoints [s].
    progress : callable, optional
        Called with a sentence about the progress.

    Returns
    -------
    Sweep

    Raises
    ------
    InputError
        For a model or log that cannot be read, arms that cannot be compared, an invalid argument,
        or a checkpoint of another sweep.

    Examples
    --------
    >>> import ur5check
    >>> result = ur5check.sweep("appendix", "erd-ur5", states=1000)
    >>> result.count, result.agrees
    (1000, False)
    """
    threads = integer("threads", threads, least=1)
    batch = None if batch is None else integer("batch", batch, least=1)
    checkpoint_every = number("checkpoint_every", checkpoint_every)
    for name, path in (("sample", sample), ("checkpoint", checkpoint)):
        if path is not None and not isinstance(path, str | PathLike):
            raise UsageError(f"{name} must be a name or a path, not {path!r:.80}")
    if scheduler is not None:
        instance("scheduler", scheduler, str, "give its address, tcp://…:8786")
    pair = pair_up(*(under_gravity(load(source), gravity) for source in (a, b)))
    plan = plan_of(pair, _sample(pair, states, sample, seed, within_limits), tolerance)
    return Sweep(
        pair,
        plan,
        run(
            plan,
            _executor(threads, scheduler, batch),
            None if checkpoint is None else Path(checkpoint),
            checkpoint_every,
            callback("progress", progress),
        ),
        *_scale(plan),
    )


def run(
    plan: Plan,
    executor: Executor,
    checkpoint: Path | None,
    checkpoint_every: float,
    progress: Callable[[str], None],
) -> Statistics:
    """The statistics of all blocks of a plan, resumed from the checkpoint if it exists."""
    done = None if checkpoint is None else load_checkpoint(checkpoint, plan)
    sweep_progress = SweepProgress(plan, checkpoint, checkpoint_every, done, progress)
    # Closed before the progress, so that no thread works while the checkpoint is saved.
    with sweep_progress, closing(executor(plan, sweep_progress.blocks)) as parts:
        for statistics in parts:
            sweep_progress.add(statistics)
    return sweep_progress.statistics


def _executor(count: int, scheduler: str | None, batch: int | None) -> Executor:
    if scheduler is None:
        return thread_executor(count, batch)
    from .dask_cluster import cluster

    return cluster(scheduler, batch)


def _sample(
    pair: Pair, states: int | None, kind: str | PathLike[str], seed: int, within_limits: bool
) -> Sample:
    """Raises UsageError, or StateError for a log."""
    if is_log(kind):
        if within_limits or states is not None:
            raise UsageError("states and within-limits do not apply to a log")
        return log_sample(Path(kind), pair.a)
    if states is None:
        states = _STATES
    states, seed = integer("states", states, least=1), integer("seed", seed, least=0)
    if seed >= 2**64:
        raise UsageError(f"the seed must be from 0 to 2⁶⁴ − 1, not {seed}")
    box = state_box(pair, MAX_ACCELERATION) if within_limits else _free_box(pair.a.n)
    match kind:
        case "random":
            return RandomSample(box, states, seed)
        case "sobol":
            return SobolSample(box, states, seed)
        case "grid":
            return GridSample(box, _levels(states, pair.a.n))
    raise UsageError(f"sample {kind}: must be random, sobol, grid, or a .csv or .parquet file")


def _free_box(n: int) -> StateBox:
    """The box of `_robot.states.random_states`, without joint limits."""
    angle, rate, acceleration = (
        np.full(n, bound) for bound in (MAX_ANGLE, MAX_RATE, MAX_ACCELERATION)
    )
    return StateBox(-angle, angle, rate, acceleration)


def _levels(states: int, n: int) -> int:
    """The levels per axis of the finest grid of n axes with at most so many points."""
    levels = round(states ** (1.0 / n))  # may be one too many, never two
    return int(levels if levels**n <= states else levels - 1)


def _scale(plan: Plan) -> tuple[Array, Array]:
    """RMS and maximum of τ_a over the first block, shape (n,) each."""
    first = plan.sample.block(0)
    tau = rnea(plan.a, first.q, first.qd, first.qdd)
    return np.sqrt((tau**2).mean(axis=0)), np.abs(tau).max(axis=0)
