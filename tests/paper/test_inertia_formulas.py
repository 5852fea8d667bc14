"""Behind each printed tensor one formula, and behind a planted number none."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from ur5check._comparison.rounded_constants.cylinder_constant import cut_twelfths
from ur5check._paper.evidence import Evidence
from ur5check._paper.inertia_formulas import (
    EQ_3,
    FORMULAS,
    TensorFormula,
    tensor_formulas,
    which_formula,
)
from ur5check._paper.paper_models import PRINTED
from ur5check._robot.inertia import Inertia

#: Radius and length of the appendix's cylinders, typed from it [m].
CYLINDERS = {
    1: (0.06, 0.15),
    2: (0.06, 0.56),
    3: (0.06, 0.39225),
    4: (0.06, 0.12),
    5: (0.06, 0.12),
    6: (0.0375, 0.0345),
}


def test_every_printed_tensor_squares_3r(evidence: Evidence) -> None:
    assert [f.link for f in evidence.formulas] == list(CYLINDERS)
    for f in evidence.formulas:
        assert f.formula is not None
        assert f.formula.text == "m((3r)² + l²)·0.08333"
        assert not f.formula.honest
        assert (f.radius, f.length) == CYLINDERS[f.link]
        radius, length = CYLINDERS[f.link]
        by_hand = f.mass * ((3 * radius) ** 2 + length**2) * 0.08333
        assert round(by_hand, 9) == pytest.approx(f.across, abs=1e-15)
        assert f.along == pytest.approx(round(f.mass * radius**2 / 2, 9), abs=1e-15)


def test_the_honest_formula_gives_none_of_them(evidence: Evidence) -> None:
    for f in evidence.formulas:
        radius, length = CYLINDERS[f.link]
        assert f.honest == pytest.approx(f.mass * (3 * radius**2 + length**2) / 12, rel=1e-14)
        assert f.honest_error > 0.06
        assert abs(f.honest_length - length) > 0.01
    assert EQ_3.text == "m(3r² + l²)/12"


@pytest.mark.parametrize("formula", FORMULAS, ids=lambda formula: formula.text)
def test_a_formula_is_known_by_its_digits(evidence: Evidence, formula: object) -> None:
    """Each of them, planted in the longest link, is found again or one that gives the same."""
    assert isinstance(formula, type(EQ_3))
    cylinders = cut_twelfths(evidence.model("appendix").arm)
    planted = round(formula.across(8.393, *CYLINDERS[2]), 9)
    found = which_formula(8.393, planted, 5e-10, cylinders)
    assert found is not None
    same = found[0].across(8.393, found[1].radius, found[1].length)
    assert same == pytest.approx(planted, abs=5.1e-10)
    assert found[0].k == formula.k


@pytest.mark.parametrize("link", CYLINDERS)
def test_a_planted_tensor_is_refused(evidence: Evidence, link: int) -> None:
    """A number two units off in its last digit belongs to no formula."""
    listing, appendix = evidence.model(PRINTED).arm, evidence.model("appendix").arm
    bodies = [body.inertia for body in listing.links]
    old = bodies[link - 1]
    planted = old.tensor + np.diag([2e-9, 2e-9, 0.0])
    bodies[link - 1] = Inertia(old.mass, old.com, planted)
    found: tuple[TensorFormula, ...] = tensor_formulas(listing.with_inertias(bodies), appendix)
    spoiled = found[link - 1]
    assert (spoiled.formula, spoiled.radius, spoiled.length) == (None, None, None)
    assert all(f.formula is not None for f in found if f.link != link)


def test_no_cylinder_fits_a_flat_tensor(evidence: Evidence) -> None:
    """m l² would have to be negative: the length that eq. 3 would need is no number."""
    listing, appendix = evidence.model(PRINTED).arm, evidence.model("appendix").arm
    bodies = [body.inertia for body in listing.links]
    flat = np.diag([0.002, 0.002, 0.00666])
    bodies[0] = replace(bodies[0], tensor=flat)
    (first, *_) = tensor_formulas(listing.with_inertias(bodies), appendix)
    assert math.isnan(first.honest_length)
    assert first.formula is None


def test_only_link_1_has_a_twin_under_the_honest_formula(evidence: Evidence) -> None:
    """3 r² + 0.21² = 9 r² + 0.15² for r = 0.06, as the page says; no other link has one."""
    twins = {}
    for f in evidence.formulas:
        radius, _ = CYLINDERS[f.link]
        length = math.sqrt(f.across / (f.mass * 0.08333) - 3 * radius**2)
        slack = f.half_unit / (f.mass * 0.08333) / (2 * length)
        if abs(length - round(length, 4)) <= slack:
            twins[f.link] = round(length, 4)
    assert twins == {1: 0.21}
