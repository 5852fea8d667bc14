"""Who is asked: five answers to every case, four from our recursion and one from Pinocchio.

paper-listing           the paper's program as printed
paper                   the same numbers on the geometry of its own Table 1: the repair
appendix                the xacro of its appendix
erd-ur5                 the UR5 of example-robot-data, which others use
appendix by Pinocchio   the same URDF text, read and computed by the reference engine
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from .._comparison.arm_pair import pair_up
from .._dynamics.equations import gravity_torque
from .._engines.engine import Engine
from .._io.loading import load
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array

__all__ = ["PINOCCHIO", "PRINTED", "REPAIRED", "Form", "Model", "load_models", "reference_model"]

#: Whether a trial is of what the paper printed, of the same repaired, or of something else.
Form = Literal["printed", "repaired", "other"]

PRINTED, REPAIRED, PINOCCHIO = "paper-listing", "paper", "appendix by Pinocchio"

_FORMS: dict[str, Form] = {
    PRINTED: "printed",
    REPAIRED: "repaired",
    "appendix": "other",
    "erd-ur5": "other",
}


@dataclass(frozen=True, eq=False)
class Model:
    """An arm, and who computes it.

    arm : as it was read
    true_arm : the same inertias on the UR5's geometry, at 9.81 m/s²: for what a torque should be
    torque : g(q) of shape (..., n) [N m], for q of shape (..., n) [rad]
    """

    name: str
    form: Form
    arm: SerialArm
    true_arm: SerialArm
    torque: Callable[[Array], Array]


def load_models() -> tuple[Model, ...]:
    """All five, what is printed first.

    The UR5's geometry is that of Table 1 with the controller's values.  `_comparison.arm_pair`
    carries each model's inertias there: in space where the axes coincide, number by number where,
    as in the listing, signs are lost and they do not.
    """
    table_1 = load(REPAIRED)
    models = [_own(load(name), form, table_1) for name, form in _FORMS.items()]
    appendix = models[2]
    from .._engines.adapters.pinocchio import PinocchioEngine

    return (*models, reference_model(appendix, PinocchioEngine(appendix.arm)))


def reference_model(appendix: Model, reference: Engine) -> Model:
    """The appendix again, computed by a reference engine."""
    return Model(PINOCCHIO, "other", appendix.arm, appendix.true_arm, reference.gravity_torque)


def _own(arm: SerialArm, form: Form, table_1: SerialArm) -> Model:
    true_arm = pair_up(table_1, arm).arm(geometry="a", inertias="b", gravity="a")
    return Model(arm.name, form, arm, true_arm, lambda q: gravity_torque(arm, q))
