"""Of all alignments the one with the smallest torque difference is taken, and no other.

Here a few patterns of axis signs of each arm; benchmarks/bench_alignment.py goes through them all.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from arms_in_disguise import FAMILIES, family, heavier
from bench_alignment import SAME, disguised, errors

from ur5check import Inertia, pair_up
from ur5check._comparison.alignment import align


@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize(("moved", "tilt"), [(False, 0.0), (True, 0.0), (True, 0.3)])
def test_an_arm_in_other_coordinates_needs_the_same_torques(name, moved, tilt):
    arm, rng = family(name, 0, tilt=tilt), np.random.default_rng(1)
    for _ in range(2):
        signs = tuple(rng.choice([1.0, -1.0], arm.n))
        equal, planted = errors(arm, disguised(arm, signs, rng, moved=moved), 0)
        assert equal <= SAME
        assert planted <= SAME  # 1 % of a mass shows, at its right size


def test_the_alignment_taken_is_the_best_and_the_others_are_reported():
    arm = family("6 joints, spherical wrist", 3)
    other = disguised(arm, (1, 1, 1, 1, -1, -1), np.random.default_rng(0), moved=False)
    found = align(arm, other)
    np.testing.assert_array_equal(found.signs, [1, 1, 1, 1, -1, -1])
    assert found.relative_difference < 1e-12
    differences = [each.relative_difference for each in found.others]
    assert differences == sorted(differences)
    assert differences[0] > 1e-3
    # The wrist's other configuration is among them: joint 4 half a turn further, joint 5 reversed.
    assert any(
        abs(abs(each.offsets[3]) - np.pi) < 1e-9 and each.signs[4] != found.signs[4]
        for each in found.others
    )


def test_a_choice_that_torques_do_not_show_changes_least():
    """Wrist links without asymmetry: both configurations need the same torques."""
    arm = family("6 joints, spherical wrist", 3)
    round_body = Inertia(1.0, np.zeros(3), 0.01 * np.eye(3))
    links = tuple(
        link if i < 3 else replace(link, inertia=round_body) for i, link in enumerate(arm.links)
    )
    found = align(arm, replace(arm, links=links))
    assert found.relative_difference > 0.0
    np.testing.assert_array_equal(found.signs, np.ones(6))
    np.testing.assert_array_equal(found.offsets, np.zeros(6))


def test_a_last_zero_without_a_common_tool_is_where_the_torques_agree():
    arm = family("UR", 5)
    other = disguised(arm, (1,) * 6, np.random.default_rng(7), moved=True)
    found = align(arm, other)
    assert not found.unknown
    assert found.torque_difference < SAME
    # In a heavier arm too, whose torques agree nowhere.
    again = align(arm, heavier(other, 5, 1.01))
    np.testing.assert_allclose(again.offsets, found.offsets, atol=1e-9)


def test_the_choice_does_not_depend_on_the_order_of_the_arms():
    arm = family("6 joints, spherical wrist", 3)
    other = disguised(arm, (1, -1, 1, -1, 1, -1), np.random.default_rng(0), moved=False)
    for a, b in ((arm, other), (other, arm)):
        np.testing.assert_array_equal(pair_up(a, b).alignment.signs, (1, -1, 1, -1, 1, -1))
