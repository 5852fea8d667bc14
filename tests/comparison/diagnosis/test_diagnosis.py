"""Mistakes between the shipped models: those of the paper, of its appendix, of a library's UR5."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.diagnosis.diagnosis import diagnose
from ur5check._reports.mistake_sentences import details, remark, sentence
from ur5check._robot.states import random_states

STATES = random_states(6, 300, seed=0)


def diagnosed(a, b):
    return diagnose(pair_up(ur5check.load(a), ur5check.load(b)), STATES)


def the(diagnosis, identity):
    (found,) = (f for f in diagnosis.mistakes if f.id == identity)
    return found


@pytest.fixture(scope="module")
def listing():
    return diagnosed("paper-listing", "paper")


@pytest.fixture(scope="module")
def tables():
    return diagnosed("paper", "appendix")


@pytest.fixture(scope="module")
def library():
    return diagnosed("erd-ur5", "appendix")


def test_the_listing_lost_the_signs_of_three_lengths(listing):
    found = the(listing, "length-sign")
    assert found.links == (2, 3, 5)
    assert found.side == "a"
    assert found.after < 1e-3 * found.before
    assert details(found) == ("link 2: sign of x", "link 3: sign of x", "link 5: sign of y")


def test_the_listing_rounded_its_quarter_turns(listing):
    found = the(listing, "rotation-rounded")
    assert found.links == (1, 4, 5)
    assert found.side == "a"
    assert "1.5707" in sentence(found, listing.pair)


def test_the_listing_has_its_own_gravity(listing):
    assert "9.806 and 9.81" in sentence(the(listing, "gravity-value"), listing.pair)


def test_nothing_of_the_listing_is_left(listing):
    assert not listing.unexplained
    assert listing.after < 1e-12
    assert ur5check.diff(listing.repaired_a, "paper", samples=50, gravity=(0, 0, -9.81)).agrees


def test_the_papers_tensors_are_unrotated_and_square_three_r(tables):
    both = the(tables, "tensor-axes + cylinder-3r-squared")
    assert both.side == "a"
    assert {2, 3} <= set(both.links)
    alone = the(tables, "cylinder-3r-squared")
    assert sorted((*both.links, *alone.links)) == [1, 2, 3, 4, 5, 6]


def test_the_cylinders_behind_the_papers_tensors_are_named(tables):
    words = " ".join(details(the(tables, "tensor-axes + cylinder-3r-squared")))
    assert "a cylinder of radius 0.06 m and length 0.56 m along x" in words


def test_the_appendix_takes_its_centres_from_its_cylinders(tables):
    found = the(tables, "centre-of-shape")
    assert found.side == "b"
    assert found.links == (1, 2, 3, 4, 5, 6)


def test_the_appendix_is_turned_by_half_a_turn(tables):
    assert "180° about z" in sentence(the(tables, "base-turned"), tables.pair)


def test_what_is_left_of_the_tables_are_digits(tables):
    assert not tables.unexplained
    assert tables.after < 1e-4 * tables.before


def test_swapping_the_arms_swaps_the_sides(tables):
    swapped = diagnosed("appendix", "paper")
    sides = {"a": "b", "b": "a", None: None}
    assert {(f.id, f.links, f.side) for f in swapped.mistakes} == {
        (f.id, f.links, sides[f.side]) for f in tables.mistakes
    }


def test_the_librarys_wrists_have_ten_times_the_radius(library):
    found = the(library, "cylinder-radius")
    assert found.links == (4, 5)
    assert found.side == "a"
    assert "10 times too large" in sentence(found, library.pair)
    assert "as written: a cylinder of radius 0.6 m" in details(found)[0]
    remarks = [remark(mismatch, library) for mismatch in library.unexplained]
    assert any("link 6's tensor" in words and "radius 0.6 m" in words for words in remarks)


def test_an_arm_and_itself_have_no_mistake():
    same = diagnosed("appendix", "appendix")
    assert not same.mistakes
    assert not same.unexplained
