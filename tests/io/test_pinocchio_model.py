"""A `pin.Model` becomes the arm that Pinocchio computes with, or an error naming the joint."""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio as pin
import pytest

from kinematics_comparison import assert_same_inertias, assert_same_kinematics
from ur5check._errors import ModelError
from ur5check._io.pinocchio_model import read_pinocchio_model
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._robot import Limits
from urdf_examples import GOOD, robot_path

SLANTED = np.array([1.0, 2.0, -3.0]) / np.sqrt(14.0)
INDEFINITE = np.array([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, -1.0])
BODY = pin.Inertia(2.0, np.array([0.1, 0.2, 0.3]), np.diag([0.2, 0.3, 0.4]))


def unbounded_unaligned() -> Any:
    """Python cannot give this class its axis; a URDF's continuous joint can."""
    text = GOOD.replace('type="prismatic"', 'type="continuous"').replace('"0 3 4"', '"1 2 -3"')
    model = pin.buildModelFromXML(text)
    return model.joints[model.getJointId("j2")]


SIMPLE = {
    "RX": (pin.JointModelRX, "revolute", [1, 0, 0]),
    "RY": (pin.JointModelRY, "revolute", [0, 1, 0]),
    "RZ": (pin.JointModelRZ, "revolute", [0, 0, 1]),
    "RUBX": (pin.JointModelRUBX, "revolute", [1, 0, 0]),
    "RUBY": (pin.JointModelRUBY, "revolute", [0, 1, 0]),
    "RUBZ": (pin.JointModelRUBZ, "revolute", [0, 0, 1]),
    "RU": (lambda: pin.JointModelRevoluteUnaligned(SLANTED), "revolute", SLANTED),
    "RUBU": (unbounded_unaligned, "revolute", SLANTED),
    "PX": (pin.JointModelPX, "prismatic", [1, 0, 0]),
    "PY": (pin.JointModelPY, "prismatic", [0, 1, 0]),
    "PZ": (pin.JointModelPZ, "prismatic", [0, 0, 1]),
    "PU": (lambda: pin.JointModelPrismaticUnaligned(SLANTED), "prismatic", SLANTED),
}


def chain(*joints: Any) -> Any:
    """A model of these joints in a row, at random placements, each carrying a body."""
    pin.seed(3)
    model = pin.Model()
    model.name = "chain"
    parent = 0
    for i, joint in enumerate(joints):
        parent = model.addJoint(parent, joint, pin.SE3.Random(), f"j{i}")
        model.appendBodyToJoint(parent, BODY, pin.SE3.Random())
        model.addBodyFrame(f"body{i}", parent, pin.SE3.Identity(), 0)
    model.addFrame(pin.Frame("hand", parent, pin.SE3.Random(), pin.FrameType.BODY))
    model.addFrame(pin.Frame("floor", 0, pin.SE3.Random(), pin.FrameType.BODY))
    return model


@pytest.mark.parametrize(("make", "kind", "axis"), SIMPLE.values(), ids=SIMPLE)
def test_every_joint_of_one_coordinate_is_read(make: Any, kind: str, axis: Any) -> None:
    model = chain(pin.JointModelRZ(), make(), pin.JointModelRX())
    arm = read_pinocchio_model(model, tip="hand")
    assert arm.joints[1].kind == kind
    np.testing.assert_allclose(arm.joints[1].axis, axis, atol=1e-15)
    assert_same_kinematics(arm, model, None, "hand")
    assert_same_inertias(arm, model)


def test_base_and_tip_name_frames_and_gravity_is_seen_from_the_base() -> None:
    model = chain(pin.JointModelRZ(), pin.JointModelRY())
    model.gravity.linear = np.array([0.0, 1.0, -9.0])
    arm = read_pinocchio_model(model, base="floor", tip="hand")
    assert_same_kinematics(arm, model, "floor", "hand")
    floor = model.frames[model.getFrameId("floor")].placement.rotation
    np.testing.assert_allclose(floor @ arm.gravity, [0.0, 1.0, -9.0], atol=1e-14)
    assert (arm.source.base, arm.source.tip) == ("floor", "hand")


def test_ends_default_to_the_universe_and_the_last_joint() -> None:
    arm = read_pinocchio_model(chain(pin.JointModelRZ()))
    assert (arm.name, arm.source.base, arm.source.tip) == ("chain", "universe", "j0")
    assert [link.name for link in arm.links] == ["body0"]


def test_limits_are_kept_and_their_absence_too() -> None:
    model = pin.Model()
    bounds = [np.array([value]) for value in (7.0, 3.0, -1.0, 2.0)]
    model.addJoint(0, pin.JointModelRX(), pin.SE3.Identity(), "a", *bounds)
    model.appendBodyToJoint(1, BODY, pin.SE3.Identity())
    assert read_pinocchio_model(model).joints[0].limits == Limits(-1.0, 2.0, 3.0, 7.0)
    free = read_pinocchio_model(chain(pin.JointModelRX(), pin.JointModelRUBX()))
    assert [joint.limits for joint in free.joints] == [Limits(), Limits()]


