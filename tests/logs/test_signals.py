"""Filtered signals: no phase, the file's own clock, ends and gaps left out."""

from __future__ import annotations

import numpy as np
import pytest

from logs.recorded import Motion, motion_of
from logs.test_row_checks import recording_of
from ur5check import SerialArm, Ur5checkError
from ur5check._logs.friction import FrictionModel
from ur5check._logs.signals import choose_cutoff, filtered


def test_the_cutoff_lies_above_the_motion(motion: Motion) -> None:
    """The motion ends at 0.5 Hz."""
    assert 2.0 <= choose_cutoff(recording_of(motion.table())) <= 4.0


@pytest.mark.parametrize("from_position", [False, True])
def test_velocity_and_acceleration_are_those_of_the_motion(
    motion: Motion, from_position: bool
) -> None:
    signals = filtered(
        recording_of(motion.table()), 4.0, FrictionModel(), velocity_from_position=from_position
    )
    truth = np.stack([np.interp(signals.t, motion.t, column) for column in motion.qd.T], axis=1)
    assert np.abs(signals.qd - truth).max() < 0.01 * np.abs(motion.qd).max()
    derivative = np.gradient(motion.qd, motion.t, axis=0)
    smooth = np.stack([np.interp(signals.t, motion.t, c) for c in derivative.T], axis=1)
    assert (signals.qdd - smooth).std() < 0.05 * signals.qdd.std()


def test_the_times_of_the_file_count_not_its_rate(arm: SerialArm) -> None:
    steps = np.random.default_rng(3).uniform(0.002, 0.014, 2500)
    motion = motion_of(arm, times=np.cumsum(steps))
    signals = filtered(
        recording_of(motion.table()), 4.0, FrictionModel(), velocity_from_position=True
    )
    truth = np.stack([np.interp(signals.t, motion.t, c) for c in motion.qd.T], axis=1)
    assert np.abs(signals.qd - truth).max() < 0.03 * np.abs(motion.qd).max()


def test_both_sides_of_a_gap_are_left_out(motion: Motion) -> None:
    table = np.delete(motion.table(), slice(800, 900), axis=0)
    signals = filtered(recording_of(table), 4.0, FrictionModel(), velocity_from_position=False)
    assert set(signals.segment) == {0, 1}
    assert not ((signals.t > 7.76) & (signals.t < 9.24)).any()
    assert signals.t.min() >= 0.24


@pytest.mark.parametrize("cutoff", [0.0, 51.0])
def test_a_cutoff_that_the_rate_does_not_allow_is_refused(motion: Motion, cutoff: float) -> None:
    with pytest.raises(Ur5checkError, match="cutoff"):
        filtered(
            recording_of(motion.table()), cutoff, FrictionModel(), velocity_from_position=False
        )


def test_a_recording_too_short_for_the_cutoff_is_refused(motion: Motion) -> None:
    with pytest.raises(Ur5checkError, match="too short"):
        filtered(
            recording_of(motion.table()[:60]), 1.0, FrictionModel(), velocity_from_position=False
        )
