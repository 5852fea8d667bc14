"""Sizes without shapes: what stands, what is drawn at a wrist, dummies, and names like sides."""

from __future__ import annotations

import pytest

from ur5check._rules.examples import joint, link, robot
from ur5check._validation.judgement import judge

CABINET = (
    '<inertial><origin xyz="0 0 -0.6"/><mass value="300"/>'
    '<inertia ixx="30" ixy="0" ixz="0" iyy="30" iyz="0" izz="20"/></inertial>'
)
CUBE = '<collision><geometry><box size="0.01 0.01 0.01"/></geometry></collision>'


def rules_of(tmp_path, *parts, of: str | None = None):
    """Findings by rule, of one subject if `of` names it."""
    file = tmp_path / "arm.urdf"
    file.write_text(robot(*parts))
    found = judge(file, samples=5).findings
    return {f.rule: f for f in found if of is None or of in f.subject}


def test_what_stands_may_be_as_large_as_the_robot(tmp_path):
    """A cabinet below the arm is no fault; the same body as a link of 0.1 m is."""
    stand = joint("s", "fixed", child="stand", axis="", limit="")
    rest = (joint(parent="stand"), link())
    assert rules_of(tmp_path, stand, link("stand", inertial=CABINET), *rest) == {}
    tip = (joint("k", parent="arm", child="tip", origin='<origin xyz="0 0 0.1"/>'), link("tip"))
    found = rules_of(tmp_path, joint(origin=""), link(inertial=CABINET), *tip, of="link 'arm'")
    assert {"INE111", "INE112"} <= set(found)


def test_a_standing_body_in_other_units_is_still_found(tmp_path):
    stand = joint("s", "fixed", child="stand", axis="", limit="")
    millimetres = CABINET.replace('ixx="30"', 'ixx="3e7"').replace('iyy="30"', 'iyy="3e7"')
    found = rules_of(
        tmp_path, stand, link("stand", inertial=millimetres), joint(parent="stand"), link()
    )
    assert found["INE109"].severity == "error"


@pytest.mark.parametrize(("ixx", "seen"), [("0.04", False), ("4", True)])
def test_a_forearm_may_be_drawn_at_the_wrist(tmp_path, ixx, seen):
    """0.14 m of spread fit into the 0.5 m back to the elbow, although the next joint is here."""
    forearm = joint("k", parent="arm", child="forearm", origin='<origin xyz="0 0 0.5"/>')
    body = link("forearm", ixx=ixx, iyy=ixx)
    hand = joint("l", parent="forearm", child="hand", origin="", axis='<axis xyz="0 0 1"/>')
    tip = link("hand", ixx="0.0002", iyy="0.0002", izz="0.0001", mass="0.2")
    found = rules_of(tmp_path, joint(), link(), forearm, body, hand, tip, of="forearm")
    assert ("INE109" in found) == seen


@pytest.mark.parametrize(("mass", "seen"), [("0.01", False), ("0.1", True)])
def test_dummies_have_no_density(tmp_path, mass, seen):
    frame = joint("f", "fixed", "arm", "imu", axis="", limit="")
    imu = link("imu", mass=mass, ixx="1e-7", iyy="1e-7", izz="1e-7", shapes=CUBE)
    assert ("INE111" in rules_of(tmp_path, joint(), link(), frame, imu, of="imu")) == seen


def test_links_named_like_sides_in_one_chain_are_no_pair(tmp_path):
    """Yaskawa's axes are called S, L, U, R, B, T: link_l carries link_r."""
    chain = [joint(child="link_l"), link("link_l")]
    chain += [joint("k", parent="link_l", child="link_r"), link("link_r", mass="3")]
    assert "ROB103" not in rules_of(tmp_path, *chain)
    pair = [*chain[:2], joint("k", child="link_r"), link("link_r", mass="3")]
    assert "ROB103" in rules_of(tmp_path, *pair)


BOX = (
    '<collision><origin xyz="0 0 0.1"/><geometry><box size="0.1 0.1 0.25"/></geometry></collision>'
)


@pytest.mark.parametrize(
    ("moment", "said", "unsaid"),
    [
        ("0.03", (), ("tensor were in", "placeholder")),  # 1.7 times: no unit explains so little
        ("1", ("placeholder",), ("tensor were in",)),
        ("8e6", ("g mm²",), ("placeholder",)),
    ],
)
def test_a_unit_is_named_only_where_it_explains_the_excess(tmp_path, moment, said, unsaid):
    body = link(ixx=moment, iyy=moment, izz=moment, shapes=BOX)
    finding = rules_of(tmp_path, joint(), body)["INE108"]
    assert all(words in finding.message for words in said)
    assert not any(words in finding.message for words in unsaid)
