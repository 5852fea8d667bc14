"""SDF is read as libsdformat means it, its silent defaults excepted; Drake's dynamics judges."""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

import numpy as np
import pytest
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import MultibodyForces

import ur5check
from ur5check._errors import ModelError
from ur5check._robot.states import random_states

INERTIAL = """<inertial><pose>0.01 0.02 0.1 0.3 0.2 0.1</pose><mass>2</mass><inertia>
  <ixx>0.1</ixx><ixy>0.01</ixy><ixz>0.02</ixz><iyy>0.12</iyy><iyz>0.005</iyz><izz>0.11</izz>
  </inertia></inertial>"""
MODEL = """\
  <model name="two">
    <pose>0 0 1 0.1 0.2 0.3</pose>
    <frame name="desk"><pose>0.3 0 0 0 0 1</pose></frame>
    <link name="stand"><pose relative_to="desk">0 0.1 0 0 0 0.5</pose></link>
    <link name="upper"><pose relative_to="stand">0 0 0.4 0.1 0 0</pose>{upper}</link>
    <link name="lower"><pose relative_to="elbow">0 0 0.2 0 0.2 0</pose>{lower}</link>
    <joint name="foot" type="fixed"><parent>world</parent><child>stand</child></joint>
    <joint name="shoulder" type="{kind}"><parent>stand</parent><child>upper</child>
      <pose>0 0 -0.2 0 0 0.4</pose>
      <axis><xyz{expressed}>0 1 0</xyz>
        <limit><lower>-1</lower><upper>2</upper><effort>7</effort><velocity>3</velocity></limit>
        <dynamics><damping>0.5</damping><friction>0.25</friction></dynamics></axis></joint>
    <joint name="elbow" type="{elbow}">
      <pose relative_to="upper">0 0 0.3 0 0 0</pose><parent>upper</parent><child>lower</child>
      {axis}</joint>
    {inside}
  </model>
"""
AXIS = "<axis><xyz>1 0 1</xyz><limit><effort>4</effort></limit></axis>"


def text_of(**parts: str) -> str:
    plain = {"kind": "revolute", "elbow": "continuous", "axis": AXIS, "expressed": "", "inside": ""}
    model = MODEL.format(**(plain | {"upper": INERTIAL, "lower": INERTIAL} | parts))
    return f'<sdf version="1.9">\n{model}</sdf>\n'


@pytest.fixture
def read(tmp_path: Path):
    def load(text: str, **options: str):
        path = tmp_path / "two.sdf"
        path.write_text(text, encoding="utf-8")
        return ur5check.load(path, **options)

    return load


def gap(arm, text: str) -> float:
    """Largest difference from Drake's inverse dynamics [N m], damping given back."""
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(text, "sdf")
    plant.Finalize()
    context = plant.CreateDefaultContext()
    states, worst = random_states(arm.n, 10, seed=3), 0.0
    tau = ur5check.rnea(arm, states.q, states.qd, states.qdd)
    damping = np.array([joint.damping for joint in arm.joints])
    for k in range(len(states)):
        plant.SetPositions(context, states.q[k])
        plant.SetVelocities(context, states.qd[k])
        forces = MultibodyForces(plant)
        plant.CalcForceElementsContribution(context, forces)
        theirs = plant.CalcInverseDynamics(context, states.qdd[k], forces)
        worst = max(worst, float(np.abs(theirs - damping * states.qd[k] - tau[k]).max()))
    return worst


@pytest.mark.parametrize(
    "parts",
    [
        {},
        {"kind": "prismatic"},
        {"expressed": ' expressed_in="desk"'},
        {"lower": INERTIAL.replace("<pose>", '<pose degrees="true">')},
        {"lower": INERTIAL.replace("<pose>0.01 0.02 0.1 0.3 0.2 0.1",
                                   '<pose rotation_format="quat_xyzw">0 0 0.1 0.5 0.5 0.5 0.5')},
        {"lower": INERTIAL + '<visual name="v"><geometry><mesh><uri>file:///no.stl</uri></mesh>'
                             "</geometry></visual>"},
    ],
)  # fmt: skip
def test_torques_are_drakes(read, parts):
    text = text_of(**parts)
    assert gap(read(text), text) <= 1e-10


