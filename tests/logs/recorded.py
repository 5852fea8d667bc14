"""Recordings of a small arm whose truth is known: motion, drives, payload, and what a logger adds.

The torques come from the arm's own equations, so that a right analysis finds the planted numbers.
`benchmarks/bench_recordings.py` has recordings of another origin, simulated by MuJoCo.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from three_joints import ARM
from ur5check import Inertia, SerialArm, load, rnea
from ur5check._robot.transforms import Array

#: Viscous [N m s/rad], Coulomb [N m], offset [N m], rotor [kg m²] of each drive.
DRIVES = np.array([[2.0, 1.5, 0.2, 0.3], [1.5, 1.0, -0.1, 0.2], [0.3, 0.2, 0.05, 0.02]])


@dataclass(frozen=True, eq=False)
class Motion:
    """What a logger wrote: t, shape (N,); q, qd, tau, shape (N, n)."""

    t: Array
    q: Array
    qd: Array
    tau: Array

    def table(self) -> Array:
        """Columns t, q, qd, tau."""
        return np.column_stack([self.t, self.q, self.qd, self.tau])


def small_arm(folder: Path) -> SerialArm:
    """Three joints, 4.9 kg that move."""
    return load(small_model(folder))


def small_model(folder: Path) -> Path:
    """The small arm as a URDF file."""
    file = folder / "three.urdf"
    file.write_text(ARM, encoding="utf-8")
    return file


def motion_of(
    arm: SerialArm,
    *,
    seed: int = 0,
    duration: float = 20.0,
    rate: float = 100.0,
    noise: float = 0.01,
    gains: float | Array = 1.0,
    gravity: Array | None = None,
    drives: Array = DRIVES,
    times: Array | None = None,
    motion: int = 5,
) -> Motion:
    """A sum of sines, five harmonics of 0.1 Hz; noise of the torque relative to its spread.

    seed : of the noise;  motion : of the trajectory, so that two recordings can share one
    """
    rng = np.random.default_rng(motion)
    t = np.arange(0.0, duration, 1.0 / rate) if times is None else times
    q, qd, qdd = (np.zeros((len(t), arm.n)) for _ in range(3))
    for j in range(arm.n):
        q[:, j] = rng.uniform(-1.0, 1.0)
        for k in range(1, 6):
            w = 2.0 * np.pi * 0.1 * k
            a, b = rng.normal(size=2) * 0.5 / k
            q[:, j] += a * np.sin(w * t) + b * np.cos(w * t)
            qd[:, j] += w * (a * np.cos(w * t) - b * np.sin(w * t))
            qdd[:, j] -= w * w * (a * np.sin(w * t) + b * np.cos(w * t))
    rng = np.random.default_rng(seed)
    bare = arm.with_armature(np.zeros(arm.n))
    tau = np.asarray(rnea(bare, q, qd, qdd, gravity=arm.gravity if gravity is None else gravity))
    viscous, coulomb, offset, rotor = drives[: arm.n].T
    tau = tau + viscous * qd + coulomb * np.tanh(qd / 0.02) + offset + rotor * qdd
    tau = tau * gains + rng.normal(size=tau.shape) * noise * tau.std(axis=0)
    q = q + rng.normal(size=q.shape) * 1e-5
    return Motion(t, q, qd + rng.normal(size=q.shape) * 1e-4, tau)


def loaded(arm: SerialArm, mass: float, centre: tuple[float, float, float]) -> SerialArm:
    """The arm with a small ball in its tip frame."""
    ball = Inertia(mass, np.array(centre), 1e-4 * abs(mass) * np.eye(3))
    return changed(arm, -1, arm.links[-1].inertia + ball)


def changed(arm: SerialArm, link: int, inertia: Inertia) -> SerialArm:
    """The arm with another inertia of one link (from 0)."""
    inertias = [own.inertia for own in arm.links]
    inertias[link] = inertia
    return arm.with_inertias(inertias)


def heavier(arm: SerialArm, link: int, factor: float) -> SerialArm:
    """The arm with one link's mass times a factor; centre and tensor as they are."""
    own = arm.links[link].inertia
    return changed(arm, link, replace(own, mass=factor * own.mass))


def write(motion: Motion, file: Path, header: str = "") -> Path:
    """A CSV of t, q, qd, tau; with a header if one is given."""
    np.savetxt(file, motion.table(), delimiter=",", fmt="%.9g", header=header, comments="")
    return file
