"""What digits cost is recomputed exactly, and only digits are called digits."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.rounded_constants.cylinder_constant import cut_twelfths
from ur5check._comparison.rounded_constants.decimals import decimals_of, half_units, written_as
from ur5check._comparison.rounded_constants.exact_constants import RoundedConstant
from ur5check._comparison.rounded_constants.rounded_angles import rounded_angles, with_exact_angles
from ur5check._comparison.rounding.error_budget import PrintedDigits, budget
from ur5check._robot import Inertia, Transform
from ur5check._robot.states import random_states

STATES = random_states(6, 200, seed=0)
PAPER, APPENDIX = ur5check.load("paper"), ur5check.load("appendix")


def budget_of(a, b, states=STATES):
    return budget(pair_up(a, b), states)


def exact_items(found):
    return [(item.cause, item.side) for item in found.items if item.exact]


def gravity(written, decimals):
    return RoundedConstant("9.80665", written, decimals, ("gravity",))


def with_quarter_turn(angle):
    """The paper's arm with α of link 4 written as `angle`."""
    link = PAPER.links[3]
    turned = Transform(Transform.rotation((1, 0, 0), angle).R, link.link_tip_frame.p)
    return replace(
        PAPER, links=(*PAPER.links[:3], replace(link, link_tip_frame=turned), *PAPER.links[4:])
    )


@pytest.mark.parametrize("angle", [1.57, 1.5707, 1.5708, 1.570796, 1.570796327, 1.570796326795])
@pytest.mark.parametrize("side", ["a", "b"])
def test_a_rounded_angle_explains_its_whole_difference(angle, side):
    rounded = with_quarter_turn(angle)
    found = budget_of(rounded, PAPER) if side == "a" else budget_of(PAPER, rounded)
    decimals = len(str(angle)) - 2
    cause = RoundedConstant("π/2", str(angle), decimals, ("P4",))
    item = next(item for item in found.items if item.cause == cause)
    assert item.side == side
    np.testing.assert_allclose(found.total, item.rms, rtol=1e-3, atol=1e-4 * found.total.max())
    assert found.remainder_maximum.max() <= found.rounding


def test_half_a_turn_and_the_base_are_looked_at():
    base = Transform.rotation((0, 0, 1), 3.14159)
    (angle,) = rounded_angles(replace(PAPER, base=base))
    assert (angle.where, angle.constant, angle.writing.text) == ("B", "π", "3.14159")


@pytest.mark.parametrize("angle", [1.5712, 1.5703, 1.57069, 1.571, 0.3, pi / 2])
def test_a_calibrated_angle_is_no_rounding(angle):
    # 1.571 is one: π/2 rounded to three decimals.
    assert bool(rounded_angles(with_quarter_turn(angle))) == (angle == 1.571)


def test_links_of_a_urdf_stay_where_they_are_when_an_angle_is_put_right():
    arm = ur5check.load("erd-ur5")
    better = with_exact_angles(arm, rounded_angles(arm))
    assert rounded_angles(arm)
    assert not rounded_angles(better)
    for before, after in zip(arm.links, better.links, strict=True):
        np.testing.assert_allclose(
            after.inertia.expressed_in(after.source_frame.inverse()).parameters(),
            before.inertia.expressed_in(before.source_frame.inverse()).parameters(),
            atol=1e-15,
        )


def test_the_listing_keeps_its_r_when_its_angle_is_put_right():
    arm = ur5check.load("paper-listing")
    link = with_exact_angles(arm, rounded_angles(arm)).links[0]
    np.testing.assert_allclose(
        link.link_tip_frame.R.T @ link.link_tip_frame.p, [0, 0.089159, 0], atol=1e-16
    )


def cylinder_arm(twelfth, *, radius=0.06, length=0.4):
    m = 3.7
    tensor = m * np.diag([twelfth * (3 * radius**2 + length**2)] * 2 + [radius**2 / 2])
    inertias = [Inertia(m, np.array([0.01, 0.02, 0.03]), tensor)] * 6
    return PAPER.with_inertias(inertias)


@pytest.mark.parametrize("constant", [0.0833, 0.08333, 0.0833333])
def test_a_cut_twelfth_explains_its_whole_difference(constant):
    found = budget_of(cylinder_arm(1 / 12), cylinder_arm(constant))
    all_links = tuple(f"link {i}" for i in range(1, 7))
    assert exact_items(found) == [(RoundedConstant("1/12", str(constant), None, all_links), "b")]
    assert found.total.max() > 1e-8
    assert found.remainder_maximum.max() <= found.rounding


