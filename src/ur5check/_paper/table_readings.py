"""Table 1 and eq. (1) as arms: two readings of the table, and the equation as printed.

Table 1 prints the lengths −a2 and −a3, and the appendix is the only place that gives a2 a value:
−0.425 m, the controller's.  Read with that value, the table's length is +0.425 m, which is the
listing's vector and not the robot's.  Read with a2 > 0, as a UR's table is usually printed, it is
the controller's −0.425 m.  The shipped model `paper` has the controller's DH parameters.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array, Transform

__all__ = ["eq_1_as_printed", "literal_reading"]

#: Links whose lengths Table 1 prints with a minus sign.
_SIGNED = (2, 3)


def literal_reading(controller: SerialArm) -> SerialArm:
    """Table 1 with the appendix's negative a2 and a3: lengths a of opposite sign in rows 2 and 3.

    controller : an arm with the controller's DH parameters
    """
    vectors = [P.p.copy() for P in _steps(controller)]
    for link in _SIGNED:
        vectors[link - 1][0] *= -1.0
    return _with_vectors(controller, vectors)


def eq_1_as_printed(controller: SerialArm) -> SerialArm:
    """The arm by A_i = Rot_z Trans_z(d_i) Trans_z(a_i) Rot_x: both lengths along z.

    controller : an arm with the controller's DH parameters
    """
    return _with_vectors(
        controller, [np.array([0.0, 0.0, P.p[0] + P.p[2]]) for P in _steps(controller)]
    )


def _steps(arm: SerialArm) -> list[Transform]:
    return [link.link_tip_frame for link in arm.links]


def _with_vectors(arm: SerialArm, vectors: list[Array]) -> SerialArm:
    links = tuple(
        replace(link, link_tip_frame=Transform(link.link_tip_frame.R, p))
        for link, p in zip(arm.links, vectors, strict=True)
    )
    return replace(arm, links=links)
