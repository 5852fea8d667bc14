"""Arms of any length, made from random numbers."""

from __future__ import annotations

import numpy as np

from ur5check._robot.inertia import Inertia
from ur5check._robot.serial_arm import Joint, Link, SerialArm
from ur5check._robot.transforms import Array, Transform

__all__ = ["chain"]


def chain(n: int, seed: int) -> SerialArm:
    """A chain of n revolute joints about z; each link a possible body, in any frame."""
    rng = np.random.default_rng((seed, n))
    links = []
    for i in range(1, n + 1):
        points = rng.normal(size=(4, 3)) * 0.1  # a quarter of the mass in each
        links.append(
            Link(
                f"link_{i}",
                Transform.from_rpy(
                    rng.normal(size=3) * 0.3, rng.uniform(-np.pi, np.pi, 3).tolist()
                ),
                _body(rng.uniform(0.5, 5.0), points),
            )
        )
    joints = [Joint(f"joint_{i}", np.array([0.0, 0.0, 1.0])) for i in range(1, n + 1)]
    return SerialArm(f"chain of {n}", tuple(joints), tuple(links))


def _body(mass: float, points: Array) -> Inertia:
    com = points.mean(axis=0)
    second_moment = mass * np.cov(points.T, bias=True)
    return Inertia(mass, com, np.trace(second_moment) * np.eye(3) - second_moment)
