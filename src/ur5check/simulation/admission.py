"""No engine simulates before its import has been checked: no hidden mass, no turned tensor.

DART gives links without `<inertial>` (`ee_link`, `tool0`) a kilogram each, MuJoCo weighs them by
their collision shape: an arm that would sag under torques that hold the real one.  The remedies for
these habits are applied first (`engines.habits`), then what the engine holds is held against the
arm (`parity.imports`), and one that still holds another arm is turned away.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

from ..arm.serial_arm import SerialArm
from ..engines.engine import Stepper
from ..engines.habits import remedied
from ..engines.registry import make_engine
from ..errors import EngineError, UsageError
from ..parity.imports import audit

__all__ = ["STEPPERS", "Admitted", "admit", "turn_away_strangers"]

#: Keys of the physics engines that move an arm in time.
STEPPERS = ("mujoco", "dart")


@dataclass(frozen=True, eq=False)
class Admitted:
    """An engine that holds the arm, and nothing else.

    mended : what it would have held otherwise had it been given the file as it is, in words
    """

    engine: Stepper
    mended: tuple[str, ...]


def admit(key: str, arm: SerialArm) -> Admitted:
    """The engine of that key, holding `arm` under its gravity.

    Raises UsageError for a key that is no physics engine's, EngineError for an engine that is not
    installed or holds another arm even after its remedies.
    """
    if key not in STEPPERS:
        raise UsageError(f"{key!r} moves no arm in time; choose from {', '.join(STEPPERS)}")
    as_it_is = audit(make_engine(key, arm).holdings(), arm)
    engine = cast(Stepper, make_engine(key, remedied(arm, key)))
    turn_away_strangers(engine, arm)
    return Admitted(engine, tuple(f"{one.where}: {one.held}" for one in as_it_is.harmful))


def turn_away_strangers(engine: Stepper, arm: SerialArm) -> None:
    """Raises EngineError, naming the first difference, if the engine holds another arm."""
    # Gravity is told to the engine, whatever it read.
    harmful = [d for d in audit(engine.holdings(), arm).harmful if d.kind != "gravity"]
    if harmful:
        first, *others = harmful
        more = f" (and {len(others)} more)" if others else ""
        raise EngineError(
            f"{engine.name} holds another arm than {arm.name!r}: {first.where}: {first.held}, "
            f"where the model has {first.written}{more}; simulate with another engine, "
            "or mend the model"
        )
