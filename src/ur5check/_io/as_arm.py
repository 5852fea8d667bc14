"""An arm from whatever a public function is given for one."""

from __future__ import annotations

from .._robot.serial_arm import SerialArm
from .loading import ArmSource, load

__all__ = ["ArmSource", "as_arm"]


def as_arm(model: ArmSource) -> SerialArm:
    """`model` itself if it is a SerialArm, otherwise what `load` makes of it.

    A name or a path is read at every call: in a loop, load the arm once.  Raises as `load` does.
    """
    return model if isinstance(model, SerialArm) else load(model)
