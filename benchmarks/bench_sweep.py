"""CPU time of one thread per state of a sweep, part by part.

    python benchmarks/bench_sweep.py [--blocks N] [--repeats N]

Prints a Markdown table; docs/sweep.md holds one.  A part's time is the least of its repeats: what
else the machine does can only add to it.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

import ur5check
from ur5check._sweep.sobol_sample import SobolSample
from ur5check._sweep.state_sample import BLOCK, RandomSample
from ur5check._sweep.statistics import statistics_of
from ur5check._sweep.torque_difference import torque_difference

_MANY = 10**9  # states of the sweep that the plan is made for


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--blocks", type=int, default=5, metavar="N", help="blocks a run")
    parser.add_argument("--repeats", type=int, default=9, metavar="N", help="runs")
    options = parser.parse_args(arguments)
    parts = measure(options.blocks, options.repeats)
    total = sum(seconds for name, seconds in parts.items() if not name.startswith("("))
    print("| per state | ns | share |\n|---|---:|---:|")
    for name, seconds in parts.items():
        share = "" if name.startswith("(") else f"{seconds / total:.1%}"
        print(f"| {name} | {1e9 * seconds:.3g} | {share} |")
    print(f"| **all** | {1e9 * total:.4g} | {1e-6 / total:.2f} million states a second |")
    return 0


def measure(blocks: int, repeats: int) -> dict[str, float]:
    """Time per state of each part of the computation of one block [s]."""
    plan = ur5check.sweep("paper", "appendix", states=100, tolerance=1.0).plan
    plan = replace(plan, sample=RandomSample(plan.sample.box, _MANY, 0), map_every=64)
    sobol = SobolSample(plan.sample.box, _MANY, 0)
    sobol.block(0)  # its direction numbers are made once
    difference = torque_difference(plan.a, plan.b)
    states = plan.sample.block(0)
    delta = difference.of(states.q, states.qd, states.qdd)
    span = np.concatenate([states.q[::64]] * 16)  # a map is drawn for 16 blocks at once
    parts: dict[str, Callable[[int], object]] = {
        "random numbers (Philox)": plan.sample.block,
        f"torques of both arms ({difference.engine})": lambda k: difference.of(
            states.q, states.qd, states.qdd
        ),
        "statistics": lambda k: statistics_of(delta, states, 0, tolerance=plan.tolerance),
        "(Sobol points instead)": sobol.block,
    }
    seconds = {name: _least(part, blocks, repeats) / BLOCK for name, part in parts.items()}
    seconds["tool position, every 64th"] = _least(lambda k: plan.cells_of(span), 1, repeats) / (
        16 * BLOCK
    )
    return dict(sorted(seconds.items(), key=lambda part: part[0].startswith("(")))


def _least(part: Callable[[int], object], blocks: int, repeats: int) -> float:
    """CPU seconds a block."""
    times = []
    for _ in range(repeats):
        began = time.thread_time()
        for k in range(blocks):
            part(k)
        times.append((time.thread_time() - began) / blocks)
    return min(times)


if __name__ == "__main__":
    raise SystemExit(main())
