"""Causes of rounding and doubts about a rank, in words."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from ur5check._comparison.rounded_constants.exact_constants import RoundedConstant
from ur5check._comparison.rounding.error_budget import BudgetItem, PrintedDigits
from ur5check._reports.explanation_summary import doubt_in_words
from ur5check._reports.rounding_sentences import cause_in_words, places_in_words


@pytest.mark.parametrize(
    ("cause", "parts"),
    [
        (RoundedConstant("π/2", "1.5707", 4, ("P1", "P4")), ("π/2", "1.5707", "4", "P1, P4")),
        (RoundedConstant("1/12", "0.083", None, ("link 2",)), ("1/12", "0.083", "link 2")),
        (PrintedDigits("lengths", 13), ("lengths", "13 numbers")),
        (PrintedDigits("inertial parameters", 1), ("masses, centres and tensors", "1 number")),
    ],
)
def test_a_cause_names_its_numbers_and_its_places(cause, parts):
    item = BudgetItem(cause, "a", np.zeros(6), np.zeros(6))
    text = f"{cause_in_words(item)} in {places_in_words(item)}"
    assert [part for part in parts if part not in text] == []
    assert "None" not in text


def test_a_doubt_names_the_rank_and_the_gap():
    found = ur5check.identify("paper")
    assert "36 of 60" in doubt_in_words(found)
    assert f"{found.gap:.1e}" in doubt_in_words(found)