def test_limits_losses_and_origin(read):
    text = text_of()
    arm = read(text)
    first, second = arm.joints
    limits = first.limits
    assert (limits.lower, limits.upper, limits.velocity, limits.effort) == (-1.0, 2.0, 3.0, 7.0)
    assert (first.damping, first.friction) == (0.5, 0.25)
    assert (second.limits.lower, second.limits.effort) == (None, 4.0)
    source = arm.source
    assert (source.kind, source.base, source.tip) == ("sdf", "stand", "lower")
    assert source.inputs[0][1] == hashlib.sha256(text.encode()).hexdigest()


def test_base_may_be_the_world(read):
    arm = read(text_of(), base="world")
    np.testing.assert_allclose(arm.gravity, (0, 0, -9.81), atol=1e-14)
    assert gap(arm, text_of()) <= 1e-10


@pytest.mark.parametrize(
    ("gravity", "expected", "noted"),
    [("<gravity>0 0 -9</gravity>", 9.0, False), ("", 9.8, True)],
)
def test_gravity_is_the_worlds(read, gravity, expected, noted):
    text = text_of().replace("<model", f'<world name="w">{gravity}<model')
    arm = read(text.replace("</model>", "</model></world>"))
    np.testing.assert_allclose(np.linalg.norm(arm.gravity), expected, rtol=1e-14)
    assert any("names no gravity" in note for note in arm.source.notes) == noted


@pytest.mark.parametrize(
    ("parts", "said"),
    [
        ({"lower": ""}, "two.sdf:9: link 'lower': moves and has no <inertial>: SDFormat gives"),
        ({"lower": INERTIAL.replace("<mass>2</mass>", "")}, "SDFormat gives it 1 kg;"),
        ({"lower": INERTIAL.replace("<ixx>0.1</ixx>", "")}, "SDFormat gives it 1 kg m²"),
        ({"lower": INERTIAL.replace("<pose>", '<pose relative_to="stand">')},
         "is relative to another"),
        ({"lower": "<gravity>false</gravity>" + INERTIAL}, "gravity is switched off"),
        ({"elbow": "ball", "axis": ""}, "is ball: neither revolute nor prismatic"),
        ({"inside": '<model name="hand"><link name="x"/></model>'}, "<model>: is not followed"),
        ({"inside": '<joint name="tie" type="fixed"><parent>stand</parent><child>lower</child>'
                    "</joint>"}, "joint 'tie': is the child of two joints"),
        ({"axis": AXIS.replace("</xyz>", "</xyz><dynamics><spring_stiffness>1</spring_stiffness>"
                               "</dynamics>")}, "joint 'elbow' spring_stiffness: is a spring"),
        ({"axis": AXIS.replace("1 0 1", "1 0 nan")}, "is not finite"),
        ({"axis": AXIS.replace("</xyz>", '</xyz><mimic joint="shoulder"><multiplier>1</multiplier>'
                               "<offset>0</offset><reference>0</reference></mimic>")},
         "joint 'elbow': mimics 'shoulder'"),
    ],
)  # fmt: skip
def test_what_no_serial_arm_can_hold_is_refused(read, parts, said):
    with pytest.raises(ModelError) as raised:
        read(text_of(**parts))
    assert said in str(raised.value)


def test_two_models_are_one_too_many(read):
    text = text_of()
    model = text.partition("\n")[2].rpartition("</sdf>")[0]
    with pytest.raises(ModelError, match="holds 2 models, and this one"):
        read(text.replace("</sdf>", model.replace('"two"', '"three"') + "</sdf>"))


def test_a_dropped_inertial_orientation_would_be_seen(read):
    """The planted fault: the tensor read along the link's axes."""
    plain = INERTIAL.replace("0.3 0.2 0.1</pose>", "0 0 0</pose>")
    assert gap(read(text_of(lower=plain)), text_of()) > 0.01


def test_without_drake_the_extra_is_named(read, monkeypatch):
    monkeypatch.setitem(sys.modules, "pydrake", None)
    with pytest.raises(ModelError, match=r"pip install 'ur5check\[drake\]'"):
        read(text_of())
