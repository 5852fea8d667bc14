"""The arms in which the mutation benchmark plants its mistakes, and their measurement noise."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
from mutations import Written, with_written, written
from numpy.typing import NDArray

from ur5check._io.loading import load
from ur5check._io.ros_packages import example_robot_data
from ur5check._robot import DHRow, Inertia, Joint, Link, SerialArm, Transform, arm_from_dh

__all__ = ["ARMS", "arm_called", "with_noise"]

Array = NDArray[np.float64]

#: Robots of example-robot-data: file, tip (None: the last link).
_ROBOTS = {
    "ur3": ("ur_description/urdf/ur3_robot.urdf", None),
    "ur5": ("ur_description/urdf/ur5_robot.urdf", None),
    "ur10": ("ur_description/urdf/ur10_robot.urdf", None),
    "panda": ("panda_description/urdf/panda.urdf", "panda_hand"),
    "kinova": ("kinova_description/robots/kinova.urdf", None),
    "xarm7": ("xarm_description/urdf/xarm7.urdf", None),
}

_CHAINS = ("chain-4", "chain-5-modified", "chain-8-standard")

#: Names for `arm_called`.
ARMS = (*_ROBOTS, "paper", *_CHAINS)


@cache
def arm_called(name: str, seed: int) -> SerialArm:
    """An arm by its name; the random chains are drawn from the seed."""
    if name in _ROBOTS:
        file, tip = _ROBOTS[name]
        share = example_robot_data()
        if share is None:
            raise SystemExit("example-robot-data is not installed")
        return load(str(share / "robots" / file), tip=tip)
    if name not in _CHAINS:
        return load(name)
    rng = np.random.default_rng([seed, _CHAINS.index(name)])
    if name == "chain-4":
        return _urdf_chain(name, 4, rng)
    return _dh_chain(name, 5 if "5" in name else 8, rng)


def _body(rng: np.random.Generator, size: float) -> Inertia:
    """A cylinder along an axis, or a body without symmetry; printed with six digits."""
    mass = float(np.round(rng.uniform(0.5, 6.0), 3))
    com = np.round(rng.uniform(-0.5, 0.5, 3) * size, 4)
    if rng.random() < 0.5:
        radius, length = rng.uniform(0.03, 0.08), rng.uniform(0.1, 0.4)
        moments = np.full(3, mass * (3.0 * radius**2 + length**2) / 12.0)
        moments[rng.integers(3)] = mass * radius**2 / 2.0
        tensor = np.diag(moments)
    else:
        radii = rng.uniform(0.02, 0.12, 3)
        R = Transform.from_rpy(np.zeros(3), [float(angle) for angle in rng.uniform(-1, 1, 3)]).R
        second_moment = mass * R @ np.diag(radii**2) @ R.T
        tensor = np.trace(second_moment) * np.eye(3) - second_moment
    return Inertia(mass, com, np.round(tensor, 8))


def _urdf_chain(name: str, n: int, rng: np.random.Generator) -> SerialArm:
    """Joints about any axes, origins of any orientation, one prismatic joint, fixed children."""
    joints, links = [], []
    sliding = int(rng.integers(1, n))
    for i in range(n):
        kind = "prismatic" if i == sliding else "revolute"
        joints.append(Joint(f"joint_{i + 1}", np.round(rng.normal(size=3), 2), kind))
        xyz, rpy = np.round(rng.uniform(-0.4, 0.4, 3), 4), np.round(rng.uniform(-2, 2, 3), 3)
        link_tip_frame = Transform.from_rpy(xyz, [float(angle) for angle in rpy])
        frame = link_tip_frame.inverse()
        child = Inertia(
            float(np.round(rng.uniform(0.2, 1.0), 3)),
            np.round(rng.uniform(-0.2, 0.2, 3), 4),
            np.diag(np.round(rng.uniform(1e-3, 1.3e-3, 3), 6)),
        )
        own = _body(rng, 0.3)
        links.append(
            Link(
                f"link_{i + 1}",
                link_tip_frame,
                (own + child).expressed_in(frame),
                frame,
                ((f"child_{i + 1}", child.expressed_in(frame)),),
            )
        )
    base = Transform.from_rpy((0.0, 0.0, 0.2), [0.3, -0.2, 0.5])
    return SerialArm(name, tuple(joints), tuple(links), base)


def _dh_chain(name: str, n: int, rng: np.random.Generator) -> SerialArm:
    """DH rows: quarter turns and others, lengths of which some are zero."""
    rows = []
    for i in range(n):
        d, a = np.round(rng.uniform(0.1, 0.5, 2) * rng.choice([-1, 1], 2), 4) * (
            rng.random(2) < 0.7
        )
        turns = [np.pi / 2, -np.pi / 2, 0.0, float(np.round(rng.uniform(-1.5, 1.5), 3))]
        alpha = turns[int(rng.integers(4))]
        rows.append(
            DHRow(f"link_{i + 1}", float(d), float(a), alpha, _body(rng, 0.4), f"joint_{i + 1}")
        )
    convention = "modified" if name.endswith("modified") else "standard"
    return arm_from_dh(name, rows, convention=convention)


# --- measurement noise ----------------------------------------------------------------------------


def with_noise(
    arm: SerialArm,
    level: float,
    rng: np.random.Generator,
    *,
    truth: SerialArm | None = None,
    lengths: bool = False,
) -> SerialArm:
    """Every inertial number that a file holds times 1 + U(−level, level).

    truth : numbers that differ from this arm's were planted, and stay as they are
    lengths : noise on the fixed translations, too
    """
    right = [written(link) for link in (truth or arm).links]
    numbers = {
        i: _noisy(written(link), truth_here, level, rng)
        for i, (link, truth_here) in enumerate(zip(arm.links, right, strict=True))
    }
    noisy = with_written(arm, numbers)
    return _with_lengths(noisy, level, rng) if lengths else noisy


def _noisy(own: Written, truth: Written, level: float, rng: np.random.Generator) -> Written:
    mass = float(_spread(np.array(own.mass), np.array(truth.mass), level, rng))
    com = _spread(own.com, truth.com, level, rng)
    planted = bool((np.abs(own.tensor - truth.tensor) > 1e-9 * np.abs(truth.tensor).max()).any())
    possible = _possible(own.tensor)
    while True:
        tensor = _spread(own.tensor, truth.tensor, level, rng)
        # A rod's small moment is the least that its large ones may differ by: noise that asks for
        # a negative moment is drawn again, a little smaller.
        if planted or not possible or _possible(tensor):
            return Written(mass, com, tensor)
        level *= 0.8


def _spread(own: Array, truth: Array, level: float, rng: np.random.Generator) -> Array:
    factors = 1.0 + rng.uniform(-level, level, own.shape)
    if own.ndim == 2:
        factors = np.tril(factors) + np.tril(factors, -1).T
    unplanted = np.abs(own - truth) <= 1e-9 * np.abs(truth).max()
    return np.asarray(np.where(unplanted, own * factors, own))


def _possible(tensor: Array) -> bool:
    moments = np.linalg.eigvalsh(tensor)
    return bool(moments[0] > 0.0 and moments[0] + moments[1] >= moments[2])


def _with_lengths(arm: SerialArm, level: float, rng: np.random.Generator) -> SerialArm:
    links = []
    for link in arm.links:
        P = link.link_tip_frame
        link_tip_frame = Transform(P.R, P.p * (1.0 + rng.uniform(-level, level, 3)))
        at_joint = np.abs((P @ link.source_frame).matrix() - np.eye(4)).max() < 1e-6
        frame = link_tip_frame.inverse() if at_joint else link.source_frame
        inertia = link.inertia.expressed_in(frame @ link.source_frame.inverse())
        links.append(
            replace(link, link_tip_frame=link_tip_frame, source_frame=frame, inertia=inertia)
        )
    return replace(arm, links=tuple(links))
