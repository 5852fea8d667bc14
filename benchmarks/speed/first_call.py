"""The process in which `first_use` times the first call of a kernel.

    python benchmarks/speed/first_call.py rnea < ARM

reads a pickled arm and prints two times as JSON: of the import of NumPy, and from there to the
first result [s].
"""

from __future__ import annotations

import json
import pickle
import sys
from time import perf_counter

_ARGUMENTS = {"rnea": 3, "mass_matrix": 1, "coriolis_matrix": 2, "gravity_torque": 1}


def main(quantity: str) -> tuple[float, float]:
    """Time of NumPy's import, and of the first result after it [s]."""
    began = perf_counter()
    import numpy as np

    imported = perf_counter()
    arm = pickle.load(sys.stdin.buffer)  # noqa: S301 - from the process that started this one
    state = np.zeros((_ARGUMENTS.get(quantity, 3), 1, arm.n))
    ready = perf_counter()
    from ur5check._dynamics.compiled import kernel

    getattr(kernel.compile(arm), quantity)(*state)
    return imported - began, perf_counter() - ready


if __name__ == "__main__":
    print(json.dumps(main(sys.argv[1])))
