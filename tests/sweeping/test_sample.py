"""States of a block: in their box, the same whoever asks, and spread as they should be."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

from ur5check.sweeping.sample import BLOCK, GridSample, RandomSample, blocks_of
from ur5check.sweeping.sobol_sample import SobolSample
from ur5check.worst_case.state_box import StateBox

BOX = StateBox(
    np.array([-1.0, 0.5]), np.array([2.0, 0.75]), np.array([3.0, 1e-3]), np.array([10.0, 4.0])
)


def numbers(states) -> np.ndarray:
    """All entries in the unit box, shape (N, 3 n)."""
    return np.hstack(
        [
            (states.q - BOX.lower) / (BOX.upper - BOX.lower),
            (states.qd + BOX.rate) / (2 * BOX.rate),
            (states.qdd + BOX.acceleration) / (2 * BOX.acceleration),
        ]
    )


@pytest.mark.parametrize("kind", [RandomSample, SobolSample])
class TestDrawn:
    def test_states_lie_in_the_box_and_fill_it(self, kind):
        u = numbers(kind(BOX, BLOCK, 5).block(0))
        assert u.shape == (BLOCK, 6)
        assert (u > 0.0).all() and (u < 1.0).all()
        for column in u.T:
            assert stats.kstest(column, "uniform").pvalue > 1e-3

    def test_a_block_needs_no_other(self, kind):
        sample = kind(BOX, 3 * BLOCK, 5)
        last = sample.block(2).q
        assert (sample.block(0).q != last).any()
        assert (kind(BOX, 3 * BLOCK, 5).block(2).q == last).all()

    def test_more_states_begin_with_the_same_ones(self, kind):
        few, many = kind(BOX, 100, 5), kind(BOX, 2 * BLOCK, 5)
        assert blocks_of(few) == 1 and blocks_of(many) == 2
        assert (few.block(0).qdd == many.block(0).qdd[:100]).all()

    def test_the_seed_matters(self, kind):
        assert (kind(BOX, 50, 5).block(0).qd != kind(BOX, 50, 6).block(0).qd).all()


def test_philox_is_asked_with_seed_and_block():
    """The states are those of the documented generator, so that anyone can make them again."""
    words = np.random.Generator(np.random.Philox(key=[7, 3])).bit_generator.random_raw(3 * BLOCK)
    expected = (words.view("<u4").reshape(6, BLOCK)[0] + 0.5) * 2.0**-32
    found = numbers(RandomSample(BOX, 4 * BLOCK, 7).block(3))[:, 0]
    assert np.abs(found - expected).max() < 1e-15


@pytest.mark.parametrize("k", [0, 1, 2, 3, 6, 37])
def test_sobol_jumps_where_scipy_walks(k):
    walker = qmc.Sobol(6, scramble=True, bits=52, rng=np.random.default_rng(9))
    for _ in range(k + 1):
        walked = walker.random(BLOCK)
    jumped = numbers(SobolSample(BOX, 40 * BLOCK, 9).block(k))
    assert np.abs(jumped - walked).max() < 1e-13  # the box's own rounding


def test_sobol_points_fill_better_than_chance():
    sobol, chance = (numbers(kind(BOX, 1024, 1).block(0)) for kind in (SobolSample, RandomSample))
    assert qmc.discrepancy(sobol) < 0.3 * qmc.discrepancy(chance)


def test_a_grid_has_every_combination_once_and_is_at_rest():
    grid = GridSample(BOX, 130)
    assert grid.count == 130**2
    blocks = [grid.block(k) for k in range(blocks_of(grid))]
    q = np.concatenate([block.q for block in blocks])
    assert len(np.unique(q, axis=0)) == grid.count
    first, second = np.unique(q[:, 0]), np.unique(q[:, 1])
    assert len(first) == len(second) == 130
    assert np.allclose(np.diff(first), 3.0 / 130)
    assert first[0] - BOX.lower[0] == pytest.approx(1.5 / 130)
    assert not any(block.qd.any() or block.qdd.any() for block in blocks)
