"""Numbers as a reader wants to see them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ur5check._reports.wording import coordinates, figures, joined, percent, posture, residue
from ur5check._robot import Joint


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (0.0, "0"),
        (-0.0, "0"),
        (7.4, "7.400"),
        (-14.615649, "-14.62"),
        (0.0006860, "6.860e-04"),
        (0.21942, "0.2194"),
        (1634.5, "1634"),
        (12345.6, "12346"),
        (99999.7, "100000"),
        (1.2e7, "1.200e+07"),
        (8.469589e-05, "8.470e-05"),
        (4.4989e-14, "4.5e-14"),
        (math.nan, "–"),
        (math.inf, "inf"),
        (-math.inf, "-inf"),
        (None, "–"),
    ],
)
def test_four_figures_or_two_for_next_to_nothing(value: float | None, shown: str) -> None:
    assert figures(value) == shown


@pytest.mark.parametrize(
    ("value", "shown"),
    [(3.1e-14, "3.1e-14"), (1.3073e-4, "1.3e-04"), (0.0, "0"), (191.84, "191.8")],
)
def test_a_residue_that_is_none_keeps_its_figures(value: float, shown: str) -> None:
    assert residue(value) == shown


@pytest.mark.parametrize(
    ("share", "shown"),
    [(0.12345, "12.35"), (1.0, "100.00"), (0.00004, "0.00"), (None, "–"), (math.nan, "–")],
)
def test_a_percentage_has_hundredths(share: float | None, shown: str) -> None:
    assert percent(share) == shown


def test_a_posture_is_in_degrees_and_millimetres() -> None:
    joints = [Joint("turn", np.array([0, 0, 1])), Joint("slide", np.array([0, 0, 1]), "prismatic")]
    assert posture([-math.pi / 2, 0.25], joints) == " -90 250mm"
    assert posture([-1e-9, 0.0], joints).split() == ["0", "0mm"]


def test_coordinates_have_no_minus_zero_and_no_rounding_dust() -> None:
    assert coordinates(np.array([-0.0, 1e-17, 0.39225]), 1e-3) == "(0, 0, 392.25)"


def test_lists_read_as_sentences() -> None:
    assert joined(["a"]) == "a"
    assert joined(["a", "b"]) == "a and b"
    assert joined(["a", "b", "c"]) == "a, b and c"
