"""A URDF made fit for Gazebo weighs what it weighed, and hangs where it hung."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from lxml import etree

import ur5check
from examples import random_arm
from ur5check._errors import ModelError
from ur5check._io.gazebo.gazebo_model import GazeboModel, gazebo_model
from ur5check._io.number_text import exact
from ur5check._io.ros_packages import PackageMap, default_packages
from ur5check._io.shipped_models import lookup
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._io.urdf.urdf_writer import NO_LIMIT, urdf_of
from ur5check._io.xacro.xacro_reader import expand_xacro

BODY = """<inertial><origin xyz="0.1 0 0.2"/><mass value="2"/>
  <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>"""
#: A tilted torso that carries an arm of one joint and a gripper, whose finger copies the thumb.
TORSO = f"""<robot name="torso">
  <link name="torso"/>
  <joint name="lean" type="revolute"><parent link="torso"/><child link="shoulder"/>
    <origin rpy="0 0.5 0"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="9" velocity="1"/></joint>
  <link name="shoulder">{BODY}</link>
  <joint name="swing" type="continuous"><parent link="shoulder"/><child link="hand"/>
    <origin xyz="0 0 0.3"/><axis xyz="0 1 0"/></joint>
  <link name="hand">{BODY}</link>
  <joint name="thumb_joint" type="prismatic"><parent link="hand"/><child link="thumb"/>
    <origin xyz="0 0 0.1"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="1" effort="9" velocity="1"/></joint>
  <link name="thumb">{BODY}</link>
  <joint name="finger_joint" type="prismatic"><parent link="hand"/><child link="finger"/>
    <axis xyz="1 0 0"/><mimic joint="thumb_joint" multiplier="-1" offset="0.25"/>
    <limit lower="0" upper="1" effort="9" velocity="1"/></joint>
  <link name="finger">{BODY}</link>
  <transmission name="t"><type>x</type></transmission>
  <gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>
  <gazebo><plugin name="camera" filename="libcamera.so"/></gazebo>
</robot>"""


def model_of(arm, packages: PackageMap | None = None, file: str = "x.urdf") -> GazeboModel:
    return gazebo_model(arm, package="p", packages=packages or default_packages(), file=file)


def swinging_arm(text: str = TORSO):
    return read_urdf(text.encode(), file="torso.urdf", base="shoulder", tip="hand")


@pytest.mark.parametrize("name", ["appendix", "erd-ur5"])
def test_the_same_torques_limited_or_not(name):
    arm = ur5check.load(name)
    q = np.random.default_rng(3).uniform(-3, 3, (50, 6))
    for text in (model_of(arm).urdf, model_of(arm).limited):
        again = read_urdf(text.encode(), file="exported", base=arm.source.base, tip=arm.source.tip)
        tau = ur5check.gravity_torque(arm, q)
        np.testing.assert_allclose(ur5check.gravity_torque(again, q), tau, atol=1e-13)


def test_limited_is_what_the_xacros_own_argument_makes():
    """Two ways to the limited arm: the paper's macro, and ours for any URDF."""
    ours = read_urdf(model_of(ur5check.load("appendix")).limited.encode(), file="l", tip="tool0")
    entry = lookup("appendix")
    expansion = expand_xacro(
        entry.path(), arguments={"limited": "true"}, packages=default_packages()
    )
    theirs = read_urdf(expansion.text.encode(), file="x", base=entry.base, tip=entry.tip)
    assert [j.limits for j in ours.joints] == [j.limits for j in theirs.joints]
    assert [j.limits for j in ours.joints] != [j.limits for j in ur5check.load("appendix").joints]


def test_a_base_is_fixed_to_the_world():
    root = etree.fromstring(model_of(ur5check.load("erd-ur5")).urdf.encode())
    parents = {
        j.find("child").get("link"): j.find("parent").get("link") for j in root.iter("joint")
    }
    link = "tool0"
    while link in parents:
        link = parents[link]
    assert link == "world"


def test_what_lies_outside_the_arm_is_held_where_ur5check_holds_it():
    arm = swinging_arm()
    model = model_of(arm)
    root = etree.fromstring(model.urdf.encode())
    kinds = {j.get("name"): j.get("type") for j in root.iterchildren("joint")}
    assert [name for name, kind in kinds.items() if kind != "fixed"] == ["swing"]
    assert root.find("joint[@name='finger_joint']/origin").get("xyz") == "0.25 0.0 0.0"
    assert not root.findall("joint/mimic")
    again = read_urdf(model.urdf.encode(), file="again", base="shoulder", tip="hand")
    for q in (-1.0, 0.4):
        assert ur5check.gravity_torque(again, [q]) == pytest.approx(
            ur5check.gravity_torque(arm, [q]), rel=1e-14
        )
    assert any("'lean'" in note and "'finger_joint'" in note for note in model.notes)


