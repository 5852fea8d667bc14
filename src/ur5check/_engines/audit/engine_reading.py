"""One engine with one text: created, its import audited, its answers computed."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..._errors import EngineError
from ..._robot.robot_tree import ArmOrTree
from ..._robot.states import States
from ..._robot.transforms import Array
from ..captured_warnings import captured_output
from ..engine import Engine
from ..registry import REGISTRY, engine_class, make_engine
from .engine_answers import Answers, answers_of
from .import_audit import ImportAudit, audit, with_torque_effects
from .import_explanation import ImportExplanation, explain_import

__all__ = ["Reading", "read_by", "with_answers"]


@dataclass(frozen=True, eq=False)
class Reading:
    """The result of loading an arm into an engine.

    Attributes
    ----------
    key : str
        The engine's key.
    engine : Engine or None
        With the arm loaded; None where it refused the arm, and so are the next three.
    imported : ImportAudit or None
        The audit of its import against the arm as written.
    answers : Answers or None
        Its torques, accelerations and matrices at the states.
    explanation : ImportExplanation or None
        Whether the answers are those of the imported arm.
    refused : str or None
        The engine's reason for refusing the arm.
    """

    key: str
    engine: Engine | None = None
    imported: ImportAudit | None = None
    answers: Answers | None = None
    explanation: ImportExplanation | None = None
    refused: str | None = None

    @property
    def title(self) -> str:
        """The engine's name, as reports write it."""
        return REGISTRY[self.key].title

    @property
    def version(self) -> str:
        """The engine's version."""
        return self.engine.version if self.engine else str(REGISTRY[self.key].version)

    @property
    def route(self) -> str:
        """By which route the arm reached the engine."""
        return self.engine.route if self.engine else ""

    @property
    def warnings(self) -> tuple[str, ...]:
        """The engine's own warnings, captured while it read."""
        return self.imported.imported_model.warnings if self.imported else ()

    @property
    def harmful(self) -> bool:
        """Whether the engine's torques are those of another arm."""
        return bool(self.imported and self.imported.harmful) or bool(
            self.explanation and self.explanation.follows
        )


def read_by(key: str, given: ArmOrTree, arm: ArmOrTree, gravity: Array) -> Reading:
    """Load `given` (the model, or the repaired one) into an engine, and audit it against `arm`.

    gravity : in the arm's base frame [m/s²]

    Raises EngineError if the engine is not installed; a refusal is part of the result.
    """
    engine_class(key)
    try:
        engine = make_engine(key, given, gravity)
        imported = audit(engine.imported_model(), arm, key)
    except EngineError as error:
        return Reading(key, refused=str(error))
    return Reading(key, engine, imported)


def with_answers(reading: Reading, states: States, tau: Array, gravity: Array) -> Reading:
    """The same with the engine's answers, torque effects, and the explanation of the answers."""
    if reading.engine is None or reading.imported is None:
        return reading
    with captured_output():  # DART prints at every state where M has no inverse
        answers = answers_of(reading.key, reading.engine, states, tau)
    return replace(
        reading,
        imported=with_torque_effects(reading.imported, states),
        answers=answers,
        explanation=explain_import(reading.imported, answers.torque, states, gravity),
    )
