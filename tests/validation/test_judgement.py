"""The verdict on one model: rules and laws, kept apart."""

from __future__ import annotations

import numpy as np
import pytest

from ur5check._errors import UsageError
from ur5check._io.loading import load
from ur5check._io.ros_packages import example_robot_data
from ur5check._io.shipped_models import SHIPPED_MODELS
from ur5check._rules.examples import joint, link, robot
from ur5check._validation.judgement import judge


def write(folder, text, name="arm.urdf"):
    file = folder / name
    file.write_text(text)
    return file


def rules_of(judgement):
    return [finding.rule for finding in judgement.findings]


def test_a_sound_model_passes_and_its_laws_hold(tmp_path):
    j = judge(write(tmp_path, robot()), samples=20)
    assert j.passed("note")
    assert j.laws is not None
    assert j.laws_hold
    assert j.arm.joint_names == ("j",)


@pytest.mark.parametrize("model", SHIPPED_MODELS)
def test_a_shipped_model_is_judged_as_the_arm_that_load_gives(model):
    judged, loaded = judge(model, samples=5, meshes=False).arm, load(model)
    assert (judged.source.base, judged.source.tip) == (loaded.source.base, loaded.source.tip)
    for ours, theirs in zip(judged.links, loaded.links, strict=True):
        assert np.allclose(ours.link_tip_frame.matrix(), theirs.link_tip_frame.matrix(), atol=1e-15)
        assert np.allclose(ours.inertia.parameters(), theirs.inertia.parameters(), atol=1e-15)


def test_impossible_numbers_fail_although_every_law_holds(tmp_path):
    j = judge(write(tmp_path, robot(joint(), link(ixx="80", iyy="80", izz="80"))), samples=20)
    assert j.laws_hold
    assert not j.passed()
    assert rules_of(j)[0] == "INE109"


def test_a_fault_beside_the_arm_does_not_block_it(tmp_path):
    text = robot(
        joint(),
        link(),
        joint("f", "fixed", "base", "camera", axis="", limit=""),
        link("camera", mass="nan"),
    )
    j = judge(write(tmp_path, text), samples=20)
    assert rules_of(j) == ["XML103"]
    assert j.arm is not None
    assert not j.passed()


def test_an_arm_without_dynamics_is_not_computed(tmp_path):
    j = judge(write(tmp_path, robot(joint(), link(mass="-1"))), samples=20)
    assert j.laws is None
    assert "INE101" in j.laws_note
    assert j.laws_hold


@pytest.mark.parametrize(
    ("name", "text", "rule"),
    [
        ("a.urdf", "<robot", "XML101"),
        ("a.urdf", "no xml at all", "XML101"),
        ("a.urdf", "<sdf/>", "XML102"),
        ("a.urdf", '<robot name="r"/>', "TRE105"),
        ("a.xacro", "<robot", "XML101"),
        ("a.toml", "name = ", "XML100"),
    ],
)
def test_a_file_that_is_no_robot_is_a_finding(tmp_path, name, text, rule):
    j = judge(write(tmp_path, text, name))
    assert rule in rules_of(j)[0] or rules_of(j)[0].startswith("XAC")
    assert not j.passed()


@pytest.mark.parametrize("model", ["papre", "nowhere.urdf", "/"])
def test_a_name_that_means_nothing_is_wrong_usage(model):
    with pytest.raises(UsageError):
        judge(model)


def test_a_payload_counts_in_the_holding_torque_only(tmp_path):
    flange = joint("f", "fixed", "arm", "tool", '<origin xyz="0 0 0.5"/>', axis="", limit="")
    file = write(tmp_path, robot(joint(), link(), flange, '<link name="tool"/>'))
    assert judge(file, samples=5).passed("note")
    heavy = judge(file, samples=5, payload=10.0)
    assert rules_of(heavy) == ["ROB104"]
    assert heavy.robot.mass == 2.0
    # 2 kg at 0.1 m and 10 kg at 0.5 m, held level, at least nearly.
    most = 9.81 * (2 * 0.1 + 10 * 0.5)
    assert 0.99 * most < heavy.findings[0].value <= most


def test_the_expected_mass_is_compared_with_all_links(tmp_path):
    file = write(tmp_path, robot())
    assert rules_of(judge(file, samples=5, expected_mass=2.05)) == []
    assert rules_of(judge(file, samples=5, expected_mass=3.0)) == ["ROB101"]


def test_wrists_of_example_robot_data_are_beyond_their_meshes():
    j = judge("erd-ur5", samples=20)
    found = {f.subject: f for f in j.findings if f.rule == "INE108"}
    assert {"link 'wrist_1_link'", "link 'wrist_2_link'", "link 'wrist_3_link'"} <= set(found)
    # ½ · 1.219 · 0.6² is written for a cylinder of radius 0.06: σ = 0.6/2 along two axes.
    assert found["link 'wrist_1_link'"].value == pytest.approx(0.3, rel=0.01)


def test_every_file_of_example_robot_data_gets_a_verdict():
    files = sorted((example_robot_data() / "robots").rglob("*.urdf"))
    assert len(files) >= 69
    for file in files:
        j = judge(file, samples=5, meshes=False)
        assert j.laws_hold, file
        assert j.arm is not None or j.arm_note, file


def test_a_tree_too_deep_for_pinocchios_parser_is_judged_without_it(tmp_path):
    chain = [joint(), link()]
    for k in range(1200):
        parent = "arm" if k == 0 else f"l{k - 1}"
        chain += [
            joint(f"f{k}", "fixed", parent, f"l{k}", axis="", limit=""),
            f'<link name="l{k}"/>',
        ]
    j = judge(write(tmp_path, robot(*chain)), samples=5)
    assert j.arm.source.tip == "l1199"
    assert j.laws is None
    assert "1,000" in j.laws_note
