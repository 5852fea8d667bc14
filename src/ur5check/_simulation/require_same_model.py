"""No engine simulates before its import has been checked: no added mass, no unrotated tensor.

DART gives links without `<inertial>` (`ee_link`, `tool0`) 1 kg each, MuJoCo the mass of their
collision shape: such an arm would sag under torques that hold the real one.  The repairs for these
known issues are applied first (`_engines.known_issues`), then the imported model is compared with
the arm (`_engines.audit.import_audit`).  A remaining difference is an error.
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
from .._engines.registry import make_engine, steppers
from .._errors import EngineError, UsageError
from .._robot.serial_arm import SerialArm

__all__ = ["CheckedStepper", "checked_stepper", "require_same_model"]


@dataclass(frozen=True, eq=False)
class CheckedStepper:
    """A stepping engine whose imported model is the arm.

    repaired : what it would have imported otherwise from the file as it is, in words
    """

    engine: Stepper
    repaired: tuple[str, ...]


def checked_stepper(key: str, arm: SerialArm) -> CheckedStepper:
    """The engine of that key with `arm` loaded, under the arm's gravity.

    Raises UsageError for a key of no stepping engine, EngineError for an engine that is not
    installed or imports another arm even after its repairs.
    """
    if key not in steppers():
        raise UsageError(f"{key!r} moves no arm in time; choose from {', '.join(steppers())}")
    as_it_is = audit(make_engine(key, arm).imported_model(), arm)
    engine = cast(Stepper, make_engine(key, repaired(arm, key)))
    require_same_model(engine, arm)
    return CheckedStepper(engine, tuple(f"{one.where}: {one.imported}" for one in as_it_is.harmful))


def require_same_model(engine: Stepper, arm: SerialArm) -> None:
    """Raises EngineError, naming the first difference, if the engine imported another arm.

    The audit compares the engine with the arm's file.  An arm whose inertias were changed since
    (`with_inertias`) reaches an engine as that file nevertheless, so they are compared as well.
    """
    imported_model = engine.imported_model()
    # Gravity is set in the engine, whatever it read.
    harmful = [one for one in audit(imported_model, arm).harmful if one.kind != "gravity"]
    for one in harmful[:1]:
        _refuse_other_model(engine, arm, one.where, one.imported, one.written)
    for link, imported in zip(arm.links, moving_inertias(imported_model, arm), strict=True):
        here, there = link.inertia.parameters(), imported.parameters()
        if (np.abs(here - there) > parameter_rounding(arm, here, there)).any():
            masses = (f"{inertia.mass:.6g} kg" for inertia in (imported, link.inertia))
            _refuse_other_model(engine, arm, f"link {link.name!r}", *masses)


def _refuse_other_model(
    engine: Stepper, arm: SerialArm, where: str, imported: str, wanted: str
) -> NoReturn:
    raise EngineError(
        f"{engine.name} has imported another arm than {arm.name!r}: {where}: {imported}, where the "
        f"model has {wanted}; simulate with another engine, or repair the model"
    )
