"""The small arm and its honest recording, made once."""

from __future__ import annotations

from pathlib import Path

import pytest

from logs.recorded import Motion, motion_of, small_arm
from ur5check import SerialArm


@pytest.fixture(scope="session")
def arm(tmp_path_factory: pytest.TempPathFactory) -> SerialArm:
    return small_arm(tmp_path_factory.mktemp("model"))


@pytest.fixture(scope="session")
def motion(arm: SerialArm) -> Motion:
    return motion_of(arm)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.csv"
