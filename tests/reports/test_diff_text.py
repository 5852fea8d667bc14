"""The first screen of `diff`: 24 lines of 80 columns, what is wrong first, with file and line."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check import diff
from ur5check._comparison.causes import find_causes
from ur5check._reports.diff_text import diff_text
from urdf_examples import GOOD

LINES, WIDTH = 24, 80
#: The sign of a centre lost; a decimal point lost.
SPOILED = {
    "sign": ('xyz="0.1 0 0.2"', 'xyz="-0.1 0 0.2"'),
    "point": ('izz="0.04"', 'izz="40.0"'),
}


def screen(a, b, **options):
    d = diff(a, b, samples=50, **options)
    causes = None if d.gravity_only else find_causes(d, progress=lambda line: None)
    return diff_text(d, causes, asked_tolerance="tolerance" in options)


@pytest.fixture
def good(tmp_path):
    path = tmp_path / ("a_long_name_of_a_folder" * 4)
    path.mkdir()
    (path / "good.urdf").write_text(GOOD.replace('xyz="0 0 0.2"', SPOILED["sign"][0]))
    return path / "good.urdf"


def spoiled_file(good, kind):
    path = good.with_name(f"{kind}.urdf")
    old, new = SPOILED[kind]
    text = good.read_text()
    assert text.count(old) == 1
    path.write_text(text.replace(old, new))
    return path


def assert_fits(text):
    lines = text.splitlines()
    assert len(lines) <= LINES
    assert max(map(len, lines)) <= WIDTH


@pytest.mark.parametrize(
    "pair", [("paper", "appendix"), ("paper-listing", "paper"), ("erd-ur5", "appendix")]
)
def test_it_fits_and_begins_with_the_verdict(pair):
    text = screen(*pair)
    assert_fits(text)
    assert text.startswith("DIFFER  ")


@pytest.mark.parametrize("n", [1, 7, 14])
def test_it_fits_where_everything_differs(n):
    arm, other = random_arm(n, seed=1), random_arm(n, seed=2)
    joints = [replace(j, name="a_joint_with_a_long_name" * 3, damping=1.0) for j in arm.joints]
    named = replace(arm, joints=tuple(joints))
    text = screen(named, arm.with_inertias([link.inertia for link in other.links]))
    assert_fits(text)
    assert "damping" in text


def test_equal_arms_take_few_lines():
    text = screen("paper", "paper")
    assert text.startswith("AGREE  ")
    assert len(text.splitlines()) <= 6


def test_a_mistake_is_shown_where_it_is_written(good):
    bad = spoiled_file(good, "sign")
    for pair, signs in (((good, bad), ("-0.1", "0.1")), ((bad, good), ("0.1", "-0.1"))):
        text = screen(*pair)
        assert_fits(text)
        assert f"{pair[1].name}:13:20: centre of mass x {signs[0]} → {signs[1]}" in text


def test_an_impossible_model_is_said_first_and_its_lost_point_is_named(good):
    bad = spoiled_file(good, "point")
    text = screen(good, bad)
    assert_fits(text)
    tags = [line.split()[0] for line in text.splitlines() if not line.startswith(" ")]
    assert tags.index("DIFFER") < tags.index("impossible") < tags.index("geometry")
    assert f"{bad.name}:15" in text
    assert "INE103" in text
    words = " ".join(text.split())
    assert "izz 40.0, against 0.04 (its decimal point is 3 places off)" in words


def test_the_largest_differences_are_the_rows_that_stay():
    d = diff("erd-ur5", "appendix", samples=50)
    causes = find_causes(d, progress=lambda line: None)
    text = diff_text(d, causes, asked_tolerance=False)
    largest = d.pair.a.joints[int(np.argmax(d.torques.maximum))].name
    assert f"{largest}  " in text


def test_the_worst_configuration_is_at_least_its_value():
    d = ur5check.diff("paper", "appendix", samples=50)
    worst = find_causes(d, progress=lambda line: None).worst
    assert worst.value >= d.torques.maximum.max() * 0.9
    words = " ".join(diff_text(d, None, asked_tolerance=False).split())
    assert "at least" not in words
    causes = find_causes(d, progress=lambda line: None)
    words = " ".join(diff_text(d, causes, asked_tolerance=False).split())
    assert f"at least {worst.value:.2f} N m at joint {worst.joint}" in words
    assert f"({worst.reached} of {worst.starts} starts)" in words
