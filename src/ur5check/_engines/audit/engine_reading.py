"""One engine with one text: made, audited, asked."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..._errors import EngineError
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States
from ..._robot.transforms import Array
from ..engine import Engine
from ..registry import REGISTRY, engine_class, make_engine
from .engine_answers import Answers, ask
from .import_audit import Import, audit, priced
from .import_explanation import Belief, belief_of

__all__ = ["Reading", "asked", "read_by"]


@dataclass(frozen=True, eq=False)
class Reading:
    """What came of giving an arm to an engine.

    engine : holding the arm;  imported : what it holds, against the arm as it is written
    answers : to the questions;  belief : whether they are those of the arm that it holds
    refused : why the engine would not take the arm; all else is None then
    """

    key: str
    engine: Engine | None = None
    imported: Import | None = None
    answers: Answers | None = None
    belief: Belief | None = None
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
        """How the arm reached the engine."""
        return self.engine.route if self.engine else ""

    @property
    def said(self) -> tuple[str, ...]:
        """Warnings of the engine's own while it read."""
        return self.imported.imported_model.said if self.imported else ()

    @property
    def harmful(self) -> bool:
        """Whether the engine holds another arm, as far as torque can tell."""
        return bool(self.imported and self.imported.harmful) or bool(
            self.belief and self.belief.follows
        )


def read_by(key: str, given: SerialArm, arm: SerialArm, gravity: Array) -> Reading:
    """Give an engine `given` (the arm, or the arm with fixes), and audit it against `arm`.

    gravity : told to the engine, in the arm's base frame [m/s²]

    Raises EngineError if the engine is not installed; one that refuses the model is a finding.
    """
    engine_class(key)
    try:
        engine = make_engine(key, given, gravity)
        imported = audit(engine.imported_model(), arm, key)
    except EngineError as error:
        return Reading(key, refused=str(error))
    return Reading(key, engine, imported)


def asked(reading: Reading, states: States, tau: Array, gravity: Array) -> Reading:
    """The same with the engine's answers, each difference's cost, and whether it is believed."""
    if reading.engine is None or reading.imported is None:
        return reading
    answers = ask(reading.key, reading.engine, states, tau)
    return replace(
        reading,
        imported=priced(reading.imported, states),
        answers=answers,
        belief=belief_of(reading.imported, answers.torque, states, gravity),
    )
