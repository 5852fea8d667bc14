"""MJCF is read as MuJoCo means it: its own inverse dynamics is the judge."""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

import ur5check
from ur5check._errors import ModelError, UsageError
from ur5check._robot.states import random_states

INERTIAL = '<inertial pos="0 0 0.1" mass="2" fullinertia="0.1 0.12 0.11 0.01 0.02 0.005"/>'
ARM = """\
<mujoco model="two">
  <compiler angle="degree"/>
  {top}
  <worldbody>
    <body name="stand" pos="0 0 1" euler="0 90 0">
      <body name="upper" pos="0.1 0 0.2" quat="1 2 3 4">
        {upper}
        <joint name="shoulder" axis="0 1 0" {shoulder}/>
        <site name="mark" pos="0 0 0.3" euler="10 20 30"/>
        <body name="lower" pos="0 0 0.5" axisangle="1 0 0 30">
          {lower}
          <joint name="elbow" axis="1 1 0" {elbow}/>
          {inside}
        </body>
      </body>
    </body>
  </worldbody>
  {bottom}
</mujoco>
"""


def text_of(**parts: str) -> str:
    empty = dict.fromkeys(("top", "shoulder", "elbow", "inside", "bottom"), "")
    return ARM.format(**(empty | {"upper": INERTIAL, "lower": INERTIAL} | parts))


@pytest.fixture
def read(tmp_path: Path):
    def load(text: str, **options: str):
        path = tmp_path / "two.xml"
        path.write_text(text, encoding="utf-8")
        return ur5check.load(path, **options)

    return load


def gap(arm, text: str) -> float:
    """Largest difference from mj_inverse [N m], what passive forces take being given back."""
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    data = mujoco.MjData(model)
    states, worst = random_states(arm.n, 10, seed=3), 0.0
    tau = ur5check.rnea(arm, states.q, states.qd, states.qdd)
    for k in range(len(states)):
        data.qpos[:], data.qvel[:], data.qacc[:] = states.q[k], states.qd[k], states.qdd[k]
        mujoco.mj_inverse(model, data)
        worst = max(worst, float(np.abs(data.qfrc_inverse + data.qfrc_passive - tau[k]).max()))
    return worst


@pytest.mark.parametrize(
    "parts",
    [
        {},
        {"shoulder": 'ref="25" armature="0.3" damping="2" frictionloss="1" range="-90 90"'},
        {"shoulder": 'pos="0.1 0.2 0.3"', "elbow": 'type="slide" pos="1 2 3" ref="0.2"'},
        {"inside": '<joint name="twist" pos="0 0.1 0" axis="0 0 1" ref="40"/>'},
        {"lower": '<inertial pos="0 0 0" mass="1" quat="1 1 0 1" diaginertia="0.1 0.2 0.15"/>'},
        {"lower": '<inertial pos="0 0 0" mass="1" euler="9 8 7" diaginertia="0.1 0.2 0.15"/>'},
        {"lower": '<geom type="capsule" size="0.05 0.2" pos="0 0 0.2" euler="5 6 7"/>'},
        {"top": '<option gravity="1 2 -9"/>'},
        {"top": '<default><joint armature="0.5"/></default>'},
        {"inside": f'<frame pos="0 0 1" euler="1 2 3"><body name="x">{INERTIAL}</body></frame>'},
        {"top": '<compiler inertiafromgeom="true"/>', "upper": f'{INERTIAL}<geom size="0.1"/>',
         "lower": '<geom size="0.2"/>'},
        {"bottom": '<actuator><motor joint="elbow" gear="3" armature="0.2"/></actuator>'},
    ],
)  # fmt: skip
def test_torques_are_mujocos(read, parts):
    text = text_of(**parts)
    assert gap(read(text), text) <= 1e-10


def test_base_is_the_body_in_the_world_and_the_world_can_be_asked_for(read):
    arm = read(text_of())
    assert (arm.source.kind, arm.source.base, arm.source.tip) == ("mjcf", "stand", "lower")
    np.testing.assert_allclose(arm.gravity, (9.81, 0.0, 0.0), atol=1e-14)
    from_world = read(text_of(), base="world")
    np.testing.assert_array_equal(from_world.gravity, (0.0, 0.0, -9.81))
    assert gap(from_world, text_of()) <= 1e-10


def test_gravity_switched_off_is_no_gravity(read):
    arm = read(text_of(top='<option><flag gravity="disable"/></option>'))
    assert not arm.gravity.any()


def test_a_site_may_be_the_tip(read):
    arm = read(text_of(), tip="mark")
    assert (arm.n, arm.source.tip) == (1, "mark")
    np.testing.assert_allclose(arm.links[0].link_tip_frame.p, (0, 0, 0.3))


