"""How many decimals a number was written with, and which constant it rounds."""

from __future__ import annotations

from math import pi

import pytest

from ur5check._comparison.rounded_constants.decimals import decimals_of, half_units, written_as


@pytest.mark.parametrize(
    ("value", "decimals"),
    [(0.089159, 6), (-0.425, 3), (3.0, 0), (8.393, 3), (0.0, None), (1.0 / 3.0, None)],
)
def test_the_shortest_decimal_is_what_was_written(value, decimals):
    assert decimals_of(value) == decimals


def test_rounding_error_of_a_change_of_frames_is_ignored():
    assert decimals_of(0.39225 + 1e-16) == 5
    assert decimals_of(0.39225 + 1e-11) is None


@pytest.mark.parametrize(
    ("value", "text", "decimals"),
    [
        (1.5707, "1.5707", 4),
        (1.5708, "1.5708", 4),
        (1.57, "1.57", 2),
        (1.570796327, "1.570796327", 9),
    ],
)
def test_a_rounded_and_a_cut_off_quarter_turn(value, text, decimals):
    written = written_as(value, pi / 2)
    assert written is not None
    assert (written.text, written.decimals) == (text, decimals)


@pytest.mark.parametrize("value", [pi / 2, 1.5706, 1.5709])
def test_the_constant_itself_and_other_numbers_are_no_rounding(value):
    assert written_as(value, pi / 2) is None


def test_the_finest_number_of_a_table_gives_the_place_for_all():
    assert half_units([3.7, 0.1879, 0.0]) == [0.5e-4, 0.5e-4, 0.0]
    assert half_units([3.7], beside=[0.001]) == [0.5e-3]


def test_computed_numbers_are_exact():
    assert half_units([3.7, 1.0 / 3.0]) == [0.0, 0.0]
