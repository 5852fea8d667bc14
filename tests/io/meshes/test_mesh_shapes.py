"""The shapes of links: read where the URDF puts them, or noted."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

import ur5check
from ur5check._io.meshes.mesh_shapes import link_meshes
from ur5check._io.urdf.urdf_reader import read_urdf

INERTIAL = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
)


def arm_with(shapes: str, *, file: str = "arm.urdf", more: str = ""):
    """One joint along x at (0, 0, 1), whose link has these shapes."""
    text = f"""<robot name="r"><link name="base"/>
      <joint name="j" type="continuous"><parent link="base"/><child link="moving"/>
        <origin xyz="0 0 1" rpy="0 0 0.3"/><axis xyz="1 0 0"/></joint>
      <link name="moving">{INERTIAL}{shapes}</link>{more}</robot>"""
    return read_urdf(text.encode("utf-8"), file=file, base="base", tip="moving")


def only(arm):
    meshes = link_meshes(arm)
    assert meshes.notes == ()
    ((shape,),) = meshes.links
    return shape


def test_box_stands_where_its_origin_says():
    shape = only(
        arm_with(
            '<visual><origin xyz="1 0 0" rpy="0 0 1.5707963267948966"/>'
            '<geometry><box size="0.4 0.2 0.6"/></geometry></visual>'
        )
    )
    assert (shape.kind, shape.name, shape.closed) == ("visual", "box", True)
    np.testing.assert_allclose(shape.bounds, [[0.9, -0.2, -0.3], [1.1, 0.2, 0.3]], atol=1e-12)
    assert shape.volume == pytest.approx(0.4 * 0.2 * 0.6)


@pytest.mark.parametrize(
    ("tag", "half", "volume"),
    [
        ('sphere radius="0.5"', (0.5, 0.5, 0.5), np.pi / 6),
        ('cylinder radius="0.5" length="3"', (0.5, 0.5, 1.5), np.pi * 3 / 4),
    ],
)
def test_round_shapes_have_their_size(tag, half, volume):
    shape = only(arm_with(f"<collision><geometry><{tag}/></geometry></collision>"))
    assert shape.kind == "collision"
    np.testing.assert_allclose(shape.bounds, [np.negative(half), half], rtol=0.02)
    assert shape.volume == pytest.approx(volume, rel=0.03)  # a polyhedron inside the sphere


@pytest.fixture
def tetrahedron(tmp_path):
    corners = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]]
    faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    trimesh.Trimesh(corners, faces).export(tmp_path / "t.stl")
    trimesh.Trimesh(corners, faces[:3]).export(tmp_path / "open.obj")
    return tmp_path


def mesh(name: str, scale: str = "") -> str:
    return f'<visual><geometry><mesh filename="{name}" {scale}/></geometry></visual>'


def test_mesh_is_scaled_and_its_volume_with_it(tetrahedron):
    arm = arm_with(mesh("t.stl", 'scale="0.1 0.1 -0.2"'), file=str(tetrahedron / "arm.urdf"))
    shape = only(arm)
    np.testing.assert_allclose(shape.bounds, [[0, 0, -0.6], [0.1, 0.2, 0]], atol=1e-9)
    assert shape.volume == pytest.approx(0.1 * 0.1 * 0.2)
    assert shape.closed


def test_mesh_is_turned_as_its_origin_says(tetrahedron):
    turned = mesh("t.stl").replace("<geometry>", '<origin rpy="0 0 1.5707963267948966"/><geometry>')
    shape = only(arm_with(turned, file=str(tetrahedron / "arm.urdf")))
    np.testing.assert_allclose(shape.bounds, [[-2, 0, 0], [0, 1, 3]], atol=1e-9)


def test_surface_that_does_not_close_has_its_hulls_volume(tetrahedron):
    shape = only(arm_with(mesh("open.obj"), file=str(tetrahedron / "arm.urdf")))
    assert not shape.closed
    assert shape.volume == pytest.approx(1.0)


def test_what_is_fixed_to_a_link_counts_with_it():
    hand = f"""<link name="hand">{INERTIAL}
        <visual><geometry><sphere radius="0.1"/></geometry></visual></link>
      <joint name="f" type="fixed"><parent link="moving"/><child link="hand"/>
        <origin xyz="0 5 0"/></joint>"""
    shape = only(arm_with("", more=hand))
    assert shape.bounds.mean(axis=0) == pytest.approx([0, 5, 0])


@pytest.mark.parametrize(
    ("shapes", "words"),
    [
        (mesh("missing.stl"), "no such file"),
        (mesh("package://nowhere/x.stl"), "package 'nowhere' is not known"),
        (mesh("package://ur_description/../x.stl"), "climbs out"),
        (mesh("https://example.org/x.stl"), "not supported"),
        (mesh("garbage.dae"), "cannot be read"),
        (mesh("garbage.stl"), "encloses nothing"),
        (mesh("empty.stl"), "encloses nothing"),
        (mesh("flat.obj"), "encloses nothing"),
        (mesh("shape.zip"), "no mesh format"),
        (mesh("t.stl", 'scale="1 2"'), "takes 3 numbers"),
        (mesh(""), "no such file"),
        ("<visual/>", "has no geometry"),
        ("<visual><geometry/></visual>", "has no geometry"),
        ("<visual><geometry><cone/></geometry></visual>", "no shape of URDF"),
        ('<visual><geometry><box size="1 nan 1"/></geometry></visual>', "not finite"),
        ("<visual><geometry><sphere/></geometry></visual>", "radius is missing"),
    ],
)
def test_what_cannot_be_read_is_a_note(shapes, words, tetrahedron):
    (tetrahedron / "garbage.stl").write_bytes(bytes(range(256)) * 3)
    (tetrahedron / "garbage.dae").write_text("<no")
    (tetrahedron / "empty.stl").write_bytes(b"")
    (tetrahedron / "shape.zip").write_bytes(b"PK")
    (tetrahedron / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n")
    good = "<collision><geometry><box size='1 1 1'/></geometry></collision>"
    meshes = link_meshes(arm_with(good + shapes, file=str(tetrahedron / "arm.urdf")))
    (note,) = meshes.notes
    assert words in note
    assert [shape.name for shape in meshes.links[0]] == ["box"]  # the rest is not lost


def test_the_ur5s_meshes_are_found_where_the_arm_is():
    for name in ("appendix", "erd-ur5"):
        meshes = link_meshes(ur5check.load(name))
        assert meshes.notes == ()
        assert all({s.kind for s in shapes} == {"visual", "collision"} for shapes in meshes.links)
        upper_arm = meshes.links[1][0].bounds
        assert 0.5 < (upper_arm[1] - upper_arm[0])[2] < 0.6


def test_an_arm_from_no_urdf_has_no_shapes():
    meshes = link_meshes(ur5check.load("paper"))
    assert meshes.links == ((),) * 6
    assert meshes.notes == ()