def test_gravity_is_turned_into_the_worlds_frame():
    """The torso leans by 0.5 rad: straight down for the arm is aslant in the world."""
    arm = swinging_arm()
    np.testing.assert_allclose(model_of(arm).gravity, [0.0, 0.0, -9.81], atol=1e-15)
    leaning = 9.81 * np.array([-np.sin(0.5), 0.0, -np.cos(0.5)])
    along_z = arm.with_gravity((0.0, 0.0, -9.81))
    np.testing.assert_allclose(model_of(along_z).gravity, leaning, atol=1e-15)


def test_other_peoples_control_is_left_out_and_nothing_else():
    model = model_of(swinging_arm())
    assert "ros_control" not in model.urdf and "<transmission" not in model.urdf
    assert "libcamera.so" in model.urdf
    assert any("transmissions" in note for note in model.notes)


def test_a_continuous_joint_gets_limits_only_when_limited():
    model = model_of(swinging_arm())
    assert 'type="continuous"' in model.urdf
    limit = etree.fromstring(model.limited.encode()).find("joint[@name='swing']/limit")
    assert (limit.get("lower"), limit.get("upper")) == (exact(-np.pi), exact(np.pi))


def test_a_link_that_gazebo_would_drop_is_refused():
    no_mass = BODY.replace('value="2"', 'value="0"').replace('="0.1"', '="0"')
    palm = f"""<link name="palm">{BODY}</link><joint name="turn" type="continuous">
      <parent link="hand"/><child link="palm"/></joint>"""
    weightless = TORSO.replace(
        f'<link name="hand">{BODY}</link>', f'<link name="hand">{no_mass}</link>{palm}'
    )
    for name in ("thumb", "finger"):
        weightless = weightless.replace(
            f'<link name="{name}">{BODY}</link>', f'<link name="{name}"/>'
        )
    arm = read_urdf(weightless.encode(), file="w.urdf", base="shoulder", tip="palm")
    with pytest.raises(ModelError, match=r"'hand'.*Gazebo drops such a link"):
        model_of(arm)


def test_a_taken_name_is_refused():
    arm = swinging_arm(TORSO.replace('"thumb"', '"world"'))
    with pytest.raises(ModelError, match=r"'world'.*the name is taken"):
        model_of(arm)


def test_meshes_come_along_and_two_of_a_name_stay_two(tmp_path: Path):
    shapes = ""
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "part.stl").write_text(folder)
        shapes += f'<visual><geometry><mesh filename="{folder}/part.stl"/></geometry></visual>'
    shapes += '<collision><geometry><mesh filename="lost.stl"/></geometry></collision>'
    text = TORSO.replace('<link name="hand">', f'<link name="hand">{shapes}')
    model = model_of(swinging_arm(text), file=str(tmp_path / "torso.urdf"))
    read = {inside: file.read_text() for inside, file in model.meshes.items()}
    assert read == {"meshes/visual/part.stl": "a", "meshes/visual/part_2.stl": "b"}
    names = [m.get("filename") for m in etree.fromstring(model.urdf.encode()).iter("mesh")]
    assert names == [f"package://p/{inside}" for inside in read]
    assert any("'hand' has no collision here" in note for note in model.notes)


def mass_of(text: str, link: str) -> str:
    return etree.fromstring(text.encode()).find(f"link[@name='{link}']/inertial/mass").get("value")


@pytest.mark.parametrize("root", ["torso", "world"])
def test_a_base_that_gazebo_would_drop_is_given_mass(root):
    """With the whole arm; whether the file brings a world of its own or not."""
    text = TORSO.replace('"torso"', f'"{root}"').replace(
        '"lean" type="revolute"', '"l" type="fixed"'
    )
    bare = text.replace(f'<link name="shoulder">{BODY}', '<link name="shoulder">')
    model = model_of(swinging_arm(bare))
    assert mass_of(model.urdf, {"torso": "torso", "world": "shoulder"}[root]) == "1"
    assert any("loads no joint" in note for note in model.notes)
    arm, again = (
        read_urdf(t.encode(), file="t", base="shoulder", tip="hand") for t in (bare, model.urdf)
    )
    tau = ur5check.gravity_torque(arm, [0.3])
    assert ur5check.gravity_torque(again, [0.3]) == pytest.approx(tau, rel=1e-14)


def test_a_base_that_has_mass_keeps_it():
    model = model_of(ur5check.load("appendix"))
    assert float(mass_of(model.urdf, "base_link")) == 4.0
    assert not any("loads no joint" in note for note in model.notes)


def test_no_limit_is_written_as_sdformat_writes_it():
    """The largest double in 16 digits, as SDFormat prints it, is out of range when read again."""
    arm = random_arm(4, seed=0)  # knows no limits; a sliding joint must have them
    assert any(joint.kind == "prismatic" for joint in arm.joints)
    described = read_urdf(urdf_of(arm).encode(), file="written")
    assert exact(NO_LIMIT) in described.source.urdf
    model = model_of(described)
    for text in (model.urdf, model.limited):
        assert exact(NO_LIMIT) not in text
        limits = etree.fromstring(text.encode()).iterfind("joint/limit")
        assert max(abs(float(x)) for limit in limits for x in limit.attrib.values()) == 1e16
