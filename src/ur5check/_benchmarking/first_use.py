"""What the first call of a kernel costs: with nothing on disk, and with its code kept there.

Each is measured in a process of its own (`first_call`).
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

from .._dynamics.compiled.kernel import default_path
from .._robot.serial_arm import SerialArm, Source
from .growth import chain
from .result import Chapter, Comparison
from .timing import ranked

__all__ = ["COLD", "FIRST_CALLS", "IMPORT", "WARM", "first_use"]

#: What is asked of the arm itself, and by which of a kernel's functions.
FIRST_CALLS = {
    "torques": "rnea",
    "mass matrix": "mass_matrix",
    "Coriolis matrix": "coriolis_matrix",
    "gravity torque": "gravity_torque",
    "torque regressor": "torque_regressor",
}
_MOST = 3  # rounds; a compilation takes seconds, and scatters little
IMPORT, COLD, WARM = "import of NumPy", "nothing on disk", "code on disk"


def first_use(arm: SerialArm, lengths: Sequence[int], seed: int, rounds: int) -> Chapter:
    """One comparison a quantity, and one a longer arm."""
    rounds = min(rounds, _MOST)
    longer = (_compared(f"torques, {n} joints", "rnea", chain(n, seed), 1) for n in lengths)
    return Chapter(
        "first-use",
        "The first call of a kernel",
        "process",
        f"By {'LLVM' if default_path() == 'llvm' else 'NumPy'}, in a new process each time, "
        "without the import of NumPy, which is given apart.",
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
    done = subprocess.run(  # noqa: S603 - this interpreter, a file of ours
        [sys.executable, "-m", f"{__package__}.first_call", quantity],
        input=arm,
        stdout=subprocess.PIPE,
        env={**os.environ, "UR5CHECK_CACHE": folder},
        check=True,
    )
    imports, seconds = json.loads(done.stdout)
    return imports, seconds
