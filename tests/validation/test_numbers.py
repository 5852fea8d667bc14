"""Checks of bodies and of pairs: they pass what is so, and refuse what is not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._robot import Inertia
from ur5check._robot.states import random_states
from ur5check._validation.law import run
from ur5check._validation.law_subject import Subject
from ur5check._validation.pair_laws import BODIES, PAIRS, PairSubject

STATES = random_states(6, 200, seed=5)
(PHYSICAL,) = BODIES
FK, RESIDUAL = PAIRS


def bodies(arm):
    s = Subject(arm, RecursionEngine(arm), PinocchioEngine(arm), STATES, arm.gravity)
    return run(PHYSICAL, s, name=arm.name, n=arm.n, states=STATES)


@pytest.mark.parametrize(
    ("inertia", "words"),
    [
        (Inertia(-1.0, np.zeros(3), np.eye(3)), "mass is negative"),
        (Inertia(1.0, np.zeros(3), np.diag([-0.1, 1.0, 1.0])), "principal moment is negative"),
        (Inertia(1.0, np.zeros(3), np.diag([1.0, 1.0, 2.5])), "exceeds the sum"),
    ],
)
def test_a_body_that_cannot_be_is_named(inertia, words):
    arm = random_arm(6, seed=6)
    assert bodies(arm).passed
    inertias = [link.inertia for link in arm.links]
    result = bodies(arm.with_inertias([*inertias[:2], inertia, *inertias[3:]]))
    assert result.status == "fail"
    assert result.worst_state is None
    assert words in result.details[2]
    assert "could exist" in result.details[1]


def test_a_flat_plate_is_a_body():
    arm = random_arm(6, seed=6)
    plate = Inertia(1.0, np.zeros(3), np.diag([0.1, 0.2, 0.3]))
    assert bodies(arm.with_inertias([plate] * 6)).passed


def pair_outcome(check, difference, reference):
    recursion = RecursionEngine(difference.pair.a)
    s = PairSubject(difference, recursion, reference)
    return run(check, s, name="pair", n=6, states=difference.states)


def difference(a, b):
    return ur5check.diff(a, b, samples=200, seed=1)


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("paper", "appendix"),
        ("appendix", "paper"),
        ("paper-listing", "paper"),
        ("paper-listing", "appendix"),
        ("erd-ur5", "appendix"),
    ],
)
def test_the_attribution_leaves_no_residual(a, b):
    found = difference(a, b)
    assert pair_outcome(RESIDUAL, found, PinocchioEngine(ur5check.load(b))).passed


def test_a_wrong_contribution_leaves_a_residual():
    found = difference("paper", "appendix")
    torque = found.attribution.torque.copy()
    torque[found.attribution.rms().max(axis=1).argmin()] += 1e-9
    short = replace(found, attribution=replace(found.attribution, torque=torque))
    result = pair_outcome(RESIDUAL, short, PinocchioEngine(ur5check.load("appendix")))
    assert result.status == "fail"


def test_a_reference_engine_with_another_arm_leaves_a_residual():
    found = difference("paper", "appendix")
    result = pair_outcome(RESIDUAL, found, PinocchioEngine(ur5check.load("erd-ur5")))
    assert result.status == "fail"


def test_axes_that_coincide_pass_and_axes_that_do_not_fail():
    for a, b, status in (("paper", "appendix", "pass"), ("paper-listing", "paper", "fail")):
        result = pair_outcome(FK, difference(a, b), PinocchioEngine(ur5check.load(b)))
        assert result.status == status
