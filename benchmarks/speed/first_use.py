"""The first call of a kernel: without and with its machine code on disk.

Each is measured in its own process (`first_call.py`).
"""

from __future__ import annotations

import json
import os
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from ur5check._dynamics.compiled.kernel import default_path
from ur5check._robot.serial_arm import SerialArm, Source

from .random_chain import chain
from .result import Chapter, Comparison
from .timing import ranked

__all__ = ["COLD", "FIRST_CALLS", "IMPORT", "WARM", "first_use"]

#: Quantity to method of a kernel.
FIRST_CALLS = {
    "torques": "rnea",
    "mass matrix": "mass_matrix",
    "Coriolis matrix": "coriolis_matrix",
    "gravity torque": "gravity_torque",
    "torque regressor": "torque_regressor",
}
_MOST = 3  # rounds; a compilation takes seconds, with little scatter
_FIRST_CALL = Path(__file__).with_name("first_call.py")
IMPORT, COLD, WARM = "import of NumPy", "nothing on disk", "code on disk"


def first_use(arm: SerialArm, lengths: Sequence[int], seed: int, rounds: int) -> Chapter:
    """One comparison per quantity, and one per longer arm."""
    rounds = min(rounds, _MOST)
    longer = (_compared(f"torques, {n} joints", "rnea", chain(n, seed), 1) for n in lengths)
    return Chapter(
        "first-use",
        "The first call of a kernel",
        "process",
        f"By {'LLVM' if default_path() == 'llvm' else 'NumPy'}, in a new process each time; "
        "without the import of NumPy, which is listed separately.",
        (*(_compared(what, name, arm, rounds) for what, name in FIRST_CALLS.items()), *longer),
        series=True,
    )


def _compared(subject: str, quantity: str, arm: SerialArm, rounds: int) -> Comparison:
    text = pickle.dumps(replace(arm, source=Source()))
    times: dict[str, list[float]] = {IMPORT: [], COLD: [], WARM: []}
    for _ in range(rounds):
        with tempfile.TemporaryDirectory() as folder:
            for kind in (COLD, WARM):
                imports, seconds = _in_a_process(quantity, text, folder)
                times[IMPORT].append(imports)
                times[kind].append(seconds)
    return ranked(subject, list(times), list(times.values()))


def _in_a_process(quantity: str, arm: bytes, folder: str) -> tuple[float, float]:
    done = subprocess.run(
        [sys.executable, _FIRST_CALL, quantity],
        input=arm,
        stdout=subprocess.PIPE,
        env={**os.environ, "UR5CHECK_CACHE": folder},
        check=True,
    )
    imports, seconds = json.loads(done.stdout)
    return imports, seconds
