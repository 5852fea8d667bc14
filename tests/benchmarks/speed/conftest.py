"""The smallest whole benchmark: an arm of two joints, since compiling takes longest."""

from __future__ import annotations

import pytest
from speed.measure import measure
from speed.random_chain import chain
from speed.result import Benchmark

#: What is measured in this process; the rest starts processes, and has tests of its own.
HERE = ("torques", "memory", "matrices", "states", "joints", "operations")


@pytest.fixture(scope="session")
def found() -> Benchmark:
    return measure(chain(2, 0), only=HERE, states=50, rounds=1, lengths=(2,), up_to=10)
