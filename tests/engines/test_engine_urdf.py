"""Engines read the arm's text without meshes and with the joints beside the arm fixed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from ur5check._engines.conformance_arms import URDF, as_value, in_text
from ur5check._engines.engine_urdf import parsed, root_link, text_for_engines
from ur5check._errors import EngineError


def arm_of(text):
    arm = in_text()
    return replace(arm, source=replace(arm.source, urdf=text))


def test_joints_beside_the_arm_are_fixed_and_those_of_the_arm_are_not():
    root = parsed(arm_of(text_for_engines(in_text())))
    types = {joint.get("name"): joint.get("type") for joint in root.iterchildren("joint")}
    assert types["finger_joint"] == "fixed"
    assert {types[name] for name in in_text().joint_names} == {
        "revolute",
        "prismatic",
        "continuous",
    }


def test_meshes_are_left_out_and_other_shapes_stay():
    mesh = '<visual><geometry><mesh filename="package://p/m.stl"/></geometry></visual>'
    text = text_for_engines(
        arm_of(URDF.replace('<link name="finger">', f'<link name="finger">{mesh}'))
    )
    assert "mesh" not in text
    assert '<box size="0.1 0.1 0.1"/>' in text


@pytest.mark.parametrize(("offset", "refused"), [("0", False), ("0.1", True)])
def test_a_mimicking_joint_that_stands_away_from_zero_is_refused(offset, refused):
    mimic = f'<child link="finger"/><mimic joint="turn" offset="{offset}"/>'
    arm = arm_of(URDF.replace('<child link="finger"/>', mimic))
    if refused:
        with pytest.raises(EngineError, match="'finger_joint' beside the arm"):
            text_for_engines(arm)
    else:
        assert "mimic" not in text_for_engines(arm)


def test_the_root_is_the_link_without_a_parent():
    assert root_link(parsed(in_text())) == "base_link"


def test_an_arm_without_a_urdf_has_no_text():
    with pytest.raises(EngineError, match="did not come from a URDF"):
        text_for_engines(as_value())
