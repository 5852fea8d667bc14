"""Our reading of a URDF's numbers against yourdfpy's, a reader that shares no code with it."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from yourdfpy import URDF

import ur5check
from ur5check._errors import ModelError
from ur5check._finding import Finding
from ur5check._io.ros_packages import example_robot_data
from ur5check._io.urdf.urdf_reader import read_robot_of_urdf
from ur5check._io.urdf.urdf_writer import urdf_of
from ur5check._robot.robot import Robot

SHARE = example_robot_data()
assert SHARE is not None
ROBOTS = sorted(SHARE.glob("robots/**/*.urdf"))


def theirs(text: bytes) -> Any:
    """As yourdfpy has it, without meshes."""
    return URDF.load(
        BytesIO(text),
        build_scene_graph=False,
        load_meshes=False,
        build_collision_scene_graph=False,
        load_collision_meshes=False,
    ).robot


def ours(text: bytes) -> tuple[Robot, tuple[Finding, ...]]:
    """As `read_robot_of_urdf` has it, with errors only."""
    robot, findings = read_robot_of_urdf(text, file="robot.urdf")
    assert robot is not None
    return robot, tuple(finding for finding in findings if finding.severity == "error")


def assert_same_numbers(robot: Robot, text: bytes) -> None:
    """Every joint and link."""
    other = theirs(text)
    assert robot.name == other.name
    assert len(robot.joints) == len(other.joints)
    for joint in other.joints:
        mine = robot.joint[joint.name]
        assert (mine.kind, mine.parent, mine.child) == (joint.type, joint.parent, joint.child)
        origin = np.eye(4) if joint.origin is None else joint.origin
        np.testing.assert_allclose(mine.origin.matrix(), origin, atol=2e-15)
        assert (mine.mimic and mine.mimic.joint) == (joint.mimic and joint.mimic.joint)
        if mine.kind in ("fixed", "floating", "planar"):
            continue
        if joint.axis.any():
            axis = joint.axis / np.linalg.norm(joint.axis)
            np.testing.assert_allclose(mine.axis, axis, atol=1e-15)
        if joint.limit is not None:
            given = (joint.limit.lower or 0.0, joint.limit.upper or 0.0)
            bounds = (None, None) if mine.kind == "continuous" else given
            assert (mine.limits.lower, mine.limits.upper) == bounds
            given = (joint.limit.velocity, joint.limit.effort)
            assert (mine.limits.velocity, mine.limits.effort) == given
        losses = joint.dynamics
        # yourdfpy keeps these two as text.
        assert mine.damping == float((losses and losses.damping) or 0.0)
        assert mine.friction == float((losses and losses.friction) or 0.0)
    for link in other.links:
        inertial = robot.link[link.name].inertial
        assert (inertial is None) == (link.inertial is None)
        if inertial is not None:
            body = inertial.inertia
            pose = np.eye(4) if link.inertial.origin is None else link.inertial.origin
            assert body.mass == link.inertial.mass
            np.testing.assert_array_equal(body.com, pose[:3, 3])
            R = pose[:3, :3]
            tensor = R @ link.inertial.inertia @ R.T
            np.testing.assert_allclose(body.tensor, tensor, atol=1e-14 * np.abs(tensor).max())


@pytest.mark.parametrize("path", ROBOTS, ids=lambda path: path.stem)
def test_every_example_robot_that_can_be_read(path: Path) -> None:
    text = path.read_bytes()
    robot, errors = ours(text)
    if errors:
        with pytest.raises(ModelError):
            ur5check.load_robot(path)
        return
    assert_same_numbers(robot, text)
    assert len(robot.links) == len(robot.joints) + 1


@pytest.mark.parametrize("name", ["paper", "appendix"])
def test_a_written_urdf(name: str) -> None:
    text = urdf_of(ur5check.load(name)).encode()
    robot, errors = ours(text)
    assert not errors
    assert len(robot.joints) >= 6
    assert_same_numbers(robot, text)


def test_a_joint_without_axis_moves_about_x() -> None:
    text = urdf_of(ur5check.load("paper"))
    start = text.index("<axis")
    bare = (text[:start] + text[text.index(">", start) + 1 :]).encode()
    robot, _ = ours(bare)
    assert_same_numbers(robot, bare)
    first = next(joint for joint in robot.joints if joint.moves)
    np.testing.assert_array_equal(first.axis, [1.0, 0.0, 0.0])
