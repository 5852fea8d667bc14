"""How a pair of files is read, and which side's number is the implausible one."""

from __future__ import annotations

from dataclasses import replace

import pytest

import ur5check
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.diagnosis.pair_readings import best_reading


def tensor_scaled(arm, link, factor):
    links = list(arm.links)
    inertia = links[link].inertia
    links[link] = replace(links[link], inertia=replace(inertia, tensor=factor * inertia.tensor))
    return replace(arm, links=tuple(links))


def test_axes_that_coincide_are_read_as_they_are():
    reading, rivals = best_reading(pair_up(*map(ur5check.load, ("paper", "appendix"))))
    assert not reading.moved.any()
    assert not rivals


@pytest.mark.parametrize("side", ["a", "b"])
def test_the_side_with_the_implausible_tensor_is_the_wrong_one(side):
    # 100 times the tensor needs mass farther out than the link is long; the shipped one does not.
    arm = ur5check.load("appendix")
    wrong = tensor_scaled(arm, 1, 100.0)
    pair = pair_up(wrong, arm) if side == "a" else pair_up(arm, wrong)
    reading, _ = best_reading(pair)
    assert [(e.side, e.either) for e in reading.explained] == [(side, False)]


def test_a_plausible_tensor_on_both_sides_decides_nothing():
    arm = ur5check.load("appendix")
    reading, _ = best_reading(pair_up(arm, tensor_scaled(arm, 1, 0.1)))
    assert [e.either for e in reading.explained] == [True]