def test_cylinders_that_are_no_evidence():
    assert not cut_twelfths(cylinder_arm(1 / 12))
    assert not cut_twelfths(cylinder_arm(0.084))
    assert not cut_twelfths(cylinder_arm(0.0833333, length=0.4 / np.sqrt(2)))
    assert not cut_twelfths(random_arm(6, seed=0))


def test_two_writings_of_gravity():
    found = budget_of(PAPER, PAPER.with_gravity([0, 0, -9.80665]))
    assert (gravity("9.81", 2), "a") in exact_items(found)
    assert found.remainder_maximum.max() <= found.rounding
    moon = budget_of(PAPER, PAPER.with_gravity([0, 0, -1.62]))
    assert all("gravity" not in cause.where for cause, _ in exact_items(moon))
    same = budget_of(PAPER, PAPER)
    assert all("gravity" not in cause.where for cause, _ in exact_items(same))
    assert same.digits_suffice


def test_the_listing_against_the_paper():
    found = budget_of(ur5check.load("paper-listing"), PAPER)
    quarter_turn = RoundedConstant("π/2", "1.5707", 4, ("P1", "P4", "P5"))
    assert exact_items(found)[0] == (quarter_turn, "a")
    assert exact_items(found)[-2:] == [(gravity("9.806", 3), "a"), (gravity("9.81", 2), "b")]
    assert 1e-3 < found.explained.max() < 0.1
    assert found.remainder[1] > 10.0  # the lost signs are no digits
    assert not found.digits_suffice


def test_the_librarys_ur5_against_the_appendix():
    found = budget_of(ur5check.load("erd-ur5"), APPENDIX)
    assert [(cause.constant, cause.written, cause.decimals) for cause, _ in exact_items(found)] == [
        ("π/2", "1.57079632679", 11),
        *[("1/12", "0.0833333", None)] * 2,
    ]
    assert found.items[0].maximum.max() < 1e-9


def rounded_arm(arm, decimals):
    inertias = [
        Inertia(*(np.round(x, decimals) for x in (i.mass, i.com, i.tensor)))
        for i in (link.inertia for link in arm.links)
    ]
    return arm.with_inertias(inertias)


@pytest.mark.parametrize("decimals", [4, 6])
def test_printed_digits_are_bounded(decimals):
    arm, states = random_arm(5, seed=4), random_states(5, 300, seed=0)
    found = budget_of(arm, rounded_arm(arm, decimals), states)
    (bound,) = found.items
    assert (bound.side, bound.exact) == ("b", False)
    assert found.digits_suffice
    assert (found.remainder_maximum <= bound.maximum + found.rounding).all()
    # The bound is not idle either: real rounding comes within a few times of its RMS.
    assert (found.remainder > 0.1 * found.bound)[found.bound > 1e-9].all()


def test_more_than_digits_does_not_pass_for_digits():
    arm, states = random_arm(5, seed=4), random_states(5, 300, seed=0)
    rough = rounded_arm(arm, 6)
    last = rough.links[-1].inertia
    wrong = rough.with_inertias(
        [*(link.inertia for link in rough.links[:-1]), replace(last, mass=1.01 * last.mass)]
    )
    assert not budget_of(arm, wrong, states).digits_suffice


def test_numbers_that_both_files_share_cancel():
    heavier = PAPER.with_inertias(
        [replace(PAPER.links[0].inertia, mass=3.8), *(link.inertia for link in PAPER.links[1:])]
    )
    found = budget_of(PAPER, heavier)
    one = PrintedDigits("inertial parameters", 1)
    assert [item.cause for item in found.items if not item.exact] == [one, one]


@pytest.mark.parametrize(
    ("value", "decimals"),
    [(0.089159, 6), (3.7, 1), (4.0, 0), (0.0, None), (1 / 3, None), (-0.39225, 5), (12345.5, 1)],
)
def test_decimals_of_a_number(value, decimals):
    assert decimals_of(value) == decimals


def test_half_units_of_a_table():
    assert half_units([3.7, 0.1879, 0.0]) == [5e-5, 5e-5, 0.0]
    assert half_units([3.7, 1 / 3]) == [0.0, 0.0]
    assert half_units([0.25], beside=[0.089159]) == [5e-7]


def test_writings_of_a_constant():
    assert written_as(1.5707, pi / 2).text == "1.5707"  # cut off
    assert written_as(1.5708, pi / 2).decimals == 4  # rounded
    assert written_as(pi / 2, pi / 2) is None
    assert written_as(1.5709, pi / 2) is None
