"""Every law holds for any arm, and refuses an algorithm that is wrong."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given

import ur5check
from examples import UR5S, random_arm
from ur5check import strategies
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._robot.states import random_states
from ur5check._validation.law import run
from ur5check._validation.law_subject import Subject
from ur5check._validation.laws import LAWS

by_id = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.id)

ARM = random_arm(5, seed=3, prismatic=False)
STATES = random_states(5, 50, seed=4)


def subject(arm=ARM, states=STATES, recursion=None, reference=None):
    recursion = recursion or RecursionEngine(arm)
    return Subject(arm, recursion, reference or PinocchioEngine(arm), states, arm.gravity)


def outcome(law, s):
    return run(law, s, name=s.arm.name, n=s.arm.n, states=s.states)


@by_id
@given(arm_and_states=strategies.arms_and_states())
def test_the_law_holds_for_any_arm(law, arm_and_states):
    arm, states = arm_and_states
    result = outcome(law, subject(arm, states))
    assert result.passed, result


@by_id
@pytest.mark.parametrize("name", UR5S)
def test_the_law_holds_for_every_shipped_model(law, name):
    arm = ur5check.load(name)
    result = outcome(law, subject(arm, random_states(6, 500, seed=0)))
    assert result.passed, result


@by_id
def test_the_law_holds_for_an_arm_with_motors(law):
    arm = ARM.with_armature([0.5, 2.0, 0.0, 0.1, 0.03])
    assert outcome(law, subject(arm)).passed
    # And the motors do something: the reference engine without them disagrees.
    if law.id in ("torque-reference", "mass-reference"):
        assert outcome(law, subject(arm, reference=PinocchioEngine(ARM))).status == "fail"


# --- and what each of them refuses ---------------------------------------------------------------


class MassScaled(RecursionEngine):
    """Every inertia a billionth too large."""

    def mass_matrix(self, q):
        return super().mass_matrix(q) * (1 + 1e-9)


class MassLopsided(RecursionEngine):
    def mass_matrix(self, q):
        M = super().mass_matrix(q)
        M[..., 0, 1] += 1e-9
        return M


class CoriolisOfOneColumn(RecursionEngine):
    """C q̇ is right, C is not Christoffel's: h(q̇) q̇ᵀ / |q̇|²."""

    def coriolis_matrix(self, q, qd):
        h = np.einsum("kij,kj->ki", super().coriolis_matrix(q, qd), qd)
        return h[..., :, None] * qd[..., None, :] / (qd**2).sum(axis=-1)[..., None, None]


class CoriolisForgotten(RecursionEngine):
    def coriolis_matrix(self, q, qd):
        return 0.0 * super().coriolis_matrix(q, qd)


class UpsideDown(RecursionEngine):
    """Energy grows downwards."""

    def potential_energy(self, q):
        return -super().potential_energy(q)


class SpinForgotten(RecursionEngine):
    """Kinetic energy of a slightly lighter arm."""

    def kinetic_energy(self, q, qd):
        return (1 - 1e-9) * super().kinetic_energy(q, qd)


class ColumnsSwapped(RecursionEngine):
    """Ixy and Iyy in the other order: URDF's instead of Pinocchio's."""

    def torque_regressor(self, q, qd, qdd):
        Y = super().torque_regressor(q, qd, qdd)
        Y[..., [5, 6]] = Y[..., [6, 5]]
        return Y


class GravityForgotten(RecursionEngine):
    def forward_dynamics(self, q, qd, tau):
        return super().forward_dynamics(q, qd, tau + self.gravity_torque(q))


class PinocchioOneColumn(PinocchioEngine):
    def coriolis_matrix(self, q, qd):
        return CoriolisOfOneColumn(self.arm).coriolis_matrix(q, qd)


def _moved(arm):
    """The arm with its first link a nanometre longer."""
    first = arm.links[0]
    longer = replace(first.link_tip_frame, p=first.link_tip_frame.p + [1e-9, 0, 0])
    return replace(arm, links=(replace(first, link_tip_frame=longer), *arm.links[1:]))


def _heavier(arm):
    """The arm with a microgram at its tip."""
    inertias = [link.inertia for link in arm.links]
    last = inertias[-1]
    return arm.with_inertias([*inertias[:-1], replace(last, mass=last.mass + 1e-9)])


def _antimatter(arm):
    """The arm with a last link of negative mass: laws of the algorithm hold, M ≻ 0 does not."""
    inertias = [link.inertia for link in arm.links]
    last = inertias[-1]
    return arm.with_inertias([*inertias[:-1], replace(last, mass=-last.mass, tensor=-last.tensor)])


FAULTS = {
    "fk-reference": lambda: subject(reference=PinocchioEngine(_moved(ARM))),
    "torque-reference": lambda: subject(reference=PinocchioEngine(_heavier(ARM))),
    "mass-reference": lambda: subject(recursion=MassScaled(ARM)),
    "mass-symmetric": lambda: subject(recursion=MassLopsided(ARM)),
    "mass-positive": lambda: subject(arm=_antimatter(ARM)),
    "bias-reference": lambda: subject(recursion=CoriolisForgotten(ARM)),
    "gravity-reference": lambda: subject(recursion=RecursionEngine(ARM, ARM.gravity * (1 + 1e-9))),
    "gravity-gradient": lambda: subject(recursion=UpsideDown(ARM)),
    "coriolis-skew": lambda: subject(recursion=CoriolisOfOneColumn(ARM)),
    "coriolis-skew-reference": lambda: subject(reference=PinocchioOneColumn(ARM)),
    "power-balance": lambda: subject(recursion=SpinForgotten(ARM)),
    "regressor-torque": lambda: subject(recursion=ColumnsSwapped(ARM)),
    "regressor-reference": lambda: subject(recursion=ColumnsSwapped(ARM)),
    "forward-inverse": lambda: subject(recursion=GravityForgotten(ARM)),
    "forward-reference": lambda: subject(recursion=GravityForgotten(ARM)),
}


@by_id
def test_the_law_refuses_a_planted_fault(law):
    assert outcome(law, subject()).passed
    assert outcome(law, FAULTS[law.id]()).status == "fail"


def test_a_law_that_measures_no_number_fails():
    class Lost(RecursionEngine):
        def inverse_dynamics(self, q, qd, qdd):
            tau = super().inverse_dynamics(q, qd, qdd)
            tau[7] = np.nan
            return tau

    (law,) = (law for law in LAWS if law.id == "torque-reference")
    result = outcome(law, subject(recursion=Lost(ARM)))
    assert result.status == "fail"
    assert result.worst_state == STATES[7]


def test_the_worst_state_is_the_one_reported():
    class OneBadState(RecursionEngine):
        def mass_matrix(self, q):
            M = super().mass_matrix(q)
            M[13, 0, 0] += 1.0
            return M

    (law,) = (law for law in LAWS if law.id == "mass-reference")
    result = outcome(law, subject(recursion=OneBadState(ARM)))
    assert result.value == pytest.approx(1.0)
    assert result.worst_state == STATES[13]


def test_ids_are_unique():
    assert len({law.id for law in LAWS}) == len(LAWS)