def test_held_joints_beside_the_chain_are_welded_as_described(read):
    branch = f'<body name="finger">{INERTIAL}<joint name="grip" ref="30" pos="0 0.1 0"/></body>'
    arm = read(text_of(inside=branch), tip="lower")
    assert "held still, being outside the arm: 'grip'" in arm.source.notes
    without = read(
        text_of(inside=branch.replace('<joint name="grip" ref="30" pos="0 0.1 0"/>', ""))
    )
    np.testing.assert_allclose(arm.parameters(), without.parameters(), atol=1e-14)


def test_masses_made_of_shapes_are_said(read):
    arm = read(text_of(lower='<geom type="sphere" size="0.1"/>'))
    (note,) = arm.source.notes
    assert note.endswith("made by MuJoCo's compiler, not written in the file: 'lower'")


def test_masses_changed_by_the_compiler_are_said_with_its_warning(read):
    arm = read(text_of(top='<compiler settotalmass="9"/>'))
    np.testing.assert_allclose([link.inertia.mass for link in arm.links], (4.5, 4.5))
    warned, made = arm.source.notes
    assert "'settotalmass' is deprecated" in warned
    assert made.endswith("not written in the file: 'upper', 'lower'")


def test_several_joints_in_a_body_are_links_without_mass(read):
    arm = read(text_of(inside='<joint name="twist" axis="0 0 1"/>'))
    assert [link.inertia.mass for link in arm.links] == [2.0, 0.0, 2.0]
    assert "moving link 'elbow' has mass zero" in arm.source.notes


@pytest.mark.parametrize(
    ("parts", "effort"),
    [
        ({"elbow": 'actuatorfrcrange="-7 7"'}, 7.0),
        ({"elbow": 'actuatorfrcrange="-7 8"'}, None),
        ({"bottom": '<actuator><motor joint="elbow" gear="-2" ctrlrange="-3 3"/></actuator>'}, 6.0),
        ({"bottom": '<actuator><position joint="elbow" forcerange="-5 5"/></actuator>'}, 5.0),
        ({"bottom": '<actuator><position joint="elbow" ctrlrange="-3 3"/></actuator>'}, None),
        ({"bottom": '<actuator><motor joint="elbow" ctrlrange="-3 3"/>'
                    '<motor joint="elbow" ctrlrange="-3 3"/></actuator>'}, None),
    ],
)  # fmt: skip
def test_effort_is_read_where_it_is_one_number(read, parts, effort):
    assert read(text_of(**parts)).joints[1].limits.effort == effort


def test_degrees_and_losses(read):
    joint = read(text_of(shoulder='range="-90 45" damping="2" frictionloss="1"')).joints[0]
    np.testing.assert_allclose((joint.limits.lower, joint.limits.upper), (-np.pi / 2, np.pi / 4))
    assert (joint.damping, joint.friction) == (2.0, 1.0)


def test_names_that_are_missing_are_made(read):
    text = text_of().replace('name="upper"', "").replace('name="elbow"', "")
    arm = read(text)
    assert (arm.links[0].name, arm.joint_names) == ("body_2", ("shoulder", "joint_1"))


def test_missing_meshes_do_not_matter_where_masses_are_written(read):
    mesh = (
        '<asset><mesh name="m" file="no.stl"/><texture type="2d" name="t" file="no.png"/></asset>'
    )
    arm = read(text_of(top=mesh, inside='<geom type="mesh" mesh="m"/>'))
    assert len(arm.source.inputs) == 1


MESH = '<compiler meshdir="meshes"/><asset><mesh name="m" file="box.stl"/></asset>'
SHAPED = {"top": MESH, "lower": '<geom type="mesh" mesh="m"/>'}


def test_a_mesh_that_makes_a_mass_is_hashed(read, tmp_path):
    data = trimesh.creation.box((0.1, 0.2, 0.3)).export(file_type="stl")
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "box.stl").write_bytes(data)
    arm = read(text_of(**SHAPED))
    assert ("meshes/box.stl", hashlib.sha256(data).hexdigest()) in arm.source.inputs
    np.testing.assert_allclose(arm.links[1].inertia.mass, 6.0, rtol=1e-6)  # STL keeps floats


def test_a_mesh_that_makes_a_mass_must_be_there(read):
    with pytest.raises(ModelError, match=r"body 'lower': .*'meshes/box.stl', which cannot be read"):
        read(text_of(**SHAPED))


def test_included_files_are_read_hashed_and_named_in_errors(read, tmp_path):
    part = tmp_path / "part.xml"
    part.write_text(f"<mujoco>\n\n{INERTIAL}\n</mujoco>")
    text = text_of(lower='<include file="part.xml"/>')
    arm = read(text)
    assert ("part.xml", hashlib.sha256(part.read_bytes()).hexdigest()) in arm.source.inputs
    np.testing.assert_array_equal(arm.parameters(), read(text_of()).parameters())
    part.write_text("<mujoco>\n\n" + INERTIAL.replace('mass="2"', 'mass="-2"') + "\n</mujoco>")
    negative = "^part.xml:3: body 'lower' inertial/mass: mass is negative"
    with pytest.raises(ModelError, match=negative):
        read(text)


