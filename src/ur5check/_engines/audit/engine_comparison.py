"""`ur5check.compare_engines`: engine agreement for one arm, or one whole robot.

Every engine reads the same text by its own parser, and its answers are compared at the same states.
An engine that imports another arm (its known issues say why) reads it a second time with the
repairs for those known issues.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from numpy.typing import ArrayLike

from ..._arguments import callback, names
from ..._dynamics.batching import gravity_of
from ..._dynamics.recursion import rnea
from ..._finding import Finding
from ..._io.arm_or_tree import WholeSource, load_arm_or_tree
from ..._result import Result
from ..._robot.robot_tree import ArmOrTree, RobotTree
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States, random_states
from ..._robot.transforms import Array
from ..known_issues import repaired
from ..registry import REFERENCE, REGISTRY, engine_class, installed
from .agreement_matrix import AgreementMatrix, matrix_of
from .engine_findings import engine_findings
from .engine_reading import Reading, read_by, with_answers
from .worst_import_state import join_states, worst_state

__all__ = ["SAME_ROBOT", "SAMPLES", "EngineReport", "Stage", "compare_engines", "engine_keys"]

#: Engines that agree within this have imported the same robot [N m].  Rounding alone makes 1e-13 on
#: an arm of a few hundred newton metres, and no decimal in a file makes a difference this small.
SAME_ROBOT = 1e-10
#: Enough states to see any difference: each weights all parameters differently.
SAMPLES = 200


@dataclass(frozen=True, eq=False)
class Stage:
    """All engines with one text each: as read, or repaired.

    Attributes
    ----------
    readings : tuple of Reading
        One per engine, the reference first.
    matrix : AgreementMatrix
        Of those that read the model.
    """

    readings: tuple[Reading, ...]
    matrix: AgreementMatrix

    @property
    def refusals(self) -> tuple[Reading, ...]:
        """Engines that refused the model."""
        return tuple(reading for reading in self.readings if reading.refused is not None)

    @property
    def unexplained(self) -> tuple[Reading, ...]:
        """Engines whose torques are not those of the imported arm."""
        return tuple(
            r for r in self.readings if r.explanation is not None and not r.explanation.explained
        )

    def agrees(self, limit: float = SAME_ROBOT) -> bool:
        """Whether every engine read the model and no torque of any pair differs by more.

        Parameters
        ----------
        limit : float
            [N m]

        Returns
        -------
        bool
        """
        return not self.refusals and self.matrix.worst <= limit

    def reading(self, key: str) -> Reading:
        """The reading of one engine.

        Parameters
        ----------
        key : str

        Returns
        -------
        Reading
        """
        return next(reading for reading in self.readings if reading.key == key)


@dataclass(frozen=True, eq=False, repr=False)
class EngineReport(Result):
    """The result of `compare_engines`.

    Attributes
    ----------
    arm : SerialArm or RobotTree
    gravity : ndarray, shape (3,)
        Used by all engines, in the base frame [m/s²].
    states : States
        `samples` drawn from `seed`; for an arm then the worst state of each engine that imported
        another arm.
    samples, seed : int
    as_read : Stage
        Every engine with the model as it is.
    repaired : Stage or None
        With the repairs for its known issues; None where none was needed.
    absent : tuple of str
        Keys of engines that are not installed.
    """

    arm: ArmOrTree
    gravity: Array
    states: States
    samples: int
    seed: int
    as_read: Stage
    repaired: Stage | None
    absent: tuple[str, ...]

    @property
    def whole(self) -> bool:
        """Whether the model is a whole robot, not an arm."""
        return isinstance(self.arm, RobotTree)

    @property
    def mimic(self) -> tuple[str, ...]:
        """Names of the joints that follow a coordinate of another."""
        return self.arm.followers if isinstance(self.arm, RobotTree) else ()

    @property
    def final(self) -> Stage:
        """The repaired stage, if there is one."""
        return self.as_read if self.repaired is None else self.repaired

    def stages(self) -> list[tuple[Literal["as read", "repaired"], Stage]]:
        """The stages with their names.

        Returns
        -------
        list of (str, Stage)
            "as read", then "repaired" where there is one.
        """
        both: list[tuple[Literal["as read", "repaired"], Stage]] = [("as read", self.as_read)]
        return both if self.repaired is None else [*both, ("repaired", self.repaired)]

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What is wrong between the file as it is and the engines, errors first."""
        return engine_findings(
            self.arm, (reading for reading in self.as_read.readings if reading.key != REFERENCE)
        )

    @property
    def explained(self) -> bool:
        """Whether the imports explain all torques: then no difference is due to an algorithm."""
        return not any(stage.unexplained for _, stage in self.stages())


