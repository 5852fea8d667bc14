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
from ur5check._io.ros_packages import example_robot_data
from ur5check._io.urdf.urdf_checks import check_urdf
from ur5check._io.urdf.urdf_values import Robot
from ur5check._io.urdf.urdf_writer import urdf_of

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


def assert_same_numbers(text: bytes) -> tuple[int, int]:
    """Every joint and link; returns how many there were."""
    ours, other = Robot(check_urdf(text, "robot.urdf"), "robot.urdf"), theirs(text)
    assert ours.name == other.name
    edges = {edge.joint: edge for edge in ours.tree.above.values()}
    assert len(edges) == len(other.joints)
    for joint in other.joints:
        edge = edges[joint.name]
        assert (edge.kind, edge.parent, edge.child) == (joint.type, joint.parent, joint.child)
        origin = np.eye(4) if joint.origin is None else joint.origin
        np.testing.assert_allclose(ours.joint_origin(edge).matrix(), origin, atol=2e-15)
        assert ours.mimicked(joint.name) == (None if joint.mimic is None else joint.mimic.joint)
        if not edge.moves or edge.kind in ("floating", "planar"):
            continue
        mine = ours.joint(edge)
        axis = joint.axis / np.linalg.norm(joint.axis)
        np.testing.assert_allclose(mine.axis, axis, atol=1e-15)
        if joint.limit is not None:
            given = (joint.limit.lower or 0.0, joint.limit.upper or 0.0)
            bounds = (None, None) if edge.kind == "continuous" else given
            assert (mine.limits.lower, mine.limits.upper) == bounds
            given = (joint.limit.velocity, joint.limit.effort)
            assert (mine.limits.velocity, mine.limits.effort) == given
        losses = joint.dynamics
        # yourdfpy keeps these two as text.
        assert mine.damping == float((losses and losses.damping) or 0.0)
        assert mine.friction == float((losses and losses.friction) or 0.0)
    for link in other.links:
        body = ours.inertia(link.name)
        assert (body is None) == (link.inertial is None)
        if body is not None:
            pose = np.eye(4) if link.inertial.origin is None else link.inertial.origin
            assert body.mass == link.inertial.mass
            np.testing.assert_array_equal(body.com, pose[:3, 3])
            R = pose[:3, :3]
            tensor = R @ link.inertial.inertia @ R.T
            np.testing.assert_allclose(body.tensor, tensor, atol=1e-14 * np.abs(tensor).max())
    return len(other.joints), len(other.links)


@pytest.mark.parametrize("path", ROBOTS, ids=lambda path: path.stem)
def test_every_example_robot_that_is_accepted(path: Path) -> None:
    text = path.read_bytes()
    try:
        check_urdf(text, path.name)
    except ModelError:
        with pytest.raises(ModelError):
            ur5check.load(path)
        return
    joints, links = assert_same_numbers(text)
    assert links == joints + 1


@pytest.mark.parametrize("name", ["paper", "appendix"])
def test_a_written_urdf(name: str) -> None:
    joints, _ = assert_same_numbers(urdf_of(ur5check.load(name)).encode())
    assert joints >= 6


def test_a_joint_without_axis_moves_about_x() -> None:
    text = urdf_of(ur5check.load("paper"))
    start = text.index("<axis")
    bare = text[:start] + text[text.index(">", start) + 1 :]
    assert_same_numbers(bare.encode())
    robot = Robot(check_urdf(bare.encode(), "bare.urdf"), "bare.urdf")
    edge = next(edge for edge in robot.tree.above.values() if edge.moves)
    np.testing.assert_array_equal(robot.joint(edge).axis, [1.0, 0.0, 0.0])
