"""The arm of the tests of engines."""

from __future__ import annotations

import pytest

from three_joints import ARM
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._robot import SerialArm


@pytest.fixture(scope="session")
def arm() -> SerialArm:
    """The three-jointed arm of `three_joints`."""
    return read_urdf(ARM.encode(), file="three.urdf", base="base", tip="tool")
