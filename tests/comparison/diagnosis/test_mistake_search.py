"""When a mistake explains a number, and when it does not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.diagnosis.link_numbers import LinkPair
from ur5check._comparison.diagnosis.mistake_search import (
    DIGITS,
    disagreements,
    explanations,
    stands_out,
    usual_gap,
)

ARM = ur5check.load("appendix")


def with_mass(arm, link, mass):
    links = list(arm.links)
    links[link] = replace(links[link], inertia=replace(links[link].inertia, mass=mass))
    return replace(arm, links=tuple(links))


def with_tensor(arm, tensor):
    """The arm with the tensor of link 2, in the axes of the file."""
    links = list(arm.links)
    own = links[1].inertia.expressed_in(links[1].source_frame.inverse())
    inertia = replace(own, tensor=tensor).expressed_in(links[1].source_frame)
    links[1] = replace(links[1], inertia=inertia)
    return replace(arm, links=tuple(links))


def found(other, link, quantity, noise=0.0, truth=ARM):
    """(mismatch, what explains it) for one number of `other` against the truth."""
    link_pair = LinkPair.of(pair_up(truth, other), "b")
    (mismatch,) = (
        m
        for m in disagreements(link_pair, geometry=False)
        if (m.link, m.quantity) == (link, quantity)
    )
    return mismatch, explanations(link_pair, mismatch, noise)


def test_a_mass_in_grams_is_explained_to_the_digits():
    mismatch, candidates = found(with_mass(ARM, 1, 1000 * 8.393), 1, "mass")
    assert mismatch.gap == pytest.approx(0.999)
    assert [candidate.ids for candidate in candidates] == [("mass-scaled",)]
    assert candidates[0].value == pytest.approx(8.393)
    assert candidates[0].after <= DIGITS


@pytest.mark.parametrize(("off", "explained"), [(0.9e-4, True), (1.1e-4, False)])
def test_four_digits_must_agree_after_the_repair(off, explained):
    _, candidates = found(with_mass(ARM, 1, 1000 * 8.393 * (1 + off)), 1, "mass")
    assert bool(candidates) == explained


@pytest.mark.parametrize(("left", "closer", "explained"), [(0.03, 9.5, True), (0.08, 3.5, False)])
def test_a_repair_must_bring_a_number_five_times_closer(left, closer, explained):
    # Between models that differ by 2 % everywhere.  The sign of a product of inertia makes a gap of
    # 0.28; a repair that leaves 0.08 is within five times the noise, but only 3.5 times closer.
    tensor = np.diag([0.3, 0.6, 0.7]) + 0.1 * (np.eye(3)[[1, 0, 2]] - np.diag([0, 0, 1]))
    wrong = tensor * (1.0 + left)
    wrong[0, 1] = wrong[1, 0] = -tensor[0, 1]
    mismatch, candidates = found(
        with_tensor(ARM, wrong), 1, "tensor", 0.02, with_tensor(ARM, tensor)
    )
    assert mismatch.gap / left == pytest.approx(closer, rel=0.05)
    assert [candidate.ids for candidate in candidates] == (
        [("tensor-product-signs",)] if explained else []
    )


def test_noise_is_the_median_of_inertial_gaps():
    link_pair = LinkPair.of(pair_up(ARM, with_mass(ARM, 1, 9.0)), "b")
    gaps = disagreements(link_pair, geometry=True)
    assert usual_gap(gaps) == 0.0
    (mass,) = (m for m in gaps if m.gap > 0.0)
    assert mass.gap == pytest.approx(0.607 / 9.0)
    assert stands_out(mass, 0.01)
    assert not stands_out(mass, 0.05)
