"""Rounded angles are recognised before two arms are aligned, on either side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from arms_in_disguise import heavier, in_other_coordinates

import ur5check
from ur5check import SerialArm, Transform, diff, explain, pair_up
from ur5check._comparison.rounded_constants.cylinder_constant import (
    cut_twelfths,
    with_exact_twelfth,
)
from ur5check._comparison.rounded_constants.rounded_angles import rounded_angles


def rounded(arm: SerialArm, digits: float, *, base: bool = False) -> SerialArm:
    """The arm with its links' quarter turns about x written as ±`digits` [rad]."""
    links = []
    for link in arm.links:
        P = link.link_tip_frame
        sine = P.R[2, 1]
        if abs(sine) == 1.0:
            P = Transform(Transform.rotation((1, 0, 0), float(sine * digits)).R, P.p)
        links.append(replace(link, link_tip_frame=P))
    return replace(arm, links=tuple(links))


PAPER = ur5check.load("paper")


@pytest.mark.parametrize("digits", [1.5708, 1.5707, 1.57])
@pytest.mark.parametrize("swapped", [False, True])
def test_rounded_quarter_turns_explain_the_difference(digits, swapped):
    pair = (PAPER, rounded(PAPER, digits))
    d = diff(*(reversed(pair) if swapped else pair), samples=50)
    assert d.pair.alignment.exact
    assert d.rounding_explains
    assert d.agrees == (digits != 1.57)  # 8e-4 rad cost more than a ten-thousandth
    assert [each.side for each in d.pair.corrections] == ["a" if swapped else "b"]
    found = explain(d)
    assert {mistake.id for mistake in found.diagnosis.mistakes} == {"rotation-rounded"}
    assert found.diagnosis.after < 1e-10


@pytest.mark.parametrize("angle", [np.pi / 2 + 4e-6, np.pi / 2 - 3.3e-5])
def test_an_angle_that_is_no_rounding_is_a_difference(angle):
    d = diff(PAPER, rounded(PAPER, float(angle)), samples=50)
    assert not d.pair.alignment.exact
    assert not d.rounding_explains
    assert not d.agrees


def test_what_else_is_wrong_is_found_beside_rounded_digits():
    other = heavier(rounded(PAPER, 1.5708), 2, 10.0)
    d = diff(PAPER, other, samples=50)
    assert d.pair.alignment.exact
    assert not d.rounding_explains
    ids = {mistake.id for mistake in explain(d).diagnosis.mistakes}
    assert "rotation-rounded" in ids
    assert any(name.startswith("mass") for name in ids)


def test_a_rounded_arm_is_aligned_in_other_coordinates_too():
    signs, offsets = [1, -1, 1, 1, -1, 1], [0.3, 0.0, -1.0, 0.0, 0.0, 0.0]
    other = in_other_coordinates(rounded(PAPER, 1.5708), Transform.identity(), signs, offsets)
    pair = pair_up(PAPER, other)
    np.testing.assert_array_equal(pair.alignment.signs, signs)
    assert pair.alignment.exact


def test_pi_in_a_mounted_base_is_no_other_gravity():
    exact = replace(PAPER, base=Transform.rotation((1, 0, 0), np.pi))
    other = replace(PAPER, base=Transform.rotation((1, 0, 0), 3.14159))
    d = diff(exact, other, samples=50)
    assert d.rounding_explains
    assert d.agrees
    np.testing.assert_array_equal(d.pair.b.gravity, d.pair.a.gravity)
    assert {mistake.id for mistake in explain(d).diagnosis.mistakes} == {"rotation-rounded"}


def test_arms_that_round_alike_do_not_differ_by_rounding():
    arm = rounded(PAPER, 1.5708)
    assert rounded_angles(arm)
    assert pair_up(arm, arm).corrections == ()
    assert diff(arm, arm, samples=20).without_rounding is None


@pytest.mark.parametrize("swapped", [False, True])
def test_a_twelfth_cut_off_in_one_arm_explains_its_tensors(swapped):
    exact = with_exact_twelfth(PAPER, cut_twelfths(PAPER))
    pair = (exact, PAPER) if swapped else (PAPER, exact)
    d = diff(*pair, samples=50)
    assert [each.side for each in d.pair.corrections] == ["b" if swapped else "a"]
    assert d.rounding_explains
    assert {mistake.id for mistake in explain(d).diagnosis.mistakes} == {"twelfth-rounded"}


def test_a_twelfth_that_leaves_other_tensors_unequal_is_not_blamed():
    exact = with_exact_twelfth(PAPER, cut_twelfths(PAPER))
    pair = pair_up(PAPER, heavier(exact, 1, 1.01))
    tensors = [replace(link.inertia, tensor=1.01 * link.inertia.tensor) for link in exact.links]
    assert pair.corrections  # masses play no part
    assert pair_up(PAPER, exact.with_inertias(tensors)).corrections == ()