def compare_engines(
    model: WholeSource = "appendix",
    *,
    whole: bool = False,
    engines: Sequence[str] | None = None,
    samples: int = SAMPLES,
    seed: int = 0,
    gravity: ArrayLike | None = None,
    repairs: bool = True,
    progress: Callable[[str], None] | None = None,
) -> EngineReport:
    """Load one model into several engines and compare what they imported and what they answer.

    Parameters
    ----------
    model : name, path, pin.Model, SerialArm, Robot or RobotTree
        See `load`.  A Robot or RobotTree is compared whole, as is a file with several chains.
    whole : bool
        Whether a file with one arm is compared whole too, with what is beside the arm.
    engines : sequence of str, optional
        Keys (`ur5check engines` lists them); all that are installed when None.  The hand-written
        recursion always takes part.
    samples : int
        Number of random states, at least 1.
    seed : int
        Of the states, not negative (see `random_states`).
    gravity : array-like, shape (3,), optional
        For all engines, in the base frame [m/s²]; the model's own when None.
    repairs : bool
        Whether engines that imported another arm read it again with their repairs.
    progress : callable, optional
        Called with a line before each longer step.

    Returns
    -------
    EngineReport

    Raises
    ------
    InputError
        For a model that cannot be read, a name that is no engine's, or another invalid argument.
    EngineError
        For an engine that was named and is not installed.

    Examples
    --------
    >>> import ur5check
    >>> report = ur5check.compare_engines("appendix", engines=["pinocchio"], samples=10)
    >>> report.as_read.agrees()
    True
    """
    say = callback("progress", progress)
    arm = load_arm_or_tree(model, whole=whole)
    keys = engine_keys(engines)
    g = gravity_of(arm, gravity)
    drawn = random_states(arm.n, samples, seed)
    readings = []
    for key in keys:
        say(f"{REGISTRY[key].title} reads {arm.name}")
        readings.append(read_by(key, arm, arm, g))
    states = join_states(drawn, *_worst(arm, readings, g, seed))
    say(f"comparing them at {len(states):,} states")
    as_read = _stage(readings, states, arm, g)
    repaired = None
    if repairs and any(r.harmful or r.refused for r in as_read.readings):
        say("comparing again with the repairs")
        repaired = _stage([_repaired(r, arm, g) for r in as_read.readings], states, arm, g)
    here = installed()
    absent = tuple(key for key in REGISTRY if key not in here)
    return EngineReport(arm, g, states, samples, seed, as_read, repaired, absent)


def _worst(arm: ArmOrTree, readings: Sequence[Reading], gravity: Array, seed: int) -> list[States]:
    """The worst state of each engine that imported another arm; none of a tree, since
    the search takes arms only."""
    if not isinstance(arm, SerialArm):
        return []
    return [
        worst_state(arm.with_gravity(gravity), imported.with_gravity(gravity), seed)
        for reading in readings
        if reading.imported is not None
        and reading.imported.harmful
        and isinstance(imported := reading.imported.imported_arm, SerialArm)
    ]


def engine_keys(named: Sequence[str] | None) -> tuple[str, ...]:
    """The reference, then those named (all that are installed when None), each once.

    Raises UsageError for an unknown key, EngineError for an engine that is not installed.
    """
    if named is None:
        return installed()
    for key in names("engines", named):
        engine_class(key)
    return tuple(key for key in REGISTRY if key == REFERENCE or key in named)


def _stage(readings: Sequence[Reading], states: States, arm: ArmOrTree, gravity: Array) -> Stage:
    tau = rnea(arm, states.q, states.qd, states.qdd, gravity)
    answered = tuple(with_answers(reading, states, tau, gravity) for reading in readings)
    return Stage(answered, matrix_of([r.answers for r in answered if r.answers is not None]))


def _repaired(reading: Reading, arm: ArmOrTree, gravity: Array) -> Reading:
    """The engine with the repairs for its known issues, if it needs them and has any."""
    given = repaired(arm, reading.key)
    if given is arm or not (reading.harmful or reading.refused):
        return reading
    return read_by(reading.key, given, arm, gravity)
