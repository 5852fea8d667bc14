"""Arms to sweep."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._robot.serial_arm import SerialArm


@pytest.fixture(scope="session")
def paper() -> SerialArm:
    return ur5check.load("paper")


@pytest.fixture(scope="session")
def appendix() -> SerialArm:
    return ur5check.load("appendix")
