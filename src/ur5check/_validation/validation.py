"""`ur5check.validate`: laws of the computation, bodies, differences between models."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from numpy.typing import ArrayLike

from .._arguments import callback, integer
from .._comparison.difference import Difference, compare, under_gravity
from .._engines.adapters.ur5check_recursion import RecursionEngine
from .._engines.engine import ReferenceEngine
from .._io.loading import ArmSource, load
from .._result import Result
from .._robot.labels import labelled
from .._robot.serial_arm import SerialArm
from .._robot.states import States, random_states
from .law import Outcome, run
from .law_subject import Subject
from .laws import LAWS
from .pair_laws import BODIES, PAIRS, PairSubject

__all__ = [
    "ModelValidation",
    "PairValidation",
    "Validation",
    "validate",
    "validate_arm",
    "validate_pair",
]

Progress = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class ModelValidation:
    """One arm against the laws of dynamics.

    Attributes
    ----------
    arm : SerialArm
    reference : str
        The reference engine, with its version.
    route : str
        How the model reached it.
    outcomes : tuple of Outcome
    """

    arm: SerialArm
    reference: str
    route: str
    outcomes: tuple[Outcome, ...]


@dataclass(frozen=True, eq=False)
class PairValidation:
    """One arm against another: what differs, and whether all of it is explained.

    Attributes
    ----------
    difference : Difference
    outcomes : tuple of Outcome
    """

    difference: Difference
    outcomes: tuple[Outcome, ...]

    @property
    def explained(self) -> bool:
        """Whether the attribution of the difference leaves no residual beyond rounding."""
        return all(outcome.passed for outcome in self.outcomes if outcome.id == "residual")


@dataclass(frozen=True, eq=False, repr=False)
class Validation(Result):
    """Everything that `validate` found.

    Attributes
    ----------
    models : tuple of ModelValidation
    pairs : tuple of PairValidation
        The first model against each other one.
    samples, seed : int
        Of the states.
    """

    models: tuple[ModelValidation, ...]
    pairs: tuple[PairValidation, ...]
    samples: int
    seed: int

    @property
    def outcomes(self) -> tuple[Outcome, ...]:
        """All outcomes, those of models first."""
        of_models = [o for model in self.models for o in model.outcomes]
        return (*of_models, *(o for pair in self.pairs for o in pair.outcomes))

    @property
    def algorithm_right(self) -> bool:
        """Whether every law holds, for every model."""
        return all(o.passed for o in self.outcomes if o.about == "algorithm")

    @property
    def bodies_possible(self) -> bool:
        """Whether every link's inertia could belong to a real body."""
        return all(o.passed for o in self.outcomes if o.about == "body")

    @property
    def explained(self) -> bool:
        """Whether every difference between models is explained; different axes are one, too."""
        return all(pair.explained for pair in self.pairs)

    @property
    def passed(self) -> bool:
        """Whether the laws hold, bodies are possible and differences are explained."""
        return self.algorithm_right and self.bodies_possible and self.explained


def validate(
    *models: ArmSource,
    samples: int = 10_000,
    seed: int = 0,
    gravity: ArrayLike | None = None,
    progress: Progress | None = None,
) -> Validation:
    """Check the laws of dynamics on every model, with Pinocchio as reference engine.

    Parameters
    ----------
    *models : name, path, pin.Model or SerialArm
        See `load`; the paper's tables and its appendix when none is given.  Each later model is
        compared with the first.
    samples : int
        Number of random states, at least 1.
    seed : int
        Of the states, not negative (see `random_states`).
    gravity : array-like, shape (3,), optional
        In each arm's base frame [m/s²]; each arm's own when None.
    progress : callable, optional
        Called with a line before each longer step.

    Returns
    -------
    Validation

    Raises
    ------
    InputError
        For a model that cannot be read, arms that cannot be compared, or an invalid argument.
    EngineError
        If Pinocchio cannot take a model.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.validate("paper", samples=10).algorithm_right
    True
    """
    from .._engines.adapters.pinocchio import PinocchioEngine

    say, samples = callback("progress", progress), integer("samples", samples, least=1)
    arms = []
    for model in models or ("paper", "appendix"):
        if not isinstance(model, SerialArm):
            say(f"reading {getattr(model, 'name', model)}")
        arms.append(under_gravity(load(model), gravity))
    arms = list(labelled(arms))
    references = [PinocchioEngine(arm) for arm in arms]
    validated = []
    for arm, reference in zip(arms, references, strict=True):
        say(f"checking {arm.label} at {samples:,} states")
        states = random_states(arm.n, samples, seed)
        validated.append(validate_arm(arm, reference, states))
    pairs = []
    for arm, reference in zip(arms[1:], references[1:], strict=True):
        say(f"comparing {arms[0].label} with {arm.label}")
        pairs.append(validate_pair(arms[0], arm, reference, samples, seed))
    return Validation(tuple(validated), tuple(pairs), samples, seed)


def validate_arm(arm: SerialArm, reference: ReferenceEngine, states: States) -> ModelValidation:
    """Every law, and every body, of one arm."""
    subject = Subject(arm, RecursionEngine(arm), reference, states, arm.gravity)
    outcomes = tuple(
        run(check, subject, name=arm.label, n=arm.n, states=states) for check in (*LAWS, *BODIES)
    )
    return ModelValidation(arm, f"{reference.name} {reference.version}", reference.route, outcomes)


def validate_pair(
    a: SerialArm, b: SerialArm, reference: ReferenceEngine, samples: int, seed: int
) -> PairValidation:
    """What differs between two arms, and whether all of it is explained; `reference` holds b."""
    states = random_states(a.n, samples, seed)
    difference = compare(a, b, states, seed)
    subject = PairSubject(difference, RecursionEngine(a), reference)
    name = f"{a.label} against {b.label}"
    outcomes = tuple(run(check, subject, name=name, n=a.n, states=states) for check in PAIRS)
    return PairValidation(difference, outcomes)
