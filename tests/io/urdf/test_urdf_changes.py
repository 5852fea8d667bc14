"""A URDF's text with other numbers in it: reads back as the arm, and nothing else is touched."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from ur5check import load
from ur5check._io.urdf.urdf_changes import changed_urdf
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._robot import Inertia, Transform
from urdf_examples import GOOD

#: Comments, odd blanks, both kinds of quotes, a shape, a link with a body fixed to it.
ODD = (
    GOOD.replace('<mass value="2.0"/>', "<!-- mass=\"7\" --><mass\n   value = '2.0' />")
    .replace('xyz="0 0 0.2"', 'xyz=" 0  0\t0.2 "')
    .replace(
        '<link name="tool"/>',
        '<link name="tool"><visual><geometry><box size="1 1 1"/></geometry></visual></link>\r\n'
        '<link name="camera"><inertial><mass value="0.3"/><origin xyz="0.1 0 0"/>'
        '<inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/></inertial></link>'
        '<joint name="mount" type="fixed"><origin xyz="0 0.2 0"/>'
        '<parent link="upper"/><child link="camera"/></joint>',
    )
)
#: Numbers are written to 1e-13 of the largest; here the largest are some kilograms.
ROUNDING = 1e-12
ATTRIBUTE = re.compile(r"""=\s*("[^"]*"|'[^']*')""")


def arm_of(text):
    return read_urdf(text.encode(), file="odd.urdf", tip="tool")


def in_own_frame(arm, link, *, mass=1.0, com=(0.0, 0.0, 0.0), factor=1.0):
    """The arm with one link's own body changed, in the frame of its file."""
    old = arm.links[link]
    own = arm.source.robot.link[old.name].inertial.inertia
    new = Inertia(own.mass * mass, own.com + com, own.tensor * factor)
    there = old.source_frame
    parts = [part for _, part in old.welded]
    total = sum(parts, new.expressed_in(there))
    links = list(arm.links)
    links[link] = replace(old, inertia=total)
    return replace(arm, links=tuple(links))


def with_tip_frame(arm, link, P):
    old = arm.links[link]
    written = old.inertia.expressed_in(old.source_frame.inverse())
    new = replace(
        old,
        link_tip_frame=P,
        source_frame=P.inverse(),
        inertia=written.expressed_in(P.inverse()),
    )
    return replace(arm, links=(*arm.links[:link], new, *arm.links[link + 1 :]))


def assert_equal(a, b):
    for x, y in zip(a.links, b.links, strict=True):
        np.testing.assert_allclose(
            x.inertia.parameters(), y.inertia.parameters(), rtol=0, atol=ROUNDING
        )
        np.testing.assert_allclose(
            x.link_tip_frame.matrix(), y.link_tip_frame.matrix(), rtol=0, atol=ROUNDING
        )


def assert_only_values_differ(old, new):
    assert ATTRIBUTE.sub("=", old) == ATTRIBUTE.sub("=", new)


@pytest.mark.parametrize(
    ("link", "change", "expected"),
    [
        (0, {"mass": 2.0}, {"link 'upper' mass": ("2.0", "4.0")}),
        (0, {"com": (0.0, 0.0, -0.4)}, {"link 'upper' centre of mass": None}),
        (1, {"mass": 0.5}, {"link 'lower' mass": ("1.0", "0.5")}),
        (
            1,
            {"factor": 10.0},
            {f"link 'lower' {e}": ("0.010", "0.1") for e in ("ixx", "iyy", "izz")},
        ),
    ],
)
def test_only_the_number_that_differs_changes(link, change, expected):
    arm = arm_of(ODD)
    other = in_own_frame(arm, link, **change)
    found = changed_urdf(arm, other)
    assert found.unwritten == ()
    assert_equal(arm_of(found.text), other)
    assert_only_values_differ(ODD, found.text)
    assert {c.what for c in found.changes} == set(expected)
    for one in found.changes:
        if expected[one.what]:
            assert (one.old, one.new) == expected[one.what]
        line = ODD.split("\n")[one.place.line - 1]
        assert line[one.place.column - 1 :].startswith(one.old)


def test_blanks_and_the_other_numbers_of_a_list_stay():
    arm = arm_of(ODD)
    found = changed_urdf(arm, in_own_frame(arm, 0, com=(0.0, 0.0, -0.4)))
    (change,) = found.changes
    assert (change.old, change.new) == (" 0  0\t0.2 ", " 0  0\t-0.2 ")


@pytest.mark.parametrize("seed", range(10))
def test_any_bodies_read_back(seed):
    """Inertials along axes of their own, a body fixed to one link, no origin in the other."""
    rng = np.random.default_rng(seed)
    arm = other = arm_of(ODD)
    for link in range(2):
        other = in_own_frame(
            other,
            link,
            mass=rng.uniform(0.5, 2.0),
            com=rng.normal(size=3) * 0.1,
            factor=rng.uniform(0.5, 2.0),
        )
    found = changed_urdf(arm, other)
    assert_equal(arm_of(found.text), other)


def test_a_left_out_origin_is_written():
    arm = arm_of(ODD)
    found = changed_urdf(arm, in_own_frame(arm, 1, com=(0.0, 0.25, 0.0)))
    (change,) = found.changes
    assert (change.old, change.new) == ("", "0.0 0.25 0.0")
    assert found.text.replace('<origin xyz="0.0 0.25 0.0"/>', "") == ODD


@pytest.mark.parametrize(
    "P",
    [
        Transform.from_rpy((0.3, 0.0, -0.5), (0.0, 0.0, 0.0)),
        Transform.from_rpy((0.3, 0.0, 0.5), (0.0, 0.4, np.pi / 2)),
    ],
)
def test_a_joint_is_placed_elsewhere(P):
    arm = arm_of(ODD)
    other = with_tip_frame(arm, 0, P)
    found = changed_urdf(arm, other)
    assert_equal(arm_of(found.text), other)
    assert found.unwritten == ()
    assert [change.what.split()[1] for change in found.changes] == ["'j2'"]


def test_what_no_number_holds_is_said():
    """A frame between two joints; a body that would weigh less than what is fixed to it."""
    between = ODD.replace(
        '<parent link="upper"/>\n    <child link="lower"/>',
        '<parent link="flange_1"/>\n    <child link="lower"/>',
    ).replace(
        '<link name="base"/>',
        '<link name="base"/><link name="flange_1"/><joint name="more" type="fixed">'
        '<parent link="upper"/><child link="flange_1"/></joint>',
    )
    arm = arm_of(between)
    moved = changed_urdf(arm, with_tip_frame(arm, 0, Transform.translation((1.0, 0.0, 0.0))))
    assert [link for link, _ in moved.unwritten] == [1]
    light = replace(arm.links[0], inertia=Inertia(0.2, np.zeros(3), 1e-3 * np.eye(3)))
    found = changed_urdf(arm, replace(arm, links=(light, arm.links[1])))
    assert [link for link, _ in found.unwritten] == [1]
    assert found.text == between == moved.text


def test_an_arm_of_another_source_has_no_such_text():
    arm = load("paper")
    assert changed_urdf(arm, arm) is None
    assert changed_urdf(load("appendix"), load("appendix")).changes == ()