def test_constraints_inside_a_held_gripper_are_no_matter(read):
    fingers = "".join(
        f'<body name="{side}">{INERTIAL}<joint name="{side}_j"/></body>' for side in ("l", "r")
    )
    tie = (
        '<equality><joint joint1="l_j" joint2="r_j"/>'
        '<connect body1="l" body2="r" anchor="0 0 0"/></equality>'
    )
    assert read(text_of(inside=fingers, bottom=tie), tip="lower").n == 2


TENDON = '<tendon><fixed name="t" {}><joint joint="elbow" coef="1"/></fixed></tendon>'


@pytest.mark.parametrize(
    ("parts", "said"),
    [
        ({"bottom": '<equality><joint joint1="elbow" joint2="shoulder"/></equality>'},
         "two.xml:12: joint 'elbow': mimics 'shoulder'"),
        ({"bottom": '<equality><weld body1="lower"/></equality>'}, ":18: equality 'weld': couples"),
        ({"bottom": TENDON.format('stiffness="3"')}, "two.xml:18: tendon 't': couples"),
        ({"elbow": 'type="ball"'}, "is ball: neither revolute"),
        ({"elbow": 'stiffness="3"'}, "joint 'elbow' stiffness: is a spring"),
        ({"elbow": 'range="30 -30"'}, "two.xml:12: joint 'elbow' range: its limits are swapped"),
        ({"elbow": 'armature="nan"'}, "two.xml:12: joint 'elbow' armature: "),
        ({"top": '<option density="1.2"/>'}, "two.xml:3: <option>: density"),
        ({"inside": '<plugin plugin="x"/>'}, "<plugin>: is code"),
        ({"inside": '<include file="none.xml"/>'}, "two.xml:13: <include> file: the file"),
        ({"elbow": 'bad="3"'}, "two.xml:12: 'joint': MuJoCo refuses it: Schema violation"),
        ({"lower": ""}, "two.xml:10: 'lower': MuJoCo refuses it: mass and inertia of moving"),
    ],
)  # fmt: skip
def test_what_no_serial_arm_can_hold_is_refused(read, parts, said):
    with pytest.raises(ModelError) as raised:
        read(text_of(**parts))
    assert said in str(raised.value)


def test_an_idle_tendon_is_no_matter(read):
    assert read(text_of(bottom=TENDON.format(""))).n == 2


def test_gravity_compensation_is_refused(read):
    with pytest.raises(ModelError, match="takes weight away"):
        read(text_of().replace('name="lower"', 'name="lower" gravcomp="1"'))


def test_a_free_body_stands_where_the_file_puts_it(read):
    free = text_of().replace('<body name="upper"', f'{INERTIAL}<freejoint/><body name="upper"')
    arm, fixed = read(free), read(text_of())
    np.testing.assert_array_equal(arm.parameters(), fixed.parameters())
    np.testing.assert_array_equal(arm.gravity, fixed.gravity)


def test_an_option_of_another_kind_is_refused(read, tmp_path):
    read(text_of())
    with pytest.raises(UsageError, match="no meaning for an MJCF file"):
        ur5check.load(tmp_path / "two.xml", arguments={"a": "1"})


def test_a_dropped_inertial_orientation_would_be_seen(read):
    """The planted fault: what other readers have done to MJCF and URDF."""
    turned = '<inertial pos="0 0 0" mass="1" quat="1 1 0 1" diaginertia="0.1 0.2 0.15"/>'
    plain = turned.replace('quat="1 1 0 1" ', "")
    assert gap(read(text_of(lower=plain)), text_of(lower=turned)) > 0.01


def test_a_urdf_may_be_called_xml(tmp_path):
    path = tmp_path / "arm.xml"
    text = ur5check.load("appendix").source.urdf
    path.write_text(text, encoding="utf-8")
    assert ur5check.load(path, tip="tool0").source.kind == "urdf"


def test_two_models_of_one_robot_agree(read, tmp_path):
    """`ur5check diff my.xml appendix`, in Python."""
    from ur5check._io.mjcf.mjcf_writer import mjcf_of

    path = tmp_path / "my.xml"
    path.write_text(mjcf_of(ur5check.load("appendix")), encoding="utf-8")
    difference = ur5check.diff(path, "appendix", samples=50)
    assert difference.agrees


def test_without_mujoco_the_extra_is_named(read, monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(ModelError, match=r"pip install 'ur5check\[mujoco\]'"):
        read(text_of())
