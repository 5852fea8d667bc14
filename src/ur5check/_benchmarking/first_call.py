"""The process whose first call `first_use` times.

    python -m ur5check._benchmarking.first_call rnea < ARM

reads a pickled arm and prints, as JSON, how long NumPy took to import, and how long it took
from there to the first result [s].
"""

from __future__ import annotations

import json
import pickle
import sys
from time import perf_counter

_ARGUMENTS = {"rnea": 3, "mass_matrix": 1, "coriolis_matrix": 2, "gravity_torque": 1}


def main(quantity: str) -> tuple[float, float]:
    """Both times."""
    began = perf_counter()
    import numpy as np

    imported = perf_counter()
    arm = pickle.load(sys.stdin.buffer)  # noqa: S301 - from the process that started this one
    state = np.zeros((_ARGUMENTS.get(quantity, 3), 1, arm.n))
    ready = perf_counter()
    from .._dynamics.compiled import kernel

    getattr(kernel.compile(arm), quantity)(*state)
    return imported - began, perf_counter() - ready


if __name__ == "__main__":
    print(json.dumps(main(sys.argv[1])))  # noqa: T201
