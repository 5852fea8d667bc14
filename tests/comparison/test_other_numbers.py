"""What else than geometry and inertias differs is found, with both values and places."""

from __future__ import annotations

from dataclasses import replace

import pytest

import ur5check
from ur5check._errors import UsageError
from ur5check._robot import Limits

URDF = """<robot name="r">
  <link name="base"/>
  <link name="rod"><inertial><origin xyz="0.2 0 0"/><mass value="2"/>
    <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="hinge" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" velocity="2" effort="{effort}"/>
    <dynamics damping="{damping}" friction="{friction}"/>
  </joint>
</robot>
"""


def written(tmp_path, name, **values):
    file = tmp_path / f"{name}.urdf"
    file.write_text(URDF.format(**{"effort": 30, "damping": 0.5, "friction": 0.1, **values}))
    return file


def test_equal_files_have_the_same_dynamics(tmp_path):
    d = ur5check.diff(written(tmp_path, "a"), written(tmp_path, "b"), samples=20)
    assert d.others == ()
    assert d.agrees
    assert "same dynamics" in d.verdict


@pytest.mark.parametrize(
    ("key", "quantity", "line"),
    [("damping", "damping", 7), ("friction", "friction", 7), ("effort", "effort limit", 6)],
)
def test_a_difference_beside_the_torques_is_one(tmp_path, key, quantity, line):
    a, b = written(tmp_path, "a"), written(tmp_path, "b", **{key: 7})
    d = ur5check.diff(a, b, samples=20)
    (other,) = d.others
    assert (other.quantity, other.joint, other.b) == (quantity, "hinge", 7.0)
    assert str(other.place_a) == f"{a}:{line}:5"
    assert str(other.place_b) == f"{b}:{line}:5"
    assert d.same_torques
    assert not d.agrees
    assert "same dynamics" not in d.verdict


def test_what_one_source_leaves_out_is_shown_and_no_contradiction(tmp_path):
    arm = ur5check.load(written(tmp_path, "a"))
    silent = replace(arm, joints=(replace(arm.joints[0], limits=Limits()),))
    d = ur5check.diff(arm, silent, samples=20)
    assert {other.quantity for other in d.others} == {
        "lower limit", "upper limit", "velocity limit", "effort limit",
    }  # fmt: skip
    assert d.agrees
    assert "same dynamics" not in d.verdict


def test_limits_are_compared_in_the_same_coordinates():
    """The second arm's joint is reversed and shifted: its limits are the first one's."""
    arm = ur5check.load("appendix")
    joints = list(arm.joints)
    limits = joints[1].limits
    turned = replace(limits, lower=-limits.upper, upper=-limits.lower)
    joints[1] = replace(joints[1], axis=-joints[1].axis, limits=turned)
    d = ur5check.diff(arm, replace(arm, joints=tuple(joints)), samples=20)
    assert d.agrees
    assert not [other for other in d.others if "limit" in other.quantity]


def test_gravity_and_total_mass():
    arm = ur5check.load("appendix")
    moon = ur5check.diff(arm, arm.with_gravity((0, 0, -1.62)), samples=20)
    assert [(o.quantity, o.b) for o in moon.others] == [("gravity", (0.0, 0.0, -1.62))]
    heavier = arm.with_inertias(
        [replace(x.inertia, mass=x.inertia.mass + 0.5 * (i == 2)) for i, x in enumerate(arm.links)]
    )
    (mass,) = ur5check.diff(arm, heavier, samples=20).others
    assert mass.quantity == "total mass"
    assert mass.b - mass.a == pytest.approx(0.5)


def test_a_tolerance_in_newton_metres_or_of_the_effort_limits():
    arm = ur5check.load("appendix")
    heavier = arm.with_inertias([replace(x.inertia, mass=1.01 * x.inertia.mass) for x in arm.links])
    assert not ur5check.diff(arm, heavier, samples=100).same_torques
    assert ur5check.diff(arm, heavier, samples=100, tolerance=20.0).same_torques
    assert ur5check.diff(arm, heavier, samples=100, tolerance="10%").same_torques
    assert not ur5check.diff(arm, heavier, samples=100, tolerance="0.01%").same_torques
    for meaningless in ("-1", "much", "nan"):
        with pytest.raises(UsageError):
            ur5check.diff(arm, heavier, samples=10, tolerance=meaningless)
    with pytest.raises(UsageError):
        ur5check.diff("paper", "paper-listing", samples=10, tolerance="2%")  # no effort limits
