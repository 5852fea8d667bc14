"""The closed form is the recursion, for every quantity, any arm, with numbers and with symbols."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from references import RECURSION, arguments, distance, reference, states

import ur5check
from examples import random_arm
from ur5check import strategies
from ur5check._dynamics.symbolic.trace import trace, trace_difference
from ur5check._errors import StateError, UsageError
from ur5check._robot.inertia import Inertia

MODELS = ("paper", "appendix", "random")
QUANTITIES = tuple(RECURSION)
CASES = [(model, quantity) for model in MODELS for quantity in QUANTITIES]
CASES += [("paper-listing", "tau"), ("erd-ur5", "tau")]  # angles rounded to 4 and to 11 digits
SYMBOLIC = [("paper", quantity) for quantity in QUANTITIES]
SYMBOLIC += [("appendix", "tau"), ("random", "tau")]

TOLERANCE = 1e-11  # [N m] and its like, of a UR5 whose torques reach 200 N m


@cache
def arm_of(model):
    if model != "random":
        return ur5check.load(model)
    arm = random_arm(7, seed=3)  # two of its joints slide
    assert {joint.kind for joint in arm.joints} == {"revolute", "prismatic"}
    return arm.with_armature(np.linspace(0.1, 2.0, 7))


@cache
def program_of(model, quantity, parameters="numeric"):
    return trace(arm_of(model), quantity, parameters=parameters, tries=0)


def tolerance(model, arm, quantity):
    """The random arm is heavy: what is said of a UR5's 200 N m is said of its own largest entry."""
    if model != "random":
        return TOLERANCE
    at = states(arm, 50)
    given = arguments(program_of(model, quantity), at)
    return TOLERANCE * max(1.0, float(np.abs(RECURSION[quantity](arm, *given)).max()) / 200.0)


@pytest.mark.parametrize(("model", "quantity"), CASES)
def test_closed_form_is_the_recursion(model, quantity):
    arm, program = arm_of(model), program_of(model, quantity)
    assert distance(program, arm, RECURSION[quantity]) < tolerance(model, arm, quantity)


@pytest.mark.parametrize(("model", "quantity"), SYMBOLIC)
def test_closed_form_with_symbols_is_the_recursion(model, quantity):
    arm, program = arm_of(model), program_of(model, quantity, "symbolic")
    assert distance(program, arm, RECURSION[quantity]) < tolerance(model, arm, quantity)


@pytest.mark.parametrize(("model", "quantity"), CASES)
def test_closed_form_is_pinocchios(model, quantity):
    arm, program = arm_of(model), program_of(model, quantity)
    assert distance(program, arm, reference(quantity)) < tolerance(model, arm, quantity)


