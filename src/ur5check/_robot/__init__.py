"""An arm as values.  Nothing here reads a file or computes a torque."""

from .dh import DHRow, arm_from_dh
from .inertia import PARAMETERS, Inertia, parameter_map
from .serial_arm import STANDARD_GRAVITY, Joint, Limits, Link, SerialArm, Source
from .transforms import Transform

__all__ = [
    "PARAMETERS",
    "STANDARD_GRAVITY",
    "DHRow",
    "Inertia",
    "Joint",
    "Limits",
    "Link",
    "SerialArm",
    "Source",
    "Transform",
    "arm_from_dh",
    "parameter_map",
]
