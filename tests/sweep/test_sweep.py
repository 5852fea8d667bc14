"""What a sweep says is what one would find by computing everything at once."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import ur5check
from examples import random_arm
from ur5check._dynamics.kinematics import forward_kinematics
from ur5check._errors import StateError, UsageError
from ur5check._robot.states import States
from ur5check._sweep.magnitude_histogram import RELATIVE_ERROR
from ur5check._sweep.reach_map import HEIGHTS, ReachGrid, tool_position
from ur5check._sweep.sobol_sample import SobolSample
from ur5check._sweep.state_sample import BLOCK, GridSample, RandomSample
from ur5check._sweep.statistics import statistics_of
from ur5check._sweep.sweep import _free_box, sweep
from ur5check._sweep.sweep_plan import plan_of
from ur5check._sweep.sweep_result import QUANTILES

COUNT = 10_000
ROUNDING = 1e-12  # [N m]: the kernel that a sweep runs and the recursion, on torques of 100 N m


@pytest.fixture(scope="module")
def found(paper, appendix):
    return sweep(paper, appendix, states=COUNT, seed=2, tolerance=[1, 2, 1, 0.2, 0.1, 1e-9])


@pytest.fixture(scope="module")
def delta(found) -> np.ndarray:
    """Δτ of the same states, all at once, by the public function."""
    s = found.plan.sample.block(0)
    tau_a, tau_b = (ur5check.rnea(arm, s.q, s.qd, s.qdd) for arm in (found.pair.a, found.pair.b))
    return tau_a - tau_b


def test_root_mean_square_and_maximum(found, delta):
    assert found.count == COUNT
    rms = np.sqrt((delta**2).mean(axis=0))
    np.testing.assert_allclose(found.rms, rms, rtol=1e-12, atol=ROUNDING)
    np.testing.assert_allclose(found.maximum, np.abs(delta).max(axis=0), rtol=0, atol=ROUNDING)
    assert (found.statistics.worst == np.abs(delta).argmax(axis=0)).all()


def test_the_worst_states_make_the_maxima_again(found):
    for j in range(6):
        state = found.worst_state(j).values()
        tau_a, tau_b = (ur5check.rnea(arm, *state) for arm in (found.pair.a, found.pair.b))
        assert abs(tau_a - tau_b)[j] == pytest.approx(found.maximum[j], rel=1e-12, abs=1e-13)


@pytest.mark.parametrize("share", QUANTILES)
def test_quantiles(found, delta, share):
    true = np.quantile(np.abs(delta), share, axis=0, method="inverted_cdf")
    assert (np.abs(found.quantile(share) - true) <= RELATIVE_ERROR * true).all()


def test_share_over(found, delta):
    tolerance = np.abs(delta) > [1, 2, 1, 0.2, 0.1, 1e-9]
    assert (found.share_over() == tolerance.mean(axis=0)).all()


def test_every_state_is_in_one_bin_and_one_cell(found):
    assert (found.statistics.bins.sum(axis=1) == COUNT).all()
    assert found.statistics.visits.sum() == COUNT


def test_the_map_holds_the_largest_of_each_cell(found, delta):
    q = found.plan.sample.block(0).q
    p = forward_kinematics(found.pair.a, q)[:, :3, 3]
    radius, height = np.hypot(p[:, 0], p[:, 1]), p[:, 2]
    grid = found.plan.grid
    for cell in np.argsort(found.statistics.visits)[-5:]:
        column, row = divmod(int(cell), HEIGHTS)
        inside = (
            (grid.radii()[column] <= radius)
            & (radius < grid.radii()[column + 1])
            & (grid.heights()[row] <= height)
            & (height < grid.heights()[row + 1])
        )
        assert inside.sum() == found.statistics.visits[cell]
        largest = np.abs(delta[inside]).max(axis=0)
        np.testing.assert_allclose(found.statistics.reach[:, cell], largest, rtol=0, atol=ROUNDING)
    assert (found.statistics.reach.max(axis=1) == found.maximum).all()


def test_the_map_of_a_long_sweep_sees_every_so_many_state(paper, appendix):
    plan = sweep(paper, appendix, states=4 * BLOCK).plan
    sparse = replace(plan, map_every=16)
    assert sparse.statistics(0, 1).visits.sum() == BLOCK // 16
    assert plan.statistics(0, 1).visits.sum() == BLOCK
    assert (sparse.statistics(0, 1).maximum == plan.statistics(0, 1).maximum).all()


@pytest.mark.parametrize(
    ("count", "sample", "every"),
    [(10**6, "random", 1), (5 * 10**6, "random", 5), (10**9, "sobol", 64), (10**9, "grid", 1)],
)
def test_a_map_wants_a_million_states_and_of_a_grid_all(found, count, sample, every):
    kinds = {
        "random": RandomSample(_free_box(6), count, 0),
        "sobol": SobolSample(_free_box(6), count, 0),
        "grid": GridSample(_free_box(6), 31),
    }
    assert plan_of(found.pair, kinds[sample], None).map_every == every


def test_a_tool_off_the_map_is_counted_at_its_edge():
    grid = ReachGrid(1.0)
    far = np.array([[0.0, 0.0, 9.0], [9.0, 0.0, -9.0], [9.0, 9.0, 9.0], [0.0, 0.0, -1.0]])
    assert grid.cell(far).tolist() == [HEIGHTS - 1, grid.cells - HEIGHTS, grid.cells - 1, 0]


@pytest.mark.parametrize("seed", range(3))
def test_the_tool_is_where_forward_kinematics_says(seed):
    arm = random_arm(5, seed)
    q = np.random.default_rng(seed).uniform(-3, 3, (50, 5))
    expected = forward_kinematics(arm, q)[:, :3, 3]
    assert np.abs(tool_position(arm, q) - expected).max() < 1e-13


def test_no_tool_leaves_the_map(found):
    p = tool_position(found.pair.a, found.plan.sample.block(0).q)
    assert np.linalg.norm(p, axis=1).max() <= found.plan.grid.reach


def test_one_mass_a_hundredth_too_heavy_is_found(appendix):
    """Δτ of joint 2 at rest is Δm g times the centre's lever arm: largest with the arm level."""
    links = [link.inertia for link in appendix.links]
    links[1] = replace(links[1], mass=1.01 * links[1].mass)
    heavier = appendix.with_inertias(links)
    found = sweep(heavier, appendix, states=200_000, sample="grid")
    joint = appendix.links[1]
    lever = np.linalg.norm(joint.link_tip_frame.p + joint.link_tip_frame.R @ joint.inertia.com)
    # The link turns in a plane beside the axis: what lies along the axis is no lever.
    along = (joint.link_tip_frame.p + joint.link_tip_frame.R @ joint.inertia.com) @ appendix.joints[
        1
    ].axis
    bound = 0.01 * joint.inertia.mass * 9.81 * np.sqrt(lever**2 - along**2)
    # With 7 levels the nearest posture is within half a level, 360°/14, of level.
    assert bound * np.cos(np.pi / 7) <= found.maximum[1] <= bound * (1 + 1e-12)
    assert not found.agrees
    assert (found.maximum[2:] < 1e-12).all()  # joints beyond the link carry nothing of it
    assert found.maximum[0] < 1e-12  # gravity has no lever about a vertical axis


