"""`ur5check.compare_engines`: do all engines mean the same robot?

Every engine is given the same arm, by its own reader, and asked the same questions at the same
states.  Where one has read it otherwise (its known known issues say how) it is given the arm again
with the fixes for those known issues, and asked again.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from numpy.typing import ArrayLike

from ..._dynamics.batching import gravity_of
from ..._dynamics.recursion import rnea
from ..._io.loading import ArmSource, load
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States, random_states
from ..._robot.transforms import Array
from ..known_issues import repaired
from ..registry import REGISTRY, engine_class, installed
from .agreement_matrix import Matrix, matrix_of
from .engine_reading import Reading, asked, read_by
from .worst_import_state import join_states, worst_state

__all__ = ["SAME_ROBOT", "SAMPLES", "EngineReport", "Stage", "compare_engines", "engine_keys"]

#: Engines that agree within this hold the same robot [N m].  Rounding alone parts them by 1e-13 on
#: an arm of a few hundred newton metres, and no decimal in a file makes a difference this small.
SAME_ROBOT = 1e-10
#: States enough to see any difference: each is a different mixture of all parameters.
SAMPLES = 200


@dataclass(frozen=True, eq=False)
class Stage:
    """All engines with one text each: as read, or with their fixes.

    readings : one an engine, our own first;  matrix : of those that took the model
    """

    readings: tuple[Reading, ...]
    matrix: Matrix

    @property
    def refusals(self) -> tuple[Reading, ...]:
        """Engines that would not take the model."""
        return tuple(reading for reading in self.readings if reading.refused is not None)

    @property
    def unexplained(self) -> tuple[Reading, ...]:
        """Engines that do not compute what they hold."""
        return tuple(r for r in self.readings if r.belief is not None and not r.belief.explained)

    def agrees(self, limit: float = SAME_ROBOT) -> bool:
        """Whether every engine took the model and no torque of any pair differs by more [N m]."""
        return not self.refusals and self.matrix.worst <= limit

    def reading(self, key: str) -> Reading:
        """That of one engine."""
        return next(reading for reading in self.readings if reading.key == key)


@dataclass(frozen=True, eq=False)
class EngineReport:
    """What `compare_engines` found.

    gravity : told to all engines, in the arm's base frame [m/s²]
    states : `samples` drawn from `seed`, and behind them the worst state of each engine that holds
        another arm
    as_read : every engine with the model as it is
    repaired : with the fixes for its known issues; None where none was wanted
    absent : keys of engines that are known and not installed
    """

    arm: SerialArm
    gravity: Array
    states: States
    samples: int
    seed: int
    as_read: Stage
    repaired: Stage | None
    absent: tuple[str, ...]

    @property
    def final(self) -> Stage:
        """The stage with fixes, if there is one."""
        return self.as_read if self.repaired is None else self.repaired

    def stages(self) -> list[tuple[Literal["as read", "repaired"], Stage]]:
        """Those there are, by name."""
        both: list[tuple[Literal["as read", "repaired"], Stage]] = [("as read", self.as_read)]
        return both if self.repaired is None else [*both, ("repaired", self.repaired)]

    @property
    def explained(self) -> bool:
        """Whether every engine computes what it holds: then the audit is the whole account."""
        return not any(stage.unexplained for _, stage in self.stages())


def compare_engines(
    model: ArmSource = "appendix",
    *,
    engines: Sequence[str] | None = None,
    samples: int = SAMPLES,
    seed: int = 0,
    gravity: ArrayLike | None = None,
    repairs: bool = True,
    progress: Callable[[str], None] | None = None,
) -> EngineReport:
    """Give one arm to several engines and hold what they read, and what they answer, together.

    Parameters
    ----------
    model : a list of mistakes name, a path, a `pin.Model` or a `SerialArm` (see `load`)
    engines : keys of `_engines.registry.REGISTRY`; all that are installed when None.  Our own
        recursion always takes part
    samples, seed : how many random states, drawn from which seed (see `random_states`)
    gravity : told to all, in the arm's base frame, shape (3,) [m/s²]; the arm's own when None
    fixes : whether engines that hold another arm are asked again with their known issues' fixes
    progress : called with a line before each longer step

    Raises
    ------
    InputError : a model that cannot be read; a name that is no engine's.
    EngineError : an engine that was named and is not installed.
    """
    say = progress or (lambda line: None)
    arm = load(model)
    keys = engine_keys(engines)
    g = gravity_of(arm, gravity)
    drawn = random_states(arm.n, samples, seed)
    readings = []
    for key in keys:
        say(f"{REGISTRY[key].title} reads {arm.name}")
        readings.append(read_by(key, arm, arm, g))
    worst = [
        worst_state(arm.with_gravity(g), reading.imported.imported_arm.with_gravity(g), seed)
        for reading in readings
        if reading.imported is not None and reading.imported.harmful
    ]
    states = join_states(drawn, *worst)
    say(f"asking them at {len(states):,} states")
    as_read = _stage(readings, states, arm, g)
    repaired = None
    if repairs and any(r.harmful or r.refused for r in as_read.readings):
        say("asking again with the fixes")
        repaired = _stage([_repaired(r, arm, g) for r in as_read.readings], states, arm, g)
    here = installed()
    absent = tuple(key for key in REGISTRY if key not in here)
    return EngineReport(arm, g, states, samples, seed, as_read, repaired, absent)


def engine_keys(named: Sequence[str] | None) -> tuple[str, ...]:
    """Our own side, then those named (all that are installed when None), each once.

    Raises UsageError for an unknown key, EngineError for an engine that is not installed.
    """
    if named is None:
        return installed()
    for key in named:
        engine_class(key)
    return tuple(key for key in REGISTRY if key == "own" or key in named)


def _stage(readings: Sequence[Reading], states: States, arm: SerialArm, gravity: Array) -> Stage:
    tau = rnea(arm, states.q, states.qd, states.qdd, gravity)
    answered = tuple(asked(reading, states, tau, gravity) for reading in readings)
    return Stage(answered, matrix_of([r.answers for r in answered if r.answers is not None]))


def _repaired(reading: Reading, arm: SerialArm, gravity: Array) -> Reading:
    """The engine with the fixes for its known issues, if it needs them and has any."""
    given = repaired(arm, reading.key)
    if given is arm or not (reading.harmful or reading.refused):
        return reading
    return read_by(reading.key, given, arm, gravity)