@pytest.mark.parametrize("quantity", ["tau", "M", "C", "g"])
def test_a_lost_sign_is_refused(quantity):
    arm, program = arm_of("paper"), program_of("paper", quantity)
    at, count = states(arm, 20), len(program.assignments)
    for place in (0, count // 2, count - 1):
        assert distance(_sign_lost(program, place), arm, RECURSION[quantity], at) > TOLERANCE


def _sign_lost(program, place):
    """The paper's own mistake, in one line."""
    line = program.assignments[place]
    terms = (replace(line.terms[0], k=-line.terms[0].k), *line.terms[1:])
    lines = list(program.assignments)
    lines[place] = replace(line, terms=terms)
    return replace(program, assignments=tuple(lines))


@pytest.mark.parametrize("model", ["paper", "appendix"])
def test_ur5_torques_take_fewer_than_560_operations(model):
    arm = arm_of(model)
    plain, regrouped = trace(arm, "tau", regroup=False), trace(arm, "tau")
    assert regrouped.operations.total < plain.operations.total < 560
    assert regrouped.operations.total < 340
    assert distance(regrouped, arm, RECURSION["tau"]) < TOLERANCE


def test_work_grows_with_the_joints_and_no_faster():
    ops = {n: trace(random_arm(n, 1), "tau", regroup=False).operations.total for n in (8, 16)}
    a_joint = ops[8] / 8
    assert ops[16] < 16 * a_joint * 1.2


def test_symbols_may_take_other_values():
    arm, program = arm_of("paper"), program_of("paper", "tau", "symbolic")
    at = states(arm, 20)
    heavier = [replace(link.inertia, mass=link.inertia.mass * 2) for link in arm.links]
    masses = {
        f"m{i}": body.mass for i, body in enumerate(heavier, 1) if f"m{i}" in program.parameters
    }
    tau = program.evaluate(at.q, at.qd, at.qdd, **masses)
    np.testing.assert_allclose(
        tau, ur5check.rnea(arm.with_inertias(heavier), at.q, at.qd, at.qdd), atol=TOLERANCE
    )
    assert {"m2", "cx2", "Izz3", "a2", "d4", "gz"} <= program.parameters.keys()
    assert program.setup and not program_of("paper", "tau").setup
    with pytest.raises(StateError, match="m9 is not a parameter"):
        program.evaluate(at.q, at.qd, at.qdd, m9=1.0)


def test_the_difference_of_two_arms_shares_their_work():
    a, b = arm_of("paper"), arm_of("paper").with_armature(np.full(6, 0.3))
    program = trace_difference(a, b)
    at = states(a, 20)
    tau = [ur5check.rnea(arm, at.q, at.qd, at.qdd) for arm in (a, b)]
    np.testing.assert_allclose(program.evaluate(at.q, at.qd, at.qdd), tau[0] - tau[1], atol=1e-11)
    # Two arms that differ in their motors only: whatever else they need, they need once.
    assert program.operations.total < 20
    with pytest.raises(UsageError, match="has 7"):
        trace_difference(a, arm_of("random"))


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("name", ["appendix", "random"])
def test_arms_that_move_alike_need_one_torque(name, way):
    """Torque is linear in the inertias: π_a − π_b, masses of any sign, says it all."""
    arm = arm_of(name)
    other = arm.with_inertias([link.inertia for link in reversed(arm.links)])
    a, b = (arm, other)[::way]
    program = trace_difference(a, b)
    at = states(a, 20)
    tau = [ur5check.rnea(arm, at.q, at.qd, at.qdd) for arm in (a, b)]
    found = program.evaluate(at.q, at.qd, at.qdd)
    np.testing.assert_allclose(found, tau[0] - tau[1], atol=1e-12 * np.abs(tau).max())
    # Where the last digit of one length differs, they do not move alike, and two are needed.
    moved = replace(b.links[1].link_tip_frame, p=np.nextafter(b.links[1].link_tip_frame.p, np.inf))
    links = [
        replace(link, link_tip_frame=moved) if i == 1 else link for i, link in enumerate(b.links)
    ]
    apart = trace_difference(a, replace(b, links=tuple(links)))
    assert apart.operations.total > program.operations.total
    np.testing.assert_allclose(apart.evaluate(at.q, at.qd, at.qdd), found, atol=1e-11)


@pytest.mark.parametrize("zero_tolerance", [5e-324, 1e-310, 1e-160, 1e-90])
def test_numbers_that_are_all_but_zero_spoil_no_torque(zero_tolerance):
    """Their products run out of digits, and what is left must not become a factor."""

    def dusty(x):
        return np.where(np.abs(x) < 1e-12, zero_tolerance, x)

    arm = arm_of("paper")
    bodies = [link.inertia for link in arm.links]
    links = [
        replace(
            link,
            inertia=Inertia(body.mass, dusty(body.com), dusty(body.tensor)),
            link_tip_frame=replace(link.link_tip_frame, p=dusty(link.link_tip_frame.p)),
        )
        for link, body in zip(arm.links, bodies, strict=True)
    ]
    joints = [replace(joint, axis=dusty(joint.axis)) for joint in arm.joints]
    arm = replace(arm, joints=tuple(joints), links=tuple(links))
    at = states(arm, 20)
    tau = ur5check.rnea(arm, at.q, at.qd, at.qdd)
    for regroup in (False, True):
        found = trace(arm, "tau", regroup=regroup, tries=1).evaluate(at.q, at.qd, at.qdd)
        np.testing.assert_allclose(found, tau, atol=TOLERANCE)


def test_what_cannot_be_asked_is_said():
    with pytest.raises(UsageError, match="choose one of tau, M, C, g"):
        trace(arm_of("paper"), "energy")
    program = program_of("paper", "tau")
    with pytest.raises(StateError, match=r"qd must be an array"):
        program.evaluate(np.zeros(6))
    with pytest.raises(StateError, match=r"q must be an array"):
        program.evaluate(np.zeros(5), np.zeros(6), np.zeros(6))


@settings(max_examples=10)
@given(arm_and_states=strategies.arms_and_states())
def test_closed_form_is_the_recursion_for_any_arm(arm_and_states):
    arm, at = arm_and_states
    tau = ur5check.rnea(arm, at.q, at.qd, at.qdd)
    # Rounding grows with what the arm's torques can be, not with what they are at one state.
    usual = states(arm, 20)
    scale = max(np.abs(x).max() for x in (tau, ur5check.rnea(arm, usual.q, usual.qd, usual.qdd)))
    for regroup in (False, True):
        program = trace(arm, "tau", regroup=regroup, tries=0)
        given = {name: getattr(at, name) for name in program.arguments}
        off = np.abs(program.evaluate(**given) - tau).max()
        assert off <= 1e-12 * max(1.0, scale)
