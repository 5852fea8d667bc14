"""The states of a block: inside their box, reproducible, with the right distribution."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

from ur5check._comparison.worst_case.state_box import StateBox
from ur5check._sweep import philox, philox_llvm
from ur5check._sweep.random_states import placed
from ur5check._sweep.sobol_sample import SobolSample
from ur5check._sweep.state_sample import BLOCK, GridSample, RandomSample, blocks_of

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


def test_philox_is_the_published_one():
    """Known answers of Random123, the authors' own library (philox4x32, 10 rounds)."""
    known = [
        ([0] * 4, [0] * 2, "6627e8d5 e169c58d bc57ac4c 9b00dbd8"),
        ([0xFFFFFFFF] * 4, [0xFFFFFFFF] * 2, "408f276d 41c83b0e a20bc7c6 6d5451fd"),
        (
            [0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344],
            [0xA4093822, 0x299F31D0],
            "d16cfe09 94fdcceb 5001e420 24126ea1",
        ),
    ]
    for counter, key, answer in known:
        words = philox._ten_rounds([np.array([c], np.uint64) for c in counter], key)
        assert " ".join(f"{int(word[0]):08x}" for word in words) == answer


def test_philox_counts_seed_block_state_and_row():
    """The states are those of the documented generator."""
    found = numbers(RandomSample(BOX, 4 * BLOCK, 7).block(3))
    counter = [np.array([c], np.uint64) for c in (11, 1, 3, 0)]  # state 11, rows 4 to 7, block 3
    words = philox._ten_rounds(counter, [7, 0])
    expected = [(float(word[0]) + 0.5) * 2.0**-32 for word in words[:2]]
    assert np.abs(found[11, 4:6] - expected).max() < 1e-15


@pytest.mark.parametrize(("seed", "block"), [(0, 0), (7, 3), (2**40 + 5, 2**33 + 1)])
def test_compiled_numbers_are_the_same_to_the_bit(seed, block):
    width, lower = np.linspace(1e-10, 3e-9, 6), np.linspace(-3.0, 7.0, 6)
    for length in (1000, 1001, 7):  # whole and broken groups of eight
        words = philox.random_words(seed, block, 6, length)
        compiled = philox_llvm.drawn(seed, block, width, lower, length)
        assert np.array_equal(compiled, placed(words, width, lower))
        assert not np.array_equal(
            philox_llvm.drawn(seed + 1, block, width, lower, length), compiled
        )
        assert not np.array_equal(
            philox_llvm.drawn(seed, block + 1, width, lower, length), compiled
        )


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
