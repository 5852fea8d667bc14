"""What the simulation tests share."""

from __future__ import annotations

import numpy as np

import ur5check
from ur5check._robot import Inertia, Joint, Limits, Link, SerialArm, Transform

#: Test 9 of the paper [rad].
CASE_9 = np.array([0.0, 0.9, -1.0, 1.0, 3.5, -1.9])
APPENDIX = ur5check.load("appendix")


def pendulum(length: float = 0.5, mass: float = 2.0, **limits: float) -> SerialArm:
    """A point mass at the end of a rod that turns about y; it hangs at q = π/2."""
    return SerialArm(
        "pendulum",
        (Joint("pivot", np.array([0.0, 1.0, 0.0]), limits=Limits(**limits)),),
        (
            Link(
                "rod",
                Transform.translation((length, 0, 0)),
                Inertia(mass, np.zeros(3), np.zeros((3, 3))),
            ),
        ),
    )
