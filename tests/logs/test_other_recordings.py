"""A loaded run against an unloaded one, a fit on another run, and several models."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from logs.recorded import Motion, heavier, loaded, motion_of, write
from ur5check import SerialArm, Ur5checkError, compare_recording


@pytest.mark.parametrize("wrong", [False, True])
def test_the_load_is_found_whatever_the_model(
    arm: SerialArm, motion: Motion, tmp_path: Path, wrong: bool
) -> None:
    carried = motion_of(loaded(arm, 1.2, (0.02, 0.05, 0.1)), seed=2)
    found = compare_recording(
        heavier(arm, 2, 1.3) if wrong else arm,
        write(carried, tmp_path / "loaded.csv"),
        unloaded=write(motion, tmp_path / "empty.csv"),
    )
    assert found.load is not None
    truth = np.array([1.2, 0.02, 0.05, 0.1])
    assert (np.abs(found.load.value - truth) < [0.024, 0.005, 0.005, 0.005]).all()
    assert (np.abs(found.load.value - truth) < 2.0 * found.load.half_width).all()


def test_a_fit_is_tried_on_unseen_data(arm: SerialArm, motion: Motion, tmp_path: Path) -> None:
    run = write(motion, tmp_path / "run.csv")
    other = write(motion_of(arm, seed=3, motion=8), tmp_path / "other.csv")
    right = compare_recording(arm, run, validate=other).validation
    wrong = compare_recording(heavier(arm, 1, 1.4), run, validate=other).validation
    assert right is not None
    assert wrong is not None
    assert (right.given < 1.3 * right.floor).all()
    assert wrong.helps
    assert wrong.given[1] > 3.0 * wrong.fitted[1]


def test_the_better_of_two_models(arm: SerialArm, motion: Motion, file: Path) -> None:
    write(motion, file)
    same, worse = compare_recording(arm, file, others=[arm, heavier(arm, 1, 1.1)]).rivals
    assert not same.clear
    assert worse.clear
    assert worse.difference > 0.0
    (better,) = compare_recording(heavier(arm, 1, 1.1), file, others=[arm]).rivals
    assert better.difference == pytest.approx(-worse.difference, rel=0.2)


def test_a_model_with_other_joints_is_refused(arm: SerialArm, motion: Motion, file: Path) -> None:
    with pytest.raises(Ur5checkError, match="6 joints"):
        compare_recording(arm, write(motion, file), others=["paper"])
