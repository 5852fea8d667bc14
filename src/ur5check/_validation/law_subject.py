"""The subject of the laws: one arm, our dynamics, a reference engine, and states."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .._engines.engine import ReferenceEngine
from .._robot.serial_arm import SerialArm
from .._robot.states import States
from .._robot.transforms import Array

__all__ = ["STEP", "RecursionDynamics", "Subject"]

STEP = 1e-30  # of complex derivatives, which subtract nothing: any tiny one will do

Numbers = NDArray[Any]


class RecursionDynamics(ReferenceEngine, Protocol):
    """An engine with energies that also takes complex states: ours."""

    def kinetic_energy(self, q: Numbers, qd: Numbers) -> Numbers:
        """T, shape (...) [J]."""
        ...

    def potential_energy(self, q: Numbers) -> Numbers:
        """U, shape (...) [J]."""
        ...


@dataclass(eq=False)
class Subject:
    """One arm under test.  What several laws need is computed once.

    recursion : the hand-written dynamics;  reference : another engine with the same arm
    gravity : in the arm's base frame [m/s²]
    """

    arm: SerialArm
    recursion: RecursionDynamics
    reference: ReferenceEngine
    states: States
    gravity: Array

    @cached_property
    def tau(self) -> Array:
        return self.recursion.inverse_dynamics(self.states.q, self.states.qd, self.states.qdd)

    @cached_property
    def M(self) -> Array:
        return self.recursion.mass_matrix(self.states.q)

    @cached_property
    def C(self) -> Array:
        return self.recursion.coriolis_matrix(self.states.q, self.states.qd)

    @cached_property
    def rate_of_M(self) -> Array:
        """Ṁ along the motion: M(q + i h q̇), imaginary part over h.  No C is involved."""
        moved = self.states.q + 1j * STEP * self.states.qd
        return np.asarray(self.recursion.mass_matrix(moved).imag / STEP)

    @cached_property
    def qdd(self) -> Array:
        """Our forward dynamics under `tau`."""
        return self.recursion.forward_dynamics(self.states.q, self.states.qd, self.tau)

    @cached_property
    def g(self) -> Array:
        return self.recursion.gravity_torque(self.states.q)

    @cached_property
    def reference_tau(self) -> Array:
        return self.reference.inverse_dynamics(self.states.q, self.states.qd, self.states.qdd)

    @cached_property
    def regressor(self) -> Array:
        return self.recursion.torque_regressor(self.states.q, self.states.qd, self.states.qdd)

    # Sizes, against which rounding is judged.

    @cached_property
    def lever_torque(self) -> float:
        """The weight of every link on the longest lever it could have [N m].

        A torque can be zero because large ones cancel; what rounding leaves then is still a part of
        those.
        """
        reach, torque = 0.0, 0.0
        for link in self.arm.links:
            reach += float(np.linalg.norm(link.link_tip_frame.p))
            lever = reach + float(np.linalg.norm(link.inertia.com))
            torque += abs(link.inertia.mass) * lever
        return torque * float(np.linalg.norm(self.gravity))

    @cached_property
    def torque_size(self) -> float:
        """[N m]"""
        return max(float(np.abs(self.tau).max()), self.lever_torque)

    @cached_property
    def mass_size(self) -> float:
        """[kg m²]"""
        return float(np.abs(self.M).max())

    @cached_property
    def rate_size(self) -> float:
        """Size of a velocity torque matrix, [N m s]: M times the fastest joint."""
        return self.mass_size * float(np.abs(self.states.qd).max())

    @cached_property
    def world_rate_size(self) -> float:
        """`rate_size` of a reference engine [N m s], which computes in the world's frame.

        There a body that stands d from the origin has m d² beside its own inertia, which cancels
        in C, but not its rounding.
        """
        distance = float(np.linalg.norm(self.arm.base.p))
        mass = sum(abs(link.inertia.mass) for link in self.arm.links)
        return (self.mass_size + mass * distance**2) * float(np.abs(self.states.qd).max())

    @cached_property
    def polarised_size(self) -> float:
        """The same of our own C [N m s], a difference of velocity torques at q̇ ± one unit.

        It is rounded as those are, however slowly the arm moves.
        """
        return self.rate_size + self.mass_size