def test_the_hash_is_the_models_own() -> None:
    model = chain(pin.JointModelRX())
    first, second = read_pinocchio_model(model), read_pinocchio_model(model.copy())
    assert first.source.inputs == second.source.inputs
    assert first.source.model is model
    model.inertias[1] = BODY
    assert read_pinocchio_model(model).source.inputs != first.source.inputs


def test_the_model_is_not_touched() -> None:
    model = chain(pin.JointModelRX(), pin.JointModelRUBX())
    before = model.copy()
    read_pinocchio_model(model, tip="hand")
    assert model == before


@pytest.mark.parametrize("name", ["ur5_robot.urdf", "kinova.urdf", "xarm7.urdf"])
def test_it_is_the_arm_that_the_urdf_reader_makes(name: str) -> None:
    text = robot_path(name).read_text()
    ours = read_urdf(text.encode(), file=name)
    theirs = read_pinocchio_model(pin.buildModelFromXML(text), tip=ours.source.tip)
    assert theirs.joint_names == ours.joint_names
    for mine, other in zip(ours.links, theirs.links, strict=True):
        assert mine.name == other.name
        np.testing.assert_allclose(
            mine.link_tip_frame.matrix(), other.link_tip_frame.matrix(), atol=1e-15
        )
    np.testing.assert_allclose(theirs.parameters(), ours.parameters(), atol=1e-14)


def test_a_tensor_rounded_in_its_urdf_is_taken_here_too() -> None:
    model = chain(pin.JointModelRX())
    model.inertias[1] = pin.Inertia(1.0, np.zeros(3), np.diag([0.0333333, 0.0333333, 0.0666667]))
    assert read_pinocchio_model(model).n == 1


def floating() -> Any:
    return pin.buildModelFromXML(GOOD, pin.JointModelFreeFlyer())


def composite() -> Any:
    joint = pin.JointModelComposite()
    joint.addJoint(pin.JointModelRX())
    return chain(joint)


def mimic() -> Any:
    follower = '<axis xyz="0 3 4"/><mimic joint="j1"/>'
    text = GOOD.replace('<axis xyz="0 3 4"/>', follower).replace(
        'type="prismatic"', 'type="revolute"'
    )
    return pin.buildModelFromXML(text, mimic=True)


def with_body(body: Any) -> Any:
    model = chain(pin.JointModelRX())
    model.inertias[1] = body
    return model


REFUSED = {
    "empty": (pin.Model, ["has no joint"]),
    "floating base": (floating, ["joint 'root_joint'", "FreeFlyer"]),
    "branch": (lambda: pin.buildModelFromXML(robot_path("panda.urdf").read_text()),
               ["joint 'panda_finger_joint2'", "not one chain", "buildReducedModel"]),
    "spherical": (lambda: chain(pin.JointModelRX(), pin.JointModelSpherical()), ["joint 'j1'"]),
    "planar": (lambda: chain(pin.JointModelPlanar()), ["joint 'j0'", "Planar"]),
    "screw": (lambda: chain(pin.JointModelHX(0.1)), ["joint 'j0'", "turns and slides"]),
    "composite": (composite, ["joint 'j0'", "Composite"]),
    "mimic": (mimic, ["joint 'j2'", "Mimic"]),
    "negative mass": (lambda: with_body(pin.Inertia(-1.0, np.zeros(3), np.eye(3))), ["negative"]),
    "massless tip": (lambda: with_body(pin.Inertia.Zero()), ["'j0' mass", "moving tip"]),
    "triangle": (lambda: with_body(pin.Inertia(1.0, np.zeros(3), np.diag([1.0, 1.0, 3.0]))),
                 ["joint 'j0' inertia", "triangle"]),
    "indefinite": (lambda: with_body(pin.Inertia.FromDynamicParameters(INDEFINITE)),
                   ["joint 'j0' inertia", "positive definite"]),
}  # fmt: skip


@pytest.mark.parametrize(("make", "words"), REFUSED.values(), ids=REFUSED)
def test_what_is_no_serial_arm_is_refused_by_name(make: Any, words: list[str]) -> None:
    with pytest.raises(ModelError) as caught:
        read_pinocchio_model(make())
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(("option", "name"), [("base", "hand"), ("tip", "hnad")])
def test_a_frame_that_the_end_does_not_carry_is_refused(option: str, name: str) -> None:
    with pytest.raises(ModelError, match=f"{option}: is no frame carried by"):
        read_pinocchio_model(chain(pin.JointModelRX(), pin.JointModelRY()), **{option: name})
