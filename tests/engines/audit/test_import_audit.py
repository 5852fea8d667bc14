"""Every planted import fault is named, with its place, its newton metres, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

import planted_engines
import ur5check
from planted_engines import Honest, Merging
from ur5check._dynamics.recursion import rnea
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._engines.audit.import_audit import audit, with_torque_effects
from ur5check._robot.states import random_states

#: What each planted engine must be found to have done: kind, place.
FAULTS = {
    "RotationDropped": [
        ("rotation-dropped", "link 'upper'"),
        ("rotation-dropped", "link 'lower'"),
        ("rotation-dropped", "link 'weight'"),
    ],
    "RotationDroppedAndMerging": [
        ("rotation-dropped", "link 'upper'"),
        ("rotation-dropped", "link 'lower'"),
        ("rotation-dropped", "link 'weight'"),
    ],
    "DefaultMass": [("default-inertia", "link 'tool'")],
    "DefaultMassAndMerging": [("default-inertia", "link 'tool'")],
    "ShapeMass": [("shape-mass", "link 'plate'")],
    "BodyLost": [("body-lost", "link 'weight'")],
    "BodyLostAndMerging": [("body-lost", "link 'weight'")],
    "MassChanged": [("mass-changed", "link 'upper'")],
    "CentreMoved": [("com-moved", "link 'upper'")],
    "Balanced": [("tensor-changed", "link 'upper'")],
    "MotorAdded": [("armature", "joint 'lift'")],
    "AxisReversed": [("axis", "joint 'pan'")],
    "JointMoved": [("joint-moved", "joint 'lift'")],
    "GravityOfItsOwn": [("gravity", "")],
    "GravityByDefault": [("gravity", "")],
    "OrderOfItsOwn": [("order", "")],
    "LimitsLost": [
        ("position-limit", "joint 'pan'"),
        ("velocity-limit", "joint 'pan'"),
        ("effort-limit", "joint 'pan'"),
        ("position-limit", "joint 'lift'"),
        ("velocity-limit", "joint 'lift'"),
        ("effort-limit", "joint 'lift'"),
    ],
    "BearingsLost": [("damping", "joint 'pan'"), ("friction", "joint 'pan'")],
    "ToolElsewhere": [("tool", "frame 'tool'")],
    "TwoCoordinates": [("coordinates", "")],
}
BEARS_ON_TORQUE = {
    "rotation-dropped", "default-inertia", "shape-mass", "body-lost", "mass-changed", "com-moved",
    "tensor-changed", "armature", "axis", "joint-moved",
}  # fmt: skip
#: How bodies are kept is told too, and is no fault.
BOOKKEEPING = {"base-ignored", "base-kept", "body-merged"}


def faults(imported):
    return [one for one in imported.differences if one.kind not in BOOKKEEPING]


@pytest.mark.parametrize("name", FAULTS)
def test_a_planted_fault_is_named(name, arm):
    engine = getattr(planted_engines, name)(arm)
    found = faults(audit(engine.imported_model(), arm))
    assert sorted((one.kind, one.where) for one in found) == sorted(FAULTS[name])
    assert {one.kind for one in found if one.harmful} == {
        kind for kind, _ in FAULTS[name] if kind in BEARS_ON_TORQUE
    }


@pytest.mark.parametrize("engine", [Honest, Merging, PinocchioEngine])
def test_an_honest_reading_has_no_fault(engine, arm):
    imported = audit(engine(arm).imported_model(), arm)
    assert {one.kind for one in faults(imported)} <= {"coordinates"}
    assert imported.harmful == ()


@pytest.mark.parametrize("name", ["appendix", "erd-ur5", "paper"])
def test_pinocchio_reads_a_ur5_rightly(name):
    arm = ur5check.load(name)
    assert faults(audit(PinocchioEngine(arm).imported_model(), arm)) == []


@pytest.mark.parametrize(
    "name", [n for n, f in FAULTS.items() if f[0][0] in BEARS_ON_TORQUE - {"axis", "joint-moved"}]
)
def test_each_faults_newton_metres_add_up_to_the_whole(name, arm):
    engine = getattr(planted_engines, name)(arm)
    states = random_states(arm.n, 50, seed=1)
    imported = with_torque_effects(audit(engine.imported_model(), arm), states)
    state = (states.q, states.qd, states.qdd)
    whole = engine.inverse_dynamics(*state) - rnea(arm, *state)
    imported_arm = rnea(imported.imported_arm, *state) - rnea(arm, *state)
    np.testing.assert_allclose(imported_arm, whole, atol=1e-12)
    costs = [one.torque_effect for one in imported.harmful]
    assert all(cost > 1e-6 for cost in costs)
    # No |Δτ| is larger than what the faults make one by one, and one alone makes all of it.
    assert np.abs(whole).max() <= sum(costs) + 1e-12
    if len(costs) == 1:
        assert np.abs(whole).max() == pytest.approx(costs[0], rel=1e-9)


def test_a_fault_below_rounding_is_none_and_one_above_is(arm):
    for factor, expected in ((1 + 1e-15, []), (1 + 1e-11, ["mass-changed"])):
        inertias = [link.inertia for link in arm.links]
        first = inertias[0]
        scaled = type(first)(first.mass * factor, first.com, first.tensor)
        engine = Merging(arm.with_inertias([scaled, *inertias[1:]]))
        assert [one.kind for one in faults(audit(engine.imported_model(), arm))] == expected


def test_two_faults_in_one_arm_are_told_apart(arm):
    text = planted_engines.DefaultMass(arm).arm.source.urdf
    both = planted_engines.reread(arm, text.replace('<mass value="2.5"/>', '<mass value="2.6"/>'))
    found = faults(audit(Merging(both).imported_model(), arm))
    assert {(one.kind, one.where) for one in found} == {
        ("default-inertia", "link 'tool'"),
        ("mass-changed", "link 'upper'"),
    }


def test_two_faults_of_one_merged_body_are_told_apart(arm):
    text = planted_engines.RotationDropped(arm).arm.source.urdf
    both = planted_engines.reread(
        arm, text.replace('<link name="tool"/>', f'<link name="tool">{planted_engines.UNIT}</link>')
    )
    found = faults(audit(Merging(both).imported_model(), arm))
    assert {(one.kind, one.where) for one in found if one.joint == 2} == {
        ("default-inertia", "link 'tool'"),
        ("rotation-dropped", "link 'weight'"),
    }


def test_default_gravity_costs_what_it_costs(arm):
    states = random_states(arm.n, 50, seed=1)
    engine = planted_engines.GravityByDefault(arm)
    (gravity,) = faults(with_torque_effects(audit(engine.imported_model(), arm), states))
    expected = np.abs(
        rnea(arm, states.q, states.qd, states.qdd, (0, 0, -9.80665))
        - rnea(arm, states.q, states.qd, states.qdd)
    ).max()
    assert gravity.bears_on == "use"
    assert gravity.torque_effect == pytest.approx(expected, rel=1e-9)


def test_a_rotation_that_turns_nothing_is_not_blamed(arm):
    round_upper = arm.source.urdf.replace(
        'ixx="0.01" ixy="0.001" ixz="0" iyy="0.03" iyz="0" izz="0.032"',
        'ixx="0.03" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.03"',
    )
    same = planted_engines.reread(arm, round_upper)
    found = faults(audit(planted_engines.RotationDropped(same).imported_model(), same))
    assert {one.where for one in found} == {"link 'lower'", "link 'weight'"}
