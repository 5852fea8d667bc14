"""Meshes as files: found, hashed, scaled and placed, and what the rules see in them."""

from __future__ import annotations

import hashlib
import os

import numpy as np
import pytest
import trimesh

from ur5check._io.meshes.mesh_reader import MeshReader
from ur5check._io.ros_packages import PackageMap
from ur5check._rules.examples import joint, link, robot
from ur5check._validation.judgement import judge

SIZE = (0.1, 0.1, 0.25)  # of the example's link [m]
STEEL = 7850.0


def mesh_shape(uri: str, z: float = 0.1, scale: str = "") -> str:
    geometry = f'<geometry><mesh filename="{uri}"{scale}/></geometry>'
    return f'<collision><origin xyz="0 0 {z}"/>{geometry}</collision>'


def write(folder, text, *, unit: float = 1.0, suffix: str = "stl"):
    """A robot's file, and beside it a box as a mesh; `unit` is a metre in the mesh's numbers."""
    trimesh.creation.box(np.array(SIZE) * unit).export(folder / f"box.{suffix}")
    file = folder / "arm.urdf"
    file.write_text(text)
    return file


def found(file, **options):
    return {f.rule: f for f in judge(file, samples=5, **options).findings}


@pytest.mark.parametrize("suffix", ["stl", "obj", "ply", "off", "glb"])
def test_a_mesh_is_scaled_and_placed(tmp_path, suffix):
    text = robot(joint(), link(shapes=mesh_shape(f"box.{suffix}", 0.1, ' scale="2 1 1"')))
    judged = judge(write(tmp_path, text, suffix=suffix), samples=5)
    (shape,) = judged.robot.link["arm"].shapes
    body = MeshReader(tmp_path, PackageMap({}))(shape, "link 'arm'")
    np.testing.assert_allclose(np.ptp(body.points, axis=0), (0.2, 0.1, 0.25), rtol=1e-6)
    np.testing.assert_allclose(body.points.mean(axis=0), (0.0, 0.0, 0.1), atol=1e-6)
    np.testing.assert_allclose(body.volume, 2 * np.prod(SIZE), rtol=1e-6)


def test_every_mesh_is_among_the_inputs(tmp_path):
    file = write(tmp_path, robot(joint(), link(shapes=mesh_shape("box.stl"))))
    inputs = dict(judge(file, samples=5).inputs)
    assert inputs["box.stl"] == hashlib.sha256((tmp_path / "box.stl").read_bytes()).hexdigest()
    assert inputs[str(file)] == hashlib.sha256(file.read_bytes()).hexdigest()
    assert "box.stl" not in dict(judge(file, samples=5, meshes=False).inputs)


@pytest.mark.parametrize(("scale", "rules"), [("", {"GEO104"}), ("0.001 0.001 0.001", set())])
def test_a_mesh_in_millimetres_needs_its_scale(tmp_path, scale, rules):
    """The robot needs a size to compare with: two joints, 0.4 m apart."""
    shape = mesh_shape("box.stl", 0.1, f' scale="{scale}"' if scale else "")
    second = joint("k", parent="arm", child="tip", origin='<origin xyz="0 0 0.4"/>')
    text = robot(joint(), link(shapes=shape), second, link("tip"))
    findings = found(write(tmp_path, text, unit=1000.0))
    assert {rule for rule in findings if rule.startswith("GEO")} == rules
    if rules:
        assert findings["GEO104"].severity == "error"
        assert findings["GEO104"].value == pytest.approx(250.0)
        assert findings["GEO104"].places[0].line == 4


def test_the_unit_of_a_collada_file_is_applied(tmp_path):
    """As viewers do: 250 units of a millimetre each are 0.25 m."""
    file = write(tmp_path, robot(joint(), link(shapes=mesh_shape("box.dae"))))
    box = trimesh.creation.box(np.array(SIZE) * 1000.0)
    text = trimesh.exchange.dae.export_collada(box).decode()
    unit = '<unit name="millimetre" meter="0.001"/></asset>'
    (tmp_path / "box.dae").write_text(text.replace("</asset>", unit))
    (shape,) = judge(file, samples=5).robot.link["arm"].shapes
    body = MeshReader(tmp_path, PackageMap({}))(shape, "link 'arm'")
    np.testing.assert_allclose(np.ptp(body.points, axis=0), SIZE, rtol=1e-6)
    np.testing.assert_allclose(body.hull_volume, np.prod(SIZE), rtol=1e-6)


def test_a_mesh_that_changes_is_read_again(tmp_path):
    file = write(tmp_path, robot(joint(), link(shapes=mesh_shape("box.stl"))))
    before = dict(judge(file, samples=5).inputs)["box.stl"]
    trimesh.creation.icosphere(radius=0.2).export(tmp_path / "box.stl")
    (shape,) = judge(file, samples=5).robot.link["arm"].shapes
    reader = MeshReader(tmp_path, PackageMap({}))
    np.testing.assert_allclose(np.ptp(reader(shape, "link").points, axis=0), 0.4, rtol=0.02)
    assert reader.inputs["box.stl"] != before


def test_a_centre_outside_its_mesh_is_an_error(tmp_path):
    assert found(write(tmp_path, robot(joint(), link(shapes=mesh_shape("box.stl"))))) == {}
    beside = robot(joint(), link(shapes=mesh_shape("box.stl", z=1.1)))
    assert found(write(tmp_path, beside))["GEO101"].severity == "error"


def test_a_package_is_where_its_option_says(tmp_path):
    meshes, robots = tmp_path / "elsewhere", tmp_path / "robots"
    meshes.mkdir()
    robots.mkdir()
    write(meshes, "")
    file = robots / "arm.urdf"
    file.write_text(robot(joint(), link(shapes=mesh_shape("package://shapes/box.stl"))))
    assert set(found(file)) == {"GEO102"}
    assert found(file, packages={"shapes": meshes}) == {}


@pytest.mark.parametrize(("name", "rule"), [("pipe.stl", "GEO102"), ("damaged.obj", "GEO103")])
def test_a_pipe_and_a_damaged_mesh_are_findings(tmp_path, name, rule):
    os.mkfifo(tmp_path / "pipe.stl")
    (tmp_path / "damaged.obj").write_text("v 0 0 nonsense\n")
    file = write(tmp_path, robot(joint(), link(shapes=mesh_shape(name))))
    assert set(found(file)) == {rule}


@pytest.mark.parametrize(("spread", "seen"), [(0.0, True), (0.5, False)])
def test_one_density_of_all_links_is_a_warning(tmp_path, spread, seen):
    """Four boxes of steel; with `spread`, the second is half as dense again, and so on."""
    parts = []
    for k in range(4):
        mass = STEEL * float(np.prod(SIZE)) * (1.0 + k * spread)
        x, y, z = (mass / 12.0 * (sum(e * e for e in SIZE) - e * e) for e in SIZE)
        parent = f"l{k - 1}" if k else "base"
        parts += [
            joint(f"j{k}", parent=parent, child=f"l{k}"),
            link(
                f"l{k}", mass=repr(mass), ixx=repr(x), iyy=repr(y), izz=repr(z),
                shapes=mesh_shape("box.stl"),
            ),
        ]  # fmt: skip
    findings = found(write(tmp_path, robot(*parts)))
    assert ("ROB102" in findings) == seen
    if seen:
        assert findings["ROB102"].value == pytest.approx(STEEL, rel=1e-6)
