"""The band of stated uncertainties is what Monte Carlo gives, and is exceeded by a wrong mass."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.torque_band import torque_band
from ur5check._errors import UsageError
from ur5check._io.uncertainty import read_uncertainty
from ur5check._robot import Inertia

LIST = "mass=1%,centre=2%,tensor=10%"


def drawn(arm, rng):
    """An arm whose numbers are off by Gaussian errors of LIST, in the frames of its source."""
    inertias = []
    for link in arm.links:
        body = link.inertia.expressed_in(link.source_frame.inverse())
        moments = np.diag(body.tensor)
        noise = np.triu(0.1 * np.sqrt(np.outer(moments, moments)) * rng.standard_normal((3, 3)))
        off = Inertia(
            body.mass * (1 + 0.01 * rng.standard_normal()),
            body.com + 0.02 * np.linalg.norm(body.com) * rng.standard_normal(3),
            body.tensor + noise + np.triu(noise, 1).T,
        )
        inertias.append(off.expressed_in(link.source_frame))
    return arm.with_inertias(inertias)


def test_monte_carlo_gives_the_same_standard_deviation():
    """2σ of both models cover 95 % of 400 drawn pairs, at every joint and state."""
    arm = ur5check.load("appendix")
    states = ur5check.random_states(6, 5, seed=1)
    pair = pair_up(arm, arm)
    of_both = read_uncertainty(LIST, arm, arm)
    band = torque_band(pair, states, np.zeros((5, 6)), of_both, 0)
    rng = np.random.default_rng(2)
    deltas = np.array(
        [
            ur5check.rnea(drawn(arm, rng), states.q, states.qd, states.qdd)
            - ur5check.rnea(drawn(arm, rng), states.q, states.qd, states.qdd)
            for _ in range(400)
        ]
    )
    # A standard deviation from 400 draws is known to 1 / √800 = 3.5 %; RMS over five states.
    assert np.sqrt((deltas.std(axis=0) ** 2).mean(axis=0)) == pytest.approx(band.sigma, rel=0.08)
    shares = [torque_band(pair, states, delta, of_both, 0).share.mean() for delta in deltas[:100]]
    assert np.mean(shares) == pytest.approx(0.05, abs=0.02)


def test_honest_pairs_are_allowed():
    """Of pairs that differ by the stated uncertainties, 5 % at most are said to differ by more."""
    arm = ur5check.load("appendix")
    states = ur5check.random_states(6, 30, seed=4)
    pair, of_both = pair_up(arm, arm), read_uncertainty(LIST, arm, arm)
    rng = np.random.default_rng(3)
    exceeded = []
    for _ in range(60):
        tau_a, tau_b = (
            ur5check.rnea(drawn(arm, rng), states.q, states.qd, states.qdd) for _ in range(2)
        )
        exceeded.append(bool(torque_band(pair, states, tau_a - tau_b, of_both, 0).exceeded))
    assert sum(exceeded) <= 8  # of 60 with 5 % each: more than 8 has a probability of 0.2 %


def test_a_wrong_mass_exceeds_and_equal_models_do_not():
    arm = ur5check.load("appendix")
    wrong = [link.inertia for link in arm.links]
    wrong[2] = replace(wrong[2], mass=1.05 * wrong[2].mass)
    found = ur5check.diff(arm, arm.with_inertias(wrong), samples=200, uncertainty="mass=1%").band
    assert found.exceeded
    assert set(found.exceeded) <= {1, 2, 3}  # joints that carry the third link
    # 5 % against 2σ of the same mass in both models; the other masses only add to σ.
    assert found.allowed < found.ratio.max() <= 5.0 / (2.0 * np.hypot(1.0, 1.05)) * (1 + 1e-9)
    same = ur5check.diff(arm, arm, samples=200, uncertainty="mass=1%").band
    assert same.exceeded == ()
    assert same.share.max() == 0.0
    generous = ur5check.diff(arm, arm.with_inertias(wrong), samples=200, uncertainty="mass=5%")
    assert generous.band.exceeded == ()


def test_numbers_without_uncertainty_allow_nothing():
    """Where σ is zero, any difference is too large: only the last link's mass is uncertain."""
    arm = ur5check.load("paper")
    wrong = [link.inertia for link in arm.links]
    wrong[1] = replace(wrong[1], mass=1.001 * wrong[1].mass)
    found = ur5check.diff(arm, arm.with_inertias(wrong), samples=20, uncertainty="tensor=1%").band
    assert 2 in found.exceeded


def test_a_file_says_it_link_by_link(tmp_path):
    arm = ur5check.load("appendix")
    file = tmp_path / "u.toml"
    name = arm.links[1].name
    file.write_text(
        f'mass = "1%"\n[b]\nmass = "2 %"\ncentre = 0.002\n[b.links.{name}]\nmass = 0.05\n'
    )
    first, second = read_uncertainty(file, arm, arm)
    assert (first.others.mass.value, first.others.mass.relative) == (0.01, True)
    assert (second.others.mass.value, second.others.centre.value) == (0.02, 0.002)
    assert (second.links[name].mass.value, second.links[name].mass.relative) == (0.05, False)
    assert second.links[name].centre.value == 0.002


@pytest.mark.parametrize(
    "text",
    ["", "mass", "weight=1%", "mass=-1%", "mass=1%,mass=2%", "mass=much", "mass=0", "no.toml"],
)
def test_meaningless_uncertainties_are_refused(text):
    arm = ur5check.load("paper")
    with pytest.raises(UsageError, match=r"uncertainty|quantity|standard"):
        read_uncertainty(text, arm, arm)


@pytest.mark.parametrize("text", ["[a.links.nowhere]\nmass=1", "a = 3", "mass = true", "mass = ["])
def test_meaningless_files_are_refused(text, tmp_path):
    arm = ur5check.load("paper")
    (tmp_path / "u.toml").write_text(text)
    with pytest.raises(UsageError):
        read_uncertainty(tmp_path / "u.toml", arm, arm)
