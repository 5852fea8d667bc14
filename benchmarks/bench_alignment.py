"""Alignment of arms whose axes coincide in several ways: every pattern of axis signs.

Each arm is compared with itself in other coordinates: axes negated, zeros moved, the base turned
about the vertical and shifted, another tool frame.  Counted are the patterns for which the torques
agree to 1e-9 N m, and those for which a mass that is 1 % larger causes the very difference that it
must.  `--seeds` draws other bodies and coordinates.
"""

from __future__ import annotations

import argparse
import itertools
import time

import numpy as np
from arms_in_disguise import FAMILIES, family, heavier, in_other_coordinates, with_tool

from ur5check import SerialArm, Transform, pair_up, random_states, rnea

SAME = 1e-9  # [N m]


def disguised(
    arm: SerialArm, signs: tuple[float, ...], rng: np.random.Generator, *, moved: bool
) -> SerialArm:
    """The arm with these axis signs; `moved`: zeros, base and tool too."""
    if not moved:
        return in_other_coordinates(arm, Transform.identity(), signs, np.zeros(arm.n))
    T = Transform.from_rpy(rng.normal(size=3), (0.0, 0.0, rng.uniform(-3.0, 3.0)))
    tool = Transform.from_rpy(0.1 * rng.normal(size=3), rng.uniform(-3.0, 3.0, 3))
    return with_tool(in_other_coordinates(arm, T, signs, rng.uniform(-3.0, 3.0, arm.n)), tool)


def errors(a: SerialArm, b: SerialArm, link: int) -> tuple[float, float]:
    """Largest Δτ of equal arms, and how far that of a planted 1 % of mass is off [N m]."""
    states = random_states(a.n, 50, seed=1)
    pair = pair_up(a, b)
    equal = rnea(pair.a, states.q, states.qd, states.qdd)
    equal -= rnea(pair.b, states.q, states.qd, states.qdd)
    planted = rnea(heavier(a, link, 1.01), states.q, states.qd, states.qdd)
    found = rnea(pair_up(a, heavier(b, link, 1.01)).b, states.q, states.qd, states.qdd)
    return float(np.abs(equal).max()), float(np.abs(found - planted).max())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--family", choices=tuple(FAMILIES), action="append")
    args = parser.parse_args()
    print(f"{'arm':28} {'moved':6} {'tilt':5} {'equal':>9} {'planted':>9}  worst [N m]    s")
    for name in args.family or FAMILIES:
        for moved, tilt in itertools.product((False, True), (0.0, 0.3)):
            start, found = time.perf_counter(), []
            for seed in range(args.seeds):
                arm, rng = family(name, seed, tilt=tilt), np.random.default_rng(seed)
                for signs in itertools.product((1.0, -1.0), repeat=arm.n):
                    b = disguised(arm, signs, rng, moved=moved)
                    found.append(errors(arm, b, int(rng.integers(arm.n))))
            off = np.array(found)
            good = (off <= SAME).sum(axis=0)
            print(
                f"{name:28} {moved!s:6} {tilt:<5} {good[0]:4}/{len(off):<4} "
                f"{good[1]:4}/{len(off):<4} {off[:, 0].max():.1e} {off[:, 1].max():.1e} "
                f"{time.perf_counter() - start:5.1f}",
                flush=True,
            )


if __name__ == "__main__":
    main()
