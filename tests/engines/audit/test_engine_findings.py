"""Every wrong import is a finding of family ENG, with its place, numbers and torque effect."""

from __future__ import annotations

import pytest

from planted_engines import Honest
from ur5check._engines.audit.engine_comparison import compare_engines
from ur5check._engines.audit.import_audit import audit
from ur5check._engines.audit.import_difference import KINDS
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._rules.engine_rules import RULES

IDS = {rule.name: rule.id for rule in RULES}


def findings(arm, key):
    return compare_engines(arm, engines=[key], samples=20).findings


@pytest.mark.parametrize(
    ("name", "kind", "severity", "subject", "value", "bound", "unit"),
    [
        ("DefaultMass", "default-inertia", "error", "link 'tool'", 1.0, 0.0, "kg"),
        ("ShapeMass", "shape-mass", "error", "link 'plate'", 6.0, 0.0, "kg"),
        ("BodyLost", "body-lost", "error", "link 'weight'", 0.0, 0.3, "kg"),
        ("MassChanged", "mass-changed", "error", "link 'upper'", 2.6, 2.5, "kg"),
        ("MotorAdded", "armature", "error", "joint 'lift'", 0.25, 0.0, "kg m²"),
    ],
)
def test_a_wrong_import_is_a_finding(name, kind, severity, subject, value, bound, unit, arm, plant):
    (found,) = findings(arm, plant(name))
    assert (found.rule, found.severity, found.subject) == (IDS[kind], severity, subject)
    assert found.value == pytest.approx(value, abs=1e-9)
    assert found.bound == pytest.approx(bound, abs=1e-9)
    assert found.unit == unit
    assert found.effect > 1e-3
    assert found.consequence
    assert found.fix


def test_a_finding_has_the_line_of_the_link_in_the_file(arm, plant):
    (found,) = findings(arm, plant("MassChanged"))
    lines = arm.source.urdf.splitlines()
    assert '<link name="upper">' in lines[found.place.line - 1]
    assert found.place.element == "link 'upper'"


def test_a_known_issue_gives_the_finding_its_fix(arm):
    found = findings(arm, "dart")
    wrong = [one for one in found if one.severity == "error"]
    assert {(one.rule, one.subject) for one in wrong} == {
        (IDS["default-inertia"], "link 'tool'"),
        (IDS["default-inertia"], "link 'plate'"),
    }
    assert all("expand --for dart" in one.fix for one in wrong)
    assert {round(one.value, 9) for one in wrong} == {1.0}


def test_a_known_issue_explains_all_kinds_of_its_engine(arm):
    """Drake's replaced tensors are found as a moved centre of mass or another mass as well."""
    lighter = arm.source.urdf.replace('<mass value="2.5"/>', '<mass value="2.6"/>')
    other = read_urdf(lighter.encode(), file="other.urdf", base="base", tip="tool")
    (found,) = audit(Honest(other).imported_model(), arm, "drake").harmful
    assert found.kind == "mass-changed"
    assert found.known_issue.id == "drake-impossible-tensor"


def test_a_kind_of_limit_is_one_finding_for_all_joints(arm, plant):
    found = {one.rule: one for one in findings(arm, plant("LimitsLost"))}
    assert found.keys() == {IDS["position-limit"], IDS["velocity-limit"], IDS["effort-limit"]}
    velocity = found[IDS["velocity-limit"]]
    lines = arm.source.urdf.splitlines()
    assert ["pan" in lines[p.line - 1] for p in velocity.places] == [True, False]
    assert "lift" in lines[velocity.places[1].line - 1]
    assert velocity.subject == "2 joints"


def test_limits_are_notes_and_another_order_is_a_warning(arm, plant):
    assert {one.severity for one in findings(arm, plant("LimitsLost"))} == {"note"}
    (order,) = findings(arm, plant("OrderOfItsOwn"))
    assert (order.rule, order.severity) == (IDS["order"], "warning")


def test_refusals_and_unexplained_torques_are_findings(arm, plant):
    (refused,) = findings(arm, plant("Refusing"))
    assert (refused.rule, refused.effect) == (IDS["model-refused"], None)
    (wrong,) = findings(arm, plant("Miscalculating"))
    assert wrong.rule == IDS["torque-unexplained"]
    assert 0.0 < wrong.effect < 1e-5


def test_another_representation_of_the_same_arm_is_no_finding(arm, plant):
    assert findings(arm, plant("Merging")) == ()


def test_every_kind_that_is_wrong_has_a_rule():
    wrong = {kind for kind, (bearing, _) in KINDS.items() if bearing != "nothing"}
    assert wrong <= set(IDS)
    severities = {rule.name: rule.severity for rule in RULES}
    assert all(severities[k] == "error" for k, (b, _) in KINDS.items() if b == "torque")