def test_equal_arms_agree(appendix):
    found = sweep(appendix, appendix, states=1000)
    assert found.agrees
    assert (found.maximum == 0.0).all() and (found.rms == 0.0).all()
    assert (found.quantile(0.5) == 0.0).all()


def test_an_error_in_the_last_digits_agrees_and_a_larger_one_does_not(appendix):
    def with_mass(factor):
        return appendix.with_inertias(
            [replace(link.inertia, mass=factor * link.inertia.mass) for link in appendix.links]
        )

    assert sweep(with_mass(1 + 1e-9), appendix, states=1000).agrees
    assert not sweep(with_mass(1 + 1e-4), appendix, states=1000).agrees


def test_limits_hold_every_state_and_are_left_aside_otherwise(appendix):
    joints = [
        replace(joint, limits=replace(joint.limits, lower=-0.5, upper=0.25, velocity=0.1))
        for joint in appendix.joints
    ]
    narrow = replace(appendix, joints=joints)
    inside = sweep(narrow, appendix, states=2000, within_limits=True).plan.sample.block(0)
    assert (inside.q >= -0.5).all() and (inside.q <= 0.25).all()
    assert (np.abs(inside.qd) <= 0.1).all()
    free = sweep(narrow, appendix, states=2000).plan.sample.block(0)
    assert np.abs(free.q).max() > 3.0 and np.abs(free.qd).max() > 3.0


def test_sobol_and_chance_see_the_same_arm(found, paper, appendix):
    sobol = sweep(paper, appendix, states=COUNT, sample="sobol")
    np.testing.assert_allclose(sobol.rms[:5], found.rms[:5], rtol=0.03)


def test_arms_of_other_shapes_are_swept():
    """Sliding joints, few joints, no limits."""
    a, b = random_arm(3, 6), random_arm(3, 6)
    heavier = b.with_inertias([replace(b.links[0].inertia, mass=9.0), *[
        link.inertia for link in b.links[1:]
    ]])  # fmt: skip
    found = sweep(a, heavier, states=500)
    assert found.count == 500
    assert found.maximum[0] > 0.0
    assert found.statistics.visits.sum() == 500


def test_a_difference_that_is_no_number_is_refused():
    states = States(*np.zeros((3, 4, 2)))
    for bad in (np.nan, np.inf, 1e200):
        delta = np.ones((4, 2))
        delta[2, 1] = bad
        with pytest.raises(StateError, match="state 102: the torque difference of joint 2"):
            statistics_of(delta, states, 100, tolerance=None)


@pytest.mark.parametrize(
    "options",
    [
        {"states": 0},
        {"states": -5},
        {"seed": -1},
        {"seed": 2**64},
        {"sample": "halton"},
        {"threads": 0},
        {"batch": 0},
        {"tolerance": [1.0, 2.0]},
        {"tolerance": -1.0},
        {"tolerance": float("nan")},
    ],
)
def test_meaningless_options_are_refused(appendix, options):
    with pytest.raises(UsageError):
        sweep(appendix, appendix, **{"states": 100, **options})


def peak(states: int) -> int:
    """Largest resident memory of a process that sweeps so many states [bytes]."""
    program = (
        "import re; from ur5check import sweep; "
        f"sweep('paper', 'paper', states={states}, batch=1); "
        # Not getrusage: its peak is inherited from the process that started this one.
        "print(re.search(r'VmHWM:\\s*(\\d+)', open('/proc/self/status').read())[1])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    return int(done.stdout) * 1024


def test_memory_does_not_grow_with_the_states():
    """Eight times the states, whose numbers alone are 144 bytes each: 66 MB, were they kept."""
    few, many = 4 * BLOCK, 32 * BLOCK
    before, after = peak(few), peak(many)
    assert after - before < 0.2 * 144 * (many - few)
    assert after < 400e6
