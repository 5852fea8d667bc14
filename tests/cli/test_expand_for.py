"""`expand --for ENGINE`: with that file the engine, left to itself, holds the right arm."""

from __future__ import annotations

import dartpy
import mujoco
import numpy as np
import pytest
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant

import ur5check as ur5
from ur5check._engines.captured_warnings import captured_output
from ur5check._robot.states import random_states

STATE = random_states(6, 1, seed=3)
Q, QD, QDD = STATE.q[0], STATE.qd[0], STATE.qdd[0]


@pytest.fixture
def expand(ur5check, tmp_path):
    """`expand(engine)`: the appendix for that engine as a file, and what was said of it."""

    def run(engine: str | None):
        file = tmp_path / f"for_{engine}.urdf"
        option = ["--for", engine] if engine else []
        said = ur5check("expand", "appendix", *option, "-o", file)
        assert said.code == 0
        return file, said.err

    return run


def expected():
    return ur5.rnea(ur5.load("appendix"), Q, QD, QDD)


def torque_of_mujoco(file):
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    data.qpos, data.qvel, data.qacc = Q, QD, QDD
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    mujoco.mj_inverse(model, data)
    return np.array(data.qfrc_inverse)


def torque_of_dart(text):
    with captured_output():
        skeleton = dartpy.utils.DartLoader().parseSkeletonString(text, dartpy.common.Uri(""))
    assert skeleton.getNumDofs() == 6  # the root does not float
    skeleton.setPositions(Q)
    skeleton.setVelocities(QD)
    skeleton.setAccelerations(QDD)
    skeleton.computeInverseDynamics()
    return np.array(skeleton.getForces())


def plant_of(text):
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(text, "urdf")
    plant.Finalize()
    return plant


def test_mujoco_reads_it_rightly_meshes_and_all(expand):
    file, said = expand("mujoco")
    assert "mujoco-mass-from-shape" in said
    assert np.abs(torque_of_mujoco(file) - expected()).max() < 1e-10
    assert mujoco.MjModel.from_xml_path(str(file)).nmesh == 7


def test_mujoco_weighs_the_tools_shape_without_it(expand):
    file, _ = expand("mujoco")
    spoiled = file.read_text("utf-8").replace('inertiafromgeom="false"', "")
    file.write_text(spoiled, "utf-8")
    assert np.abs(torque_of_mujoco(file) - expected()).max() > 1e-3


def test_dart_reads_it_rightly(expand):
    file, said = expand("dart")
    assert "dart-default-inertia" in said
    assert "dart-floating-root" in said
    assert np.abs(torque_of_dart(file.read_text("utf-8")) - expected()).max() < 1e-10


def test_drake_welds_the_root_and_keeps_efforts(expand):
    file, said = expand("drake")
    assert "drake-floating-root" in said
    assert plant_of(file.read_text("utf-8")).num_positions() == 6


def test_drake_lets_the_root_float_without_it(expand):
    file, _ = expand(None)
    assert plant_of(file.read_text("utf-8")).num_positions() == 13


def test_drake_gets_a_transmission_where_there_is_none(ur5check, tmp_path):
    file = tmp_path / "bare.urdf"
    bare = tmp_path / "source.urdf"
    ur5check("convert", "appendix", "--to", "urdf", "-o", bare)
    assert "<transmission" not in bare.read_text("utf-8")
    assert ur5check("expand", bare, "--for", "drake", "-o", file).code == 0
    plant = plant_of(file.read_text("utf-8"))
    limits = [plant.get_joint_actuator(k).effort_limit() for k in plant.GetJointActuatorIndices()]
    assert limits == [150.0, 150.0, 150.0, 28.0, 28.0, 28.0]


def test_gazebo_gets_a_world_and_a_base_that_weighs(ur5check, tmp_path):
    light = tmp_path / "paper.urdf"
    ur5check("convert", "paper", "--to", "urdf", "-o", light)
    text, limit = light.read_text("utf-8"), '<limit effort="1.7976931348623157e+308" velocity="1"/>'
    light.write_text(text.replace("</joint>", f"{limit}</joint>", 1), "utf-8")
    said = ur5check("expand", light, "--for", "gazebo")
    assert said.code == 0
    for known_issue in ("gazebo-floating-root", "gazebo-massless-base", "gazebo-no-limit"):
        assert known_issue in said.err
    heavy = tmp_path / "heavy.urdf"
    heavy.write_text(said.out, "utf-8")
    arms = ur5.load("paper"), ur5.load(heavy, base="base_link")
    torques = [ur5.rnea(arm, Q, QD, QDD) for arm in arms]
    assert np.abs(torques[0] - torques[1]).max() < 1e-12


def test_a_name_that_the_remedy_needs_is_refused(ur5check, expand, tmp_path):
    file, _ = expand(None)
    taken = tmp_path / "taken.urdf"
    text = file.read_text("utf-8").replace('"ee_link"', '"world"')
    taken.write_text(text, "utf-8")
    said = ur5check("expand", taken, "--for", "dart")
    assert said.code == 2
    assert "the name is taken" in said.err
    assert said.out == ""


def test_an_engine_that_needs_nothing_is_said(ur5check):
    said = ur5check("expand", "appendix", "--for", "pinocchio")
    assert said.code == 2
    assert "choose mujoco, drake, dart, gazebo" in said.err


def test_a_mesh_that_is_nowhere_is_left_out_and_said(ur5check, expand, tmp_path):
    file, _ = expand(None)
    text = file.read_text("utf-8").replace("collision/base.stl", "collision/nothing.stl")
    lost = tmp_path / "lost.urdf"
    lost.write_text(text, "utf-8")
    said = ur5check("expand", lost, "--for", "mujoco")
    assert said.code == 0
    assert "a shape is left out" in said.err
    assert "nothing.stl" not in said.out
