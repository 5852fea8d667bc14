"""No engine simulates before its import has been checked: no hidden mass, no turned tensor.

DART gives links without `<inertial>` (`ee_link`, `tool0`) a kilogram each, MuJoCo weighs them by
their collision shape: an arm that would sag under torques that hold the real one.  The fixes for
these known issues are applied first (`_engines.known_issues`), then what the engine holds is
compared with the arm (`_engines.audit.import_audit`), and one that still holds another arm is
turned away.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NoReturn, cast

import numpy as np

from .._engines.audit.audit_tolerances import parameter_rounding
from .._engines.audit.import_audit import audit
from .._engines.engine import Stepper
from .._engines.imported_model import moving_inertias
from .._engines.known_issues import repaired
from .._engines.registry import make_engine
from .._errors import EngineError, UsageError
from .._robot.serial_arm import SerialArm

__all__ = ["STEPPERS", "Admitted", "admit", "require_same_model"]

#: Keys of the physics engines that move an arm in time.
STEPPERS = ("mujoco", "dart")


@dataclass(frozen=True, eq=False)
class Admitted:
    """An engine that holds the arm, and nothing else.

    repaired : what it would have held otherwise had it been given the file as it is, in words
    """

    engine: Stepper
    repaired: tuple[str, ...]


def admit(key: str, arm: SerialArm) -> Admitted:
    """The engine of that key, holding `arm` under its gravity.

    Raises UsageError for a key that is no physics engine's, EngineError for an engine that is not
    installed or holds another arm even after its fixes.
    """
    if key not in STEPPERS:
        raise UsageError(f"{key!r} moves no arm in time; choose from {', '.join(STEPPERS)}")
    as_it_is = audit(make_engine(key, arm).imported_model(), arm)
    engine = cast(Stepper, make_engine(key, repaired(arm, key)))
    require_same_model(engine, arm)
    return Admitted(engine, tuple(f"{one.where}: {one.held}" for one in as_it_is.harmful))


def require_same_model(engine: Stepper, arm: SerialArm) -> None:
    """Raises EngineError, naming the first difference, if the engine holds another arm.

    The audit holds the engine against the arm's file.  An arm whose inertias were changed since
    (`with_inertias`) reaches an engine as that file nevertheless: so they are compared as well.
    """
    imported_model = engine.imported_model()
    # Gravity is told to the engine, whatever it read.
    harmful = [one for one in audit(imported_model, arm).harmful if one.kind != "gravity"]
    for one in harmful[:1]:
        _refuse_other_model(engine, arm, one.where, one.held, one.written)
    for link, held in zip(arm.links, moving_inertias(imported_model, arm), strict=True):
        here, there = link.inertia.parameters(), held.parameters()
        if (np.abs(here - there) > parameter_rounding(arm, here, there)).any():
            masses = (f"{inertia.mass:.6g} kg" for inertia in (held, link.inertia))
            _refuse_other_model(engine, arm, f"link {link.name!r}", *masses)


def _refuse_other_model(
    engine: Stepper, arm: SerialArm, where: str, held: str, wanted: str
) -> NoReturn:
    raise EngineError(
        f"{engine.name} holds another arm than {arm.name!r}: {where}: {held}, where the model has "
        f"{wanted}; simulate with another engine, or repair the model"
    )
