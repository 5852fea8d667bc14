"""One thing that an engine holds otherwise than the file says it, and what that bears on.

bears on   means
torque     the engine's torques are those of another arm
use        whoever drives the engine by hand must know: joint order, limits, damping, tool …
nothing    another way to keep the same arm
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
    "mass-changed", "com-moved", "tensor-changed", "armature", "axis",
    "gravity", "order", "position-limit", "velocity-limit", "effort-limit",
    "damping", "friction", "tool",
    "body-merged", "base-kept", "base-ignored", "coordinates",
]  # fmt: skip

#: What each kind bears on, and what it means.
KINDS: dict[Kind, tuple[Bearing, str]] = {
    "default-inertia": ("torque", "a link without `<inertial>` is given one"),
    "shape-mass": ("torque", "a link without `<inertial>` is weighed by its shape"),
    "rotation-dropped": ("torque", "the rpy of `<inertial><origin>` is left out"),
    "body-lost": ("torque", "a link's inertia is lost"),
    "mass-changed": ("torque", "a mass is another"),
    "com-moved": ("torque", "a centre of mass lies elsewhere"),
    "tensor-changed": ("torque", "a tensor is another: balanced, bounded, misread"),
    "armature": ("torque", "a joint's motor inertia is another"),
    "axis": ("torque", "a joint turns about another axis"),
    "gravity": ("use", "gravity is another unless it is told"),
    "order": ("use", "joints come in another order"),
    "position-limit": ("use", "position limits are others, or lost"),
    "velocity-limit": ("use", "a velocity limit is another, or lost"),
    "effort-limit": ("use", "an effort limit is another, or lost"),
    "damping": ("use", "a joint's damping is another, or lost"),
    "friction": ("use", "a joint's friction is another, or lost"),
    "tool": ("use", "the tool frame stands elsewhere"),
    "body-merged": ("nothing", "links fixed to each other are kept as one body"),
    "base-kept": ("nothing", "the inertia of what stands is kept"),
    "base-ignored": ("nothing", "the inertia of what stands is left out"),
    "coordinates": ("nothing", "a joint takes more than one position coordinate"),
}
assert set(KINDS) == set(get_args(Kind))  # noqa: S101 - about this file alone


@dataclass(frozen=True, eq=False)
class ImportDifference:
    """A difference, named.

    where : "link 'tool0'", "joint 'elbow_joint'"; empty for the whole arm
    written, held : what the file says and what the engine has, in words
    joint : index of the joint that it is about, or that carries it; None for the whole arm
    parameters : what it adds to π, shape (10 n,); None where it is no inertia's
    cost : the largest |Δτ| that it alone makes at the states asked about [N m]; None where it
        makes none
    known issue : the engine's known known issue that explains it, with its fix
    """

    kind: Kind
    where: str
    written: str
    held: str
    joint: int | None = None
    parameters: Array | None = field(default=None, repr=False)
    cost: float | None = None
    known_issue: KnownIssue | None = None

    @property
    def bears_on(self) -> Bearing:
        """What a difference of this kind bears on."""
        return KINDS[self.kind][0]

    @property
    def harmful(self) -> bool:
        """Whether it bears on torque."""
        return self.bears_on == "torque"

    @property
    def mass(self) -> float:
        """What it adds to the arm's mass [kg]."""
        return 0.0 if self.parameters is None else float(np.sum(self.parameters[::10]))
