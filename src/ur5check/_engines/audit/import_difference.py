"""One difference between the model that an engine imported and the file, and what it affects.

affects    meaning
torque     the engine's torques are those of another arm
use        matters to programs that call the engine directly: joint order, limits, damping, tool …
nothing    another representation of the same arm
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np

from ..._robot.transforms import Array

if TYPE_CHECKING:
    from ..known_issue import KnownIssue

__all__ = ["KINDS", "Bearing", "ImportDifference", "Kind"]

Bearing = Literal["torque", "use", "nothing"]
Kind = Literal[
    "default-inertia", "shape-mass", "rotation-dropped", "body-lost",
    "mass-changed", "com-moved", "tensor-changed", "armature", "axis", "joint-moved",
    "gravity", "order", "position-limit", "velocity-limit", "effort-limit",
    "damping", "friction", "tool",
    "body-merged", "base-kept", "base-ignored", "coordinates",
]  # fmt: skip

#: What each kind affects, and what it means.
KINDS: dict[Kind, tuple[Bearing, str]] = {
    "default-inertia": ("torque", "a link without `<inertial>` gets a default one"),
    "shape-mass": ("torque", "a link without `<inertial>` gets the mass of its shape"),
    "rotation-dropped": ("torque", "the rpy of `<inertial><origin>` is left out"),
    "body-lost": ("torque", "a link's inertia is lost"),
    "mass-changed": ("torque", "a mass is different"),
    "com-moved": ("torque", "a centre of mass is different"),
    "tensor-changed": ("torque", "an inertia tensor is different: balanced, bounded, misread"),
    "armature": ("torque", "a joint's motor inertia is different"),
    "axis": ("torque", "a joint's axis is different"),
    "joint-moved": ("torque", "a joint is elsewhere"),
    "gravity": ("use", "the default gravity is different"),
    "order": ("use", "joints come in another order"),
    "position-limit": ("use", "position limits are different, or lost"),
    "velocity-limit": ("use", "a velocity limit is different, or lost"),
    "effort-limit": ("use", "an effort limit is different, or lost"),
    "damping": ("use", "a joint's damping is different, or lost"),
    "friction": ("use", "a joint's friction is different, or lost"),
    "tool": ("use", "the tool frame is elsewhere"),
    "body-merged": ("nothing", "links fixed to each other are kept as one body"),
    "base-kept": ("nothing", "the inertia of the fixed base is kept"),
    "base-ignored": ("nothing", "the inertia of the fixed base is left out"),
    "coordinates": ("nothing", "a joint has more than one position coordinate"),
}
assert set(KINDS) == set(get_args(Kind))  # noqa: S101 - about this file alone


@dataclass(frozen=True, eq=False)
class ImportDifference:
    """A difference, named.

    where : "link 'tool0'", "joint 'elbow_joint'"; empty for the whole model
    written, imported : what the file says and what the engine has, in words
    joint : index of the joint that it is about, or that carries it; None for the whole model
    parameters : what it adds to π, shape (10 N,) for N moving links; None where it is no inertia's
    value, bound : of the engine and of the file, in `unit`, where the difference is one number
    torque_effect : the largest |Δτ| that it alone makes at the compared states [N m]; None where it
        makes none
    known_issue : the engine's known issue that explains it, with its fix
    """

    kind: Kind
    where: str
    written: str
    imported: str
    joint: int | None = None
    parameters: Array | None = field(default=None, repr=False)
    value: float | None = None
    bound: float | None = None
    unit: str = ""
    torque_effect: float | None = None
    known_issue: KnownIssue | None = None

    @property
    def bears_on(self) -> Bearing:
        """What a difference of this kind affects."""
        return KINDS[self.kind][0]

    @property
    def harmful(self) -> bool:
        """Whether it changes torques."""
        return self.bears_on == "torque"

    @property
    def mass(self) -> float:
        """What it adds to the arm's mass [kg]."""
        return 0.0 if self.parameters is None else float(np.sum(self.parameters[::10]))
