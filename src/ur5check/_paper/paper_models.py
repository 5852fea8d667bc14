"""The five models that compute every case, four by our recursion and one by Pinocchio.

paper-listing           the paper's program as printed
paper                   its masses, centres and tensors on the controller's DH: the repair
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
    """An arm and the function that computes its torques.

    arm : as it was read
    true_arm : the same inertias and gravity on the UR5's geometry: gives the expected torque
    torque : g(q) of shape (..., n) [N m], for q of shape (..., n) [rad]
    """

    name: str
    form: Form
    arm: SerialArm
    true_arm: SerialArm
    torque: Callable[[Array], Array]


def load_models() -> tuple[Model, ...]:
    """All five, the printed one first.

    The UR5's geometry is the controller's DH.  `_comparison.arm_pair` maps each model's inertias
    to it: in space where the axes coincide, number by number where, as in the listing, signs are
    lost and they do not.
    """
    controller = load(REPAIRED)
    models = [_own(load(name), form, controller) for name, form in _FORMS.items()]
    appendix = models[2]
    from .._engines.adapters.pinocchio import PinocchioEngine

    return (*models, reference_model(appendix, PinocchioEngine(appendix.arm)))


def reference_model(appendix: Model, reference: Engine) -> Model:
    """The appendix again, computed by a reference engine."""
    return Model(PINOCCHIO, "other", appendix.arm, appendix.true_arm, reference.gravity_torque)


def _own(arm: SerialArm, form: Form, controller: SerialArm) -> Model:
    true_arm = pair_up(controller, arm).arm(geometry="a", inertias="b", gravity="b")
    return Model(arm.name, form, arm, true_arm, lambda q: gravity_torque(arm, q))
