"""Planted engines, entered into the registry as anyone's would be."""

from __future__ import annotations

from collections.abc import Callable

import planted_engines
import pytest
from three_joints import ARM

from ur5check._engines.engine_entry import EngineEntry
from ur5check._engines.registry import REGISTRY
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._robot import SerialArm


@pytest.fixture(scope="session")
def arm() -> SerialArm:
    """The three-jointed arm of `three_joints`."""
    return read_urdf(ARM.encode(), file="three.urdf", base="base", tip="tool")


@pytest.fixture
def plant(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], str]:
    """`plant(class name)`: enters an engine of `planted_engines`, returns its key."""

    def enter(name: str) -> str:
        assert hasattr(planted_engines, name)
        engine = getattr(planted_engines, name)
        entry = EngineEntry(key=name.lower(), title=name, order=99, make=engine)
        monkeypatch.setitem(REGISTRY, entry.key, entry)
        return entry.key

    return enter
