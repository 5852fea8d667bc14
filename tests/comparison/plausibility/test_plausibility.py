"""Findings: an honest body has none, each planted fault has its own, and the UR5s have theirs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from scipy.spatial import ConvexHull

import ur5check
from ur5check import strategies as ur5
from ur5check._comparison.plausibility.plausibility import plausibility
from ur5check._comparison.plausibility.plausible_body import body_findings
from ur5check._comparison.plausibility.plausible_extent import _even_tensor
from ur5check._io.meshes.mesh_shapes import Meshes, Shape
from ur5check._robot import Inertia, Joint, Link, SerialArm, Transform

SIZE = np.array([0.1, 0.1, 0.5])
CORNERS = np.array(np.meshgrid(*[[-0.5, 0.5]] * 3)).reshape(3, -1).T * SIZE
MASS = 5.0


def box_tensor(mass=MASS, size=SIZE):
    """Of a box filled evenly: m (b² + c²) / 12."""
    squares = np.asarray(size) ** 2
    return mass / 12.0 * np.diag(squares.sum() - squares)


VOLUME = float(SIZE.prod())


def findings_of(inertia, *, volume=VOLUME, closed=True, link_tip_frame=None, shape=True):
    """One link, 0.5 m long along z, with a box round it."""
    link_tip_frame = link_tip_frame or Transform.translation((0.0, 0.0, 0.5))
    # The numbers are given, and the box stands, at the link's near end.
    link = Link(
        "bar",
        link_tip_frame,
        inertia.expressed_in(link_tip_frame.inverse()),
        link_tip_frame.inverse(),
    )
    arm = SerialArm("arm", (Joint("j", np.array([0.0, 1.0, 0.0])),), (link,))
    box = Shape("collision", "box", CORNERS + (0, 0, 0.25), volume, closed)
    return plausibility(arm, Meshes(((box,) if shape else (),)))


def kinds(findings):
    return [(finding.severity, finding.quantity) for finding in findings]


HONEST = Inertia(MASS, (0.0, 0.0, 0.25), box_tensor())


@pytest.mark.parametrize("shape", [True, False])
def test_an_honest_body_has_no_finding(shape):
    assert findings_of(HONEST, shape=shape) == ()


@pytest.mark.parametrize("shape", [True, False])
def test_the_frame_of_the_numbers_does_not_matter(shape):
    turned = Transform.from_rpy((0.3, 0.0, 0.4), (0.3, -1.0, 2.0))
    assert findings_of(HONEST, link_tip_frame=turned, shape=shape) == ()


@pytest.mark.parametrize(
    ("fault", "severity", "quantity"),
    [
        ({"tensor": 40.0 * box_tensor()}, "impossible", "radius of gyration"),
        ({"tensor": 3.1 * box_tensor()}, "suspicious", "radius of gyration"),
        ({"tensor": 0.03 * box_tensor()}, "suspicious", "radius of gyration"),
        ({"com": (0.0, 0.0, -0.003)}, "note", "centre of mass"),
        ({"com": (0.0, 0.0, -0.1)}, "impossible", "centre of mass"),
        ({"com": (0.0, 0.2, 0.25)}, "impossible", "centre of mass"),
        ({"mass": 100.0, "tensor": box_tensor(100.0)}, "suspicious", "density"),
        ({"mass": 0.1, "tensor": box_tensor(0.1)}, "suspicious", "density"),
    ],
)
def test_a_planted_fault_is_found(fault, severity, quantity):
    found = findings_of(replace(HONEST, **fault))
    assert (severity, quantity) in kinds(found)
    (finding,) = [f for f in found if f.quantity == quantity]
    assert finding.link == 1 and finding.name == "bar" and "bar" in finding.sentence


def test_a_centre_inside_the_box_but_outside_the_hull_is_found():
    half = CORNERS[(CORNERS / SIZE).sum(axis=1) < 0.6]  # one corner cut off
    link = Link("l", Transform.identity(), Inertia(1.0, 0.45 * SIZE, box_tensor(1.0)))
    arm = SerialArm("arm", (Joint("j", np.array([0.0, 1.0, 0.0])),), (link,))
    cut = Shape("visual", "cut", half, 1e-3, True)
    (finding,) = [f for f in plausibility(arm, Meshes(((cut,),))) if f.quantity == "centre of mass"]
    assert "convex hull" in finding.sentence


def test_density_speaks_of_the_hull_where_the_surface_does_not_close():
    (finding,) = findings_of(HONEST, volume=1e-4, closed=False)
    assert finding.value == pytest.approx(50_000)
    assert "convex hull" in finding.sentence


@given(ur5.inertias())
def test_a_body_with_mass_everywhere_passes_and_its_opposite_does_not(inertia):
    link = Link("l", Transform.identity(), inertia)
    assert "impossible" not in {f.severity for f in body_findings(1, link)}
    moments, axes = np.linalg.eigh(inertia.tensor)
    wrong = axes @ np.diag([moments[0], moments[1], 1.001 * (moments[0] + moments[1])]) @ axes.T
    (finding,) = body_findings(1, replace(link, inertia=replace(inertia, tensor=wrong)))
    assert (finding.severity, finding.quantity) == ("impossible", "triangle inequality")


@pytest.mark.parametrize(
    ("mass", "moments", "severity", "quantity"),
    [
        (-1.0, (1, 1, 1), "impossible", "mass"),
        (0.0, (1, 1, 1), "impossible", "mass"),
        (0.0, (0, 0, 0), "note", "mass"),
        (1.0, (0, 0, 0), "suspicious", "pseudo-inertia"),
        (1.0, (-1, 1, 1), "impossible", "pseudo-inertia"),
        (1.0, (0, 1, 1), "suspicious", "principal moment"),
        (1.0, (1, 1, 2.1), "impossible", "triangle inequality"),
        (1.0, (1, 1, 1.9999), "note", "triangle inequality"),
    ],
)
def test_what_no_body_has(mass, moments, severity, quantity):
    link = Link("l", Transform.identity(), Inertia(mass, np.zeros(3), np.diag(moments)))
    assert kinds(body_findings(1, link)) == [(severity, quantity)]


@pytest.mark.parametrize(
    ("fault", "quantity"),
    [
        ({"tensor": 20.0 * box_tensor()}, "radius of gyration"),
        ({"com": (0.0, 0.0, 0.7)}, "centre of mass"),
        ({"com": (0.0, 0.0, -0.2)}, "centre of mass"),
        ({"tensor": box_tensor(size=SIZE[::-1])}, "direction of the least moment"),
    ],
)
def test_without_a_mesh_the_reach_must_do(fault, quantity):
    end = Transform.translation((0.0, 0.0, 0.5)) @ Transform.from_rpy((0, 0, 0), (0.4, 1.0, -2.0))
    found = findings_of(replace(HONEST, **fault), link_tip_frame=end, shape=False)
    assert kinds(found) == [("suspicious", quantity)]


@pytest.mark.parametrize("factor", [1000.0, 1e-3])
def test_grams_for_kilograms_are_found(factor):
    arm = ur5check.load("paper")
    scaled = [
        replace(x.inertia, mass=factor * x.inertia.mass, tensor=factor * x.inertia.tensor)
        for x in arm.links
    ]
    assert ("suspicious", "total mass") in kinds(plausibility(arm.with_inertias(scaled)))


@pytest.mark.parametrize("factor", [8.0, 0.005])
def test_neighbours_out_of_proportion_are_found(factor):
    arm = ur5check.load("paper")
    inertias = [link.inertia for link in arm.links]
    carrier = inertias[2].mass
    inertias[3] = replace(inertias[3], mass=factor * carrier, tensor=factor * inertias[3].tensor)
    found = [f for f in plausibility(arm.with_inertias(inertias)) if f.link == 4]
    assert ("suspicious", "mass of neighbours") in kinds(found)


def test_the_wrists_of_erd_ur5_are_far_larger_than_their_meshes():
    found = plausibility(ur5check.load("erd-ur5"))
    radii = {f.link: f for f in found if f.quantity == "radius of gyration"}
    assert set(radii) == {4, 5, 6}
    assert {f.severity for f in radii.values()} == {"impossible"}
    assert radii[5].value == pytest.approx(np.sqrt(0.21942 / 1.219))  # ½ m r² with r = 0.6 m
    assert radii[5].bound < 0.07
    centres = {f.link for f in found if f.quantity == "centre of mass"}
    assert centres == {4, 5, 6}
    assert len(found) == 6


def test_what_is_said_of_the_other_ur5s():
    across, centre = "direction of the least moment", "centre of mass"
    assert plausibility(ur5check.load("appendix")) == ()
    paper = plausibility(ur5check.load("paper"))
    assert [(f.link, f.quantity) for f in paper] == [(2, across), (3, across)]
    listing = plausibility(ur5check.load("paper-listing"))
    assert [(f.link, f.quantity) for f in listing] == [
        (2, centre), (2, across), (3, centre), (3, across),
    ]  # fmt: skip


def test_a_mesh_that_cannot_be_read_is_a_note():
    arm = ur5check.load("paper")
    (finding, *_) = plausibility(arm, Meshes(((),) * 6, ("x.stl: no such file",)))
    assert (finding.severity, finding.link) == ("note", None)
    assert "x.stl" in finding.sentence


def test_even_tensor_of_a_box_is_the_textbooks():
    moved = ConvexHull(CORNERS + (1.0, 2.0, 3.0))
    np.testing.assert_allclose(_even_tensor(moved), box_tensor(1.0), atol=1e-12)
