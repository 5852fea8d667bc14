"""A whole benchmark, as small as it gets: what is in it, never how fast.

Of two joints, since what takes long is to compile.
"""

from __future__ import annotations

import pytest

from ur5check._benchmarking.benchmark import bench
from ur5check._benchmarking.growth import chain
from ur5check._benchmarking.result import Benchmark

#: What is measured in this process; the rest starts processes, and has tests of its own.
HERE = ("torques", "memory", "matrices", "states", "joints", "operations")


@pytest.fixture(scope="session")
def found() -> Benchmark:
    return bench(chain(2, 0), only=HERE, states=50, rounds=1, lengths=(2,), up_to=10)
