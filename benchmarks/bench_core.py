"""How fast is the hand-written side, next to Pinocchio?  Ratios of one run on one machine.

    python benchmarks/bench_core.py [--json FILE] [--states N] [--repeats N] [--starts N]

Prints a Markdown table; docs/performance.md holds one.  Look at the ratios: the times are the
machine's, and whatever else it was doing.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

import ur5check
from ur5check.arm.states import random_states
from ur5check.engines.pinocchio import PinocchioEngine

SCHEMA = "ur5check.benchmark/1"
_MODEL = "appendix"


@dataclass(frozen=True)
class Row:
    """One measured time.

    seconds : median over the repeats, of one evaluation or of one start
    ratio : seconds over those of the first row of the group, which is what it is compared with
    """

    group: str
    name: str
    seconds: float
    ratio: float


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, print, and write the JSON if asked to."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures here, too")
    parser.add_argument("--states", type=int, default=10_000, metavar="N", help="states a run")
    parser.add_argument("--repeats", type=int, default=7, metavar="N", help="runs a median")
    parser.add_argument("--starts", type=int, default=10, metavar="N", help="starts a median")
    options = parser.parse_args(arguments)
    report = measure(options.states, options.repeats, options.starts)
    print(table(report))
    if options.json:
        options.json.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    return 0


def measure(states: int, repeats: int, starts: int) -> dict[str, Any]:
    """Everything that is measured, as plain values."""
    rows = [
        *dynamics(states, repeats),
        *validation(states, max(1, starts // 2)),
        *start_up(starts),
    ]
    return {
        "schema": SCHEMA,
        "machine": machine(),
        "versions": versions(),
        "states": states,
        "repeats": repeats,
        "starts": starts,
        "rows": [asdict(row) for row in rows],
    }


def dynamics(count: int, repeats: int) -> list[Row]:
    """The hand-written functions on arrays, against Pinocchio state by state."""
    arm = ur5check.load(_MODEL)
    model = PinocchioEngine(arm).model
    data = model.createData()
    states = random_states(arm.n, count, seed=0)
    q, qd, qdd = states.q, states.qd, states.qdd
    columns = [np.asfortranarray(array.T) for array in (q, qd, qdd)]
    pool = pin.ModelPool(model, 2)

    def rnea_loop() -> None:
        for x, v, a in zip(q, qd, qdd, strict=True):
            pin.rnea(model, data, x, v, a)

    def crba_loop() -> None:
        for x in q:
            pin.crba(model, data, x)

    def coriolis_loop() -> None:
        for x, v in zip(q, qd, strict=True):
            pin.computeCoriolisMatrix(model, data, x, v)

    def regressor_loop() -> None:
        for x, v, a in zip(q, qd, qdd, strict=True):
            pin.computeJointTorqueRegressor(model, data, x, v, a)

    groups: dict[str, list[tuple[str, Callable[[], Any]]]] = {
        "inverse dynamics": [
            ("Python loop over pin.rnea", rnea_loop),
            ("pin.rneaInParallel, 1 thread", lambda: pin.rneaInParallel(1, pool, *columns)),
            ("pin.rneaInParallel, 2 threads", lambda: pin.rneaInParallel(2, pool, *columns)),
            ("ur5check.rnea", lambda: ur5check.rnea(arm, q, qd, qdd)),
        ],
        "mass matrix": [
            ("Python loop over pin.crba", crba_loop),
            ("ur5check.mass_matrix", lambda: ur5check.mass_matrix(arm, q)),
        ],
        "Coriolis matrix": [
            ("Python loop over pin.computeCoriolisMatrix", coriolis_loop),
            ("ur5check.coriolis_matrix", lambda: ur5check.coriolis_matrix(arm, q, qd)),
        ],
        "torque regressor": [
            ("Python loop over pin.computeJointTorqueRegressor", regressor_loop),
            ("ur5check.torque_regressor", lambda: ur5check.torque_regressor(arm, q, qd, qdd)),
        ],
    }
    rows = []
    for group, entries in groups.items():
        times = interleaved([run for _, run in entries], repeats)
        rows += compared(group, [name for name, _ in entries], [t / count for t in times])
    return rows


def validation(states: int, repeats: int) -> list[Row]:
    """`validate` as a user runs it, against a process that only imports what it needs."""
    imports = "import numpy, pinocchio, yourdfpy, lxml.etree, rich.console"
    whole = command("validate", "--samples", str(states))
    times = interleaved([process(sys.executable, "-c", imports), process(*whole)], repeats)
    return compared("ur5check validate", ["import of its dependencies", "ur5check validate"], times)


def start_up(repeats: int) -> list[Row]:
    """What a user waits for before anything happens, against bare Python."""
    times = interleaved(
        [
            process(sys.executable, "-c", "pass"),
            process(sys.executable, "-c", "import ur5check"),
            process(*command("--help")),
        ],
        repeats,
    )
    return compared("start-up", ["python -c pass", "import ur5check", "ur5check --help"], times)


def command(*arguments: str) -> list[str]:
    """The installed command, beside the interpreter that runs this."""
    return [str(Path(sys.executable).with_name("ur5check")), *arguments]


def process(*words: str) -> Callable[[], None]:
    """A run of another program; an error of it ends this one."""

    def run() -> None:
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    return run


def interleaved(runs: Sequence[Callable[[], Any]], repeats: int) -> list[float]:
    """Median time of each, one round after the other, so that a slow minute hits all alike [s]."""
    times: list[list[float]] = [[] for _ in runs]
    for run in runs:
        run()  # caches, imports
    for _ in range(repeats):
        for run, own in zip(runs, times, strict=True):
            start = time.perf_counter()
            run()
            own.append(time.perf_counter() - start)
    return [statistics.median(own) for own in times]


def compared(group: str, names: Sequence[str], seconds: Sequence[float]) -> list[Row]:
    """Rows whose ratio is to the first of them."""
    return [
        Row(group, name, value, value / seconds[0])
        for name, value in zip(names, seconds, strict=True)
    ]


def machine() -> dict[str, Any]:
    """What the figures depend on; no name of the machine, no date."""
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.is_file():
        for line in info.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                model = line.partition(":")[2].strip()
                break
    return {"cpu": model, "cores": os.cpu_count(), "system": platform.system()}


def versions() -> dict[str, str]:
    """Of what was measured."""
    names = ("ur5check", "numpy", "pin")
    return {"python": platform.python_version()} | {name: metadata.version(name) for name in names}


def table(report: dict[str, Any]) -> str:
    """The report as Markdown."""
    about = report["machine"]
    lines = [
        f"Machine: {about['cpu']}, {about['cores']} cores, {about['system']}. Versions: "
        + ", ".join(f"{name} {version}" for name, version in report["versions"].items())
        + f". {report['states']:,} states of the UR5, medians.",
        "",
        "| | | time | ratio to the first |",
        "|---|---|---:|---:|",
    ]
    group = ""
    for row in report["rows"]:
        shown = row["group"] if row["group"] != group else ""
        group = row["group"]
        lines.append(
            f"| {shown} | {row['name']} | {duration(row['seconds'])} | {row['ratio']:.2f} |"
        )
    return "\n".join(lines)


def duration(seconds: float) -> str:
    """As "0.62 µs", "35 ms" or "2.1 s"."""
    if seconds >= 1.0:
        return f"{seconds:.3g} s"
    if seconds >= 1e-3:
        return f"{1e3 * seconds:.3g} ms"
    return f"{1e6 * seconds:.3g} µs"


if __name__ == "__main__":
    sys.exit(main())
