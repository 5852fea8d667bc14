"""What the search for the worst state finds, against brute force, on 7-joint pairs.

    python benchmarks/bench_worst_case.py [--half tuning|reporting] [--states N] [--starts N ...]

Brute force: 2e6 states, half of them uniform in the box, half with velocities and accelerations at
its corners; from the best state of each of 24 slices, gradient ascent with another method:
truncated Newton (SciPy's TNC) with Pinocchio's derivatives.  The ratio is search : brute force, of
each joint's |Δτ| in motion; above 1 the search found more.  Times are CPU times.  Settings were
chosen on the tuning pairs; docs/worst-case.md reports the others.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ur5check import pair_up, rnea, worst_cases
from ur5check._comparison.arm_pair import Pair
from ur5check._comparison.worst_case.state_box import StateBox, state_box
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._robot import Inertia, Joint, Limits, Link, SerialArm, Source, Transform
from ur5check._robot.states import MAX_ACCELERATION

__all__ = ["REPORTING", "TUNING", "brute_force", "main", "pair_of"]

Array = NDArray[np.float64]

#: Seeds of the pairs on which settings may be chosen, and of those whose results are reported.
TUNING = (1, 2, 3, 4)
REPORTING = tuple(range(101, 111))

_JOINTS = 7
_SLICES = 24
_BLOCK = 100_000


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure and print a Markdown table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--half", choices=("tuning", "reporting"), default="reporting")
    parser.add_argument("--states", type=int, default=2_000_000, metavar="N", help="brute force")
    parser.add_argument("--starts", type=int, nargs="*", metavar="N", help="default: the search's")
    options = parser.parse_args(arguments)
    print("| pair | starts | smallest ratio | joint | largest ratio | reached | search | brute |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for seed in TUNING if options.half == "tuning" else REPORTING:
        pair = pair_of(seed)
        began = time.process_time()
        truth = brute_force(pair, options.states, seed)
        brute = time.process_time() - began
        for starts in options.starts or [None]:
            began = time.process_time()
            found = worst_cases(pair, starts=starts)[:_JOINTS]
            seconds = time.process_time() - began
            ratio = np.array([case.value for case in found]) / truth
            reached = min(case.reached for case in found)
            print(
                f"| {seed} | {found[0].starts} | {ratio.min():.6f} | {ratio.argmin() + 1} | "
                f"{ratio.max():.6f} | {reached} | {seconds:.1f} s | {brute:.0f} s |",
                flush=True,
            )
    return 0


def pair_of(seed: int) -> Pair:
    """Two 7-joint arms that differ in every inertial number; in every second one a joint slides."""
    rng = np.random.default_rng([seed, _JOINTS])
    sliding = int(rng.integers(1, _JOINTS)) if seed % 2 else None
    joints, links, others = [], [], []
    for i in range(_JOINTS):
        slides = i == sliding
        reach = 0.4 if slides else rng.uniform(1.5, np.pi)
        limits = Limits(-reach, reach, 1.0 if slides else rng.uniform(1.5, 3.5))
        axis = rng.normal(size=3) if seed % 3 else np.roll((0.0, 0.0, 1.0), rng.integers(3))
        joints.append(Joint(f"joint_{i + 1}", axis, "prismatic" if slides else "revolute", limits))
        tip = Transform.from_rpy(rng.uniform(-0.35, 0.35, 3), rng.uniform(-3.0, 3.0, 3).tolist())
        root = rng.normal(size=(3, 3)) * rng.uniform(0.03, 0.15)
        second_moment = root @ root.T
        tensor = np.trace(second_moment) * np.eye(3) - second_moment
        inertia = Inertia(rng.uniform(0.5, 6.0), rng.normal(size=3) * 0.08, tensor)
        links.append(Link(f"link_{i + 1}", tip, inertia))
        mass = inertia.mass * (1.0 + rng.normal() * 0.2)
        com = inertia.com + rng.normal(size=3) * 0.02
        others.append(Inertia(mass, com, tensor * rng.uniform(0.3, 2.0)))
    base = Transform.from_rpy(np.zeros(3), rng.uniform(-1.0, 1.0, 3).tolist())
    arm = SerialArm(f"seven-{seed}", tuple(joints), tuple(links), base)
    return pair_up(arm, arm.with_inertias(others))


def brute_force(pair: Pair, count: int, seed: int) -> Array:
    """The largest |Δτ_j| that was found, shape (n,)."""
    n, box = pair.a.n, state_box(pair, MAX_ACCELERATION)
    rng = np.random.default_rng([seed, 1])
    blocks = max(_SLICES, count // _BLOCK)
    slices: list[list[tuple[float, Array]]] = [[] for _ in range(n)]
    for block in range(blocks):
        x = _states(box, count // blocks, rng, corners=block % 2 == 1)
        delta = np.abs(_delta(pair, x))
        for j in range(n):
            best = int(delta[:, j].argmax())
            slices[j].append((float(delta[best, j]), x[best]))
    truth = np.empty(n)
    for j in range(n):
        starts = [max(slices[j][part::_SLICES], key=lambda one: one[0]) for part in range(_SLICES)]
        climbed = [_climb(pair, box, start, j) for _, start in starts]
        truth[j] = max(value for value, _ in starts) if not climbed else max(climbed)
    return truth


def _states(box: StateBox, count: int, rng: np.random.Generator, *, corners: bool) -> Array:
    """x = (q, q̇, q̈), shape (count, 3 n)."""
    q = rng.uniform(box.lower, box.upper, (count, len(box.lower)))
    bounds = np.concatenate([box.rate, box.acceleration])
    motion = rng.uniform(-1.0, 1.0, (count, len(bounds)))
    return np.hstack([q, bounds * (np.sign(motion) if corners else motion)])


def _delta(pair: Pair, x: Array) -> Array:
    q, qd, qdd = np.split(x, 3, axis=1)
    return np.asarray(rnea(pair.a, q, qd, qdd) - rnea(pair.b, q, qd, qdd))


def _climb(pair: Pair, box: StateBox, start: Array, joint: int) -> float:
    """|Δτ_joint| at the end of a truncated Newton ascent."""
    from scipy.optimize import Bounds, minimize

    engines = [PinocchioEngine(replace(arm, source=Source())) for arm in (pair.a, pair.b)]
    ends = np.concatenate([box.rate, box.acceleration])
    low, high = np.concatenate([box.lower, -ends]), np.concatenate([box.upper, ends])
    value = float(_delta(pair, start[None])[0, joint])
    sign, scale = (1.0 if value >= 0.0 else -1.0), abs(value)

    def falling(x: Array) -> tuple[float, Array]:
        (tau_a, slope_a), (tau_b, slope_b) = (
            engine.torque_and_slope(*np.split(x, 3)) for engine in engines
        )
        slope = (slope_a - slope_b)[joint]
        return -sign * float((tau_a - tau_b)[joint]) / scale, -sign * slope / scale

    found = minimize(
        falling,
        start,
        jac=True,
        method="TNC",
        bounds=Bounds(low, high),
        options={"ftol": 1e-10, "gtol": 1e-10, "maxfun": 500},
    )
    top = np.clip(found.x, low, high)
    return max(scale, float(np.abs(_delta(pair, top[None])[0, joint])))


if __name__ == "__main__":
    raise SystemExit(main())
