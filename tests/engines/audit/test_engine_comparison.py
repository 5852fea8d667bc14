"""Engines against each other: what they answer, whether it is explained, what a gate says."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ur5check._dynamics.recursion import rnea
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._engines.audit.engine_answers import answer_difference, answers_of
from ur5check._engines.audit.engine_comparison import SAME_ROBOT, compare_engines
from ur5check._engines.engine_entry import EngineEntry
from ur5check._engines.lazy_import import LazyModule
from ur5check._errors import EngineError, UsageError
from ur5check._reports.engines_summary import summarize
from ur5check._robot.states import random_states

#: Planted engines whose torques are those of another arm, and what is said of each.
SAID = {
    "DefaultMass": "has added 1 kg",
    "ShapeMass": "has added 6 kg",
    "BodyLost": "has lost 0.3 kg",
    "RotationDropped": "has left 3 tensors unrotated",
    "MassChanged": "has another mass of link 'upper'",
    "CentreMoved": "has another centre of mass of link 'upper'",
    "Balanced": "has another tensor of link 'upper'",
    "MotorAdded": "has another motor inertia at 1 joint",
    "GravityOfItsOwn": "uses its own gravity",
    "OrderOfItsOwn": "uses its own joint order",
}


def compared(arm, *keys, **options):
    return compare_engines(arm, engines=keys, samples=20, **options)


@pytest.mark.parametrize("name", SAID)
def test_a_planted_fault_is_explained_and_named(name, arm, plant):
    key = plant(name)
    report = compared(arm, key, "pinocchio")
    assert not report.as_read.agrees()
    assert report.as_read.matrix.agreeing(SAME_ROBOT) == (("ur5check", "pinocchio"), (key,))
    assert report.explained
    verdict = summarize(report)[0]
    assert f"ur5check and Pinocchio agree; {name} {SAID[name]}: " in verdict
    worst = report.as_read.matrix.between("ur5check", key)
    assert f"{worst.torque:.4g} N m at joint {worst.joint + 1}" in verdict


@pytest.mark.parametrize("name", ["Honest", "GravityByDefault", "LimitsLost", "ToolElsewhere"])
def test_what_bears_on_no_torque_is_no_disagreement(name, arm, plant):
    report = compared(arm, plant(name))
    assert report.as_read.agrees()
    assert report.explained
    assert report.repaired is None


def test_what_an_engine_does_not_hold_does_not_explain_what_it_computes(arm, plant):
    key = plant("Miscalculating")
    report = compared(arm, key)
    (reading,) = report.as_read.unexplained
    assert reading.key == key
    assert not report.explained
    assert any("Not explained: Miscalculating" in line for line in summarize(report))


def test_an_engine_that_breaks_down_is_infinitely_far(arm, plant):
    report = compared(arm, plant("BreakingDown"))
    assert report.as_read.matrix.worst == math.inf
    assert not report.explained


def test_an_engine_that_refuses_is_a_finding_and_no_agreement(arm, plant):
    report = compared(arm, plant("Refusing"))
    (reading,) = report.as_read.refusals
    assert reading.refused == "it has no taste for this file"
    assert not report.as_read.agrees()
    assert "Refusing refuses the model" in summarize(report)[0]


def test_the_worst_state_is_worse_than_the_random_ones(arm, plant):
    report = compared(arm, plant("DefaultMass"))
    assert len(report.states) == report.samples + 1
    worst = report.as_read.matrix.between("ur5check", "defaultmass")
    assert worst.state == report.samples
    q, qd, qdd = (getattr(report.states, name) for name in ("q", "qd", "qdd"))
    imported_arm = report.as_read.reading("defaultmass").imported.imported_arm
    gap = np.abs(rnea(imported_arm, q, qd, qdd) - rnea(arm, q, qd, qdd))
    assert worst.torque == pytest.approx(gap.max(), rel=1e-12)
    assert gap[-1].max() > 1.05 * gap[:-1].max()


def test_gravity_is_told_to_all(arm, plant):
    report = compared(arm, plant("Honest"), "pinocchio", gravity=(1.0, -2.0, 3.0))
    assert report.as_read.agrees()
    tau = report.as_read.reading("pinocchio").answers.torque
    states = report.states
    np.testing.assert_allclose(
        tau, rnea(arm, states.q, states.qd, states.qdd, (1.0, -2.0, 3.0)), atol=1e-12
    )


def test_every_answer_is_compared(arm):
    class Off(RecursionEngine):
        """One answer a thousandth off."""

        off = ""

        def __getattribute__(self, name):
            value = super().__getattribute__(name)
            if name != "off" and name == self.off:
                return lambda *a: value(*a) + 1e-3
            return value

    states = random_states(arm.n, 10, seed=2)
    tau = rnea(arm, states.q, states.qd, states.qdd)
    ours = answers_of("ur5check", RecursionEngine(arm), states, tau)
    for question, field in {
        "inverse_dynamics": "torque",
        "mass_matrix": "mass",
        "bias_torque": "bias",
        "forward_dynamics": "acceleration",
        "forward_kinematics": "tool",
    }.items():
        engine = Off(arm)
        engine.off = question
        parity = answer_difference(ours, answers_of("off", engine, states, tau))
        for name in ("torque", "mass", "bias", "acceleration", "tool"):
            assert (getattr(parity, name) > 1e-6) == (name == field), (question, name)


def test_engines_that_are_none_and_those_that_are_absent(arm, monkeypatch):
    from ur5check._engines import registry

    with pytest.raises(UsageError, match="no engine is called 'bullet'"):
        compare_engines(arm, engines=["bullet"])
    absent = EngineEntry(
        key="absent",
        title="Absent",
        order=99,
        make=RecursionEngine,
        module=LazyModule("no_such_module"),
        distribution="no-such-thing",
        extra="absent",
    )
    monkeypatch.setitem(registry.REGISTRY, "absent", absent)
    with pytest.raises(EngineError, match=r"pip install 'ur5check\[absent\]'"):
        compare_engines(arm, engines=["absent"])
    assert compare_engines(arm, engines=["pinocchio"], samples=5).absent == ("absent",)


def test_a_matrix_groups_those_that_agree(arm, plant):
    keys = [plant(name) for name in ("Honest", "DefaultMass", "DefaultMassAndMerging")]
    report = compared(arm, *keys)
    groups = report.as_read.matrix.agreeing(SAME_ROBOT)
    assert groups == (("ur5check", keys[0]), (keys[1], keys[2]))
    with pytest.raises(KeyError):
        report.as_read.matrix.between("ur5check", "nobody")


def test_an_arm_without_a_file_is_compared_too(plant):
    report = compare_engines("paper", engines=[plant("Merging"), "pinocchio"], samples=20)
    assert report.as_read.agrees()
