"""Arms that the tests share."""

from __future__ import annotations

import numpy as np

from ur5check._robot import Inertia, Joint, Link, SerialArm, Transform

UR5S = ("paper", "paper-listing", "appendix", "erd-ur5")


def random_arm(n: int, seed: int, *, prismatic: bool = True) -> SerialArm:
    """A chain of n joints in no particular frames, each link a possible body."""
    rng = np.random.default_rng(seed)
    joints, links = [], []
    for i in range(1, n + 1):
        kind = "prismatic" if prismatic and rng.random() < 0.25 else "revolute"
        joints.append(Joint(f"joint_{i}", rng.normal(size=3), kind))
        root = rng.normal(size=(3, 3)) * 0.1
        second_moment = root @ root.T
        tensor = np.trace(second_moment) * np.eye(3) - second_moment
        link_tip_frame = Transform.from_rpy(rng.normal(size=3) * 0.3, rng.uniform(-3, 3, 3))
        inertia = Inertia(rng.uniform(0.5, 5.0), rng.normal(size=3) * 0.1, tensor)
        links.append(Link(f"link_{i}", link_tip_frame, inertia))
    base = Transform.from_rpy(rng.normal(size=3), rng.uniform(-3, 3, 3))
    return SerialArm(f"chain_{n}", tuple(joints), tuple(links), base, rng.normal(size=3) * 6)


def planar_arm(lengths: tuple[float, ...], masses: tuple[float, ...]) -> SerialArm:
    """Point masses at the ends of rods that lie along x and turn about y."""
    joints = [Joint(f"joint_{i}", np.array([0.0, 1.0, 0.0])) for i in range(len(lengths))]
    links = [
        Link(
            f"rod_{i}",
            Transform.translation((length, 0, 0)),
            Inertia(mass, np.zeros(3), np.zeros((3, 3))),
        )
        for i, (length, mass) in enumerate(zip(lengths, masses, strict=True))
    ]
    return SerialArm("planar", tuple(joints), tuple(links))
