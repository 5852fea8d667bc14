"""The whole robot of a URDF, faults and all: every fault a finding, reading goes on."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ur5check._io.urdf.urdf_robot import read_urdf_robot
from ur5check._io.xml.xml_tree import parse_xml
from ur5check._rules.examples import joint, link, robot
from ur5check._rules.finding_log import FindingLog


def read(text: str):
    log = FindingLog()
    return read_urdf_robot(parse_xml(text.encode(), "r.urdf"), log), log.findings


def test_a_sound_robot_is_read_with_all_its_numbers():
    found, findings = read(robot())
    assert not findings
    arm = found.link["arm"].inertial
    assert arm.mass == 2.0
    np.testing.assert_array_equal(arm.xyz, [0, 0, 0.1])
    assert arm.entries["izz"] == 0.002
    assert found.joint["j"].limits.effort == 20.0
    assert found.joint["j"].origin.p[2] == 0.3
    assert found.roots == ("base",)
    assert found.mass == 2.0


def test_every_fault_of_a_file_is_found_in_one_run():
    text = robot(
        joint(limit='<limit lower="-1" upper="1" effort="a" velocity="1"/>'),
        link(mass="-", ixx=""),
        joint("k", kind="hinge", parent="arm", child="tip"),
        link("tip"),
        link("tip"),
    )
    _, findings = read(text)
    assert sorted(f.rule for f in findings) == ["JNT100", "TRE101", "XML103", "XML103", "XML103"]


def test_a_number_that_is_none_becomes_nan_and_keeps_its_place():
    found, (finding,) = read(robot(joint(), link(mass="2,5")))
    assert math.isnan(found.link["arm"].inertial.mass)
    assert not found.link["arm"].inertial.readable
    assert finding.value == "2,5"
    line = robot(joint(), link(mass="2,5")).splitlines()[finding.place.line - 1]
    assert line[finding.place.column - 1 :].startswith('2,5"')


@pytest.mark.parametrize("gap", ["\u00a0", "\u2003", "\u3000"])
def test_a_space_that_is_no_xml_space_parts_no_numbers(gap):
    _, findings = read(robot(joint(origin=f'<origin xyz="0{gap}0 0.3"/>'), link()))
    assert [f.rule for f in findings] == ["XML103"]


def test_the_axis_of_a_fixed_joint_has_no_meaning():
    text = robot(
        joint(), link(), joint("f", "fixed", "arm", "tip", axis='<axis xyz="1"/>'), link("tip")
    )
    assert not read(text)[1]


def test_an_axis_of_absurd_length_keeps_its_direction():
    found, _ = read(robot(joint(axis='<axis xyz="0 3e200 4e200"/>'), link()))
    np.testing.assert_allclose(found.joint["j"].axis, [0, 0.6, 0.8], rtol=1e-15)


def test_a_loop_leaves_a_forest():
    text = robot(joint(), link(), joint("k", parent="arm", child="arm"))
    found, findings = read(text)
    assert [f.rule for f in findings] == ["TRE104"]
    assert [one.name for one in found.joints] == ["j"]
    assert list(found.down("base")) == ["base", "arm"]


def test_printed_digits_give_the_roundings_of_a_tensor():
    found, _ = read(robot(joint(), link(ixx="0.0024", iyy="0.166", izz="0.1684083")))
    rounding = found.link["arm"].inertial.rounding
    assert rounding["ixx"] == rounding["iyy"] == rounding["izz"] == pytest.approx(5e-8)
    assert rounding["ixy"] == 0.0
