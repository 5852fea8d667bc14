"""Recordings of robots simulated by MuJoCo: a motion under control, drives, and a logger's faults.

MuJoCo is another origin than the code that is tried on them: its own forward dynamics, its own dry
friction (a constraint of its solver, not a tanh), its own integration.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import mujoco
import numpy as np
from numpy.typing import NDArray

from ur5check._io.mjcf.mjcf_writer import mjcf_of
from ur5check._robot import SerialArm

__all__ = ["Drives", "Logger", "drives_of", "recorded", "simulated"]

Array = NDArray[np.float64]

_STEP = 1e-3  # [s] of the simulation and the controller
_HARMONICS, _BASE = 5, 0.1  # of the trajectory [Hz]


@dataclass(frozen=True, eq=False)
class Drives:
    """Of each joint: viscous [N m s/rad], Coulomb [N m], rotor inertia [kg m²]; shape (n,)."""

    viscous: Array
    coulomb: Array
    rotor: Array


@dataclass(frozen=True)
class Logger:
    """What the logger adds.

    rate : samples a second [Hz]
    noise : of the torque, over its standard deviation
    encoder : step of the position [rad]
    jitter : largest deviation of a sample's time from its place [s]
    lag : of the velocity [s]
    gains : that the torques are multiplied with, shape (n,) or one
    """

    rate: float = 125.0
    noise: float = 0.01
    encoder: float = 2e-5
    jitter: float = 0.0
    lag: float = 0.0
    gains: float | Array = field(default=1.0)


def drives_of(arm: SerialArm, rng: np.random.Generator) -> Drives:
    """Friction of 5 to 15 % of the torque that gravity and motion ask of a joint, at least 0.2 N m;
    rotors as of gears with a ratio of 100.
    """
    from ur5check import rnea

    q = rng.uniform(-1.0, 1.0, (200, arm.n))
    size = np.abs(np.asarray(rnea(arm, q, 0.0 * q, rng.normal(size=q.shape)))).max(axis=0)
    size = np.maximum(size, 2.0)
    return Drives(
        size * rng.uniform(0.05, 0.15, arm.n),
        size * rng.uniform(0.05, 0.15, arm.n),
        0.01 * size * rng.uniform(0.5, 2.0, arm.n),
    )


def simulated(
    arm: SerialArm, drives: Drives, rng: np.random.Generator, duration: float
) -> tuple[Array, Array, Array, Array]:
    """t, shape (N,), and q, qd, tau, shape (N, n), at every step of the simulation.

    A Fourier series is tracked by computed torque with feedback; friction disturbs it.
    """
    model = mujoco.MjModel.from_xml_string(mjcf_of(arm.with_armature(drives.rotor)))
    model.opt.timestep = _STEP
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_LIMIT
    model.opt.gravity[:] = arm.gravity
    model.dof_damping[:] = drives.viscous
    model.dof_frictionloss[:] = drives.coulomb
    model.dof_armature[:] = drives.rotor
    # As stiff as the step allows: dry friction that MuJoCo's default, meant for contacts, softens
    # would act as inertia while a joint reverses.
    model.dof_solref[:] = 2.0 * _STEP, 1.0
    data = mujoco.MjData(model)
    n = arm.n
    t = _STEP * np.arange(int(duration / _STEP))
    wanted, speed, acceleration = _trajectory(t, n, rng)
    data.qpos[:], data.qvel[:] = wanted[0], speed[0]
    q, qd, tau = (np.empty((len(t), n)) for _ in range(3))
    torque, feedback = np.empty(n), np.empty(n)
    for k in range(len(t)):
        mujoco.mj_forward(model, data)
        feedback[:] = (
            acceleration[k] + 30.0 * (speed[k] - data.qvel) + 225.0 * (wanted[k] - data.qpos)
        )
        mujoco.mj_mulM(model, data, torque, feedback)
        torque += data.qfrc_bias
        data.qfrc_applied[:] = torque
        q[k], qd[k], tau[k] = data.qpos, data.qvel, torque
        mujoco.mj_step(model, data)
    return t, q, qd, tau


def _trajectory(t: Array, n: int, rng: np.random.Generator) -> tuple[Array, Array, Array]:
    q, qd, qdd = (np.zeros((len(t), n)) for _ in range(3))
    for j in range(n):
        q[:, j] = rng.uniform(-1.2, 1.2)
        for k in range(1, _HARMONICS + 1):
            w = 2.0 * np.pi * _BASE * k
            a, b = rng.normal(size=2) * 0.5 / k
            q[:, j] += a * np.sin(w * t) + b * np.cos(w * t)
            qd[:, j] += w * (a * np.cos(w * t) - b * np.sin(w * t))
            qdd[:, j] -= w * w * (a * np.sin(w * t) + b * np.cos(w * t))
    return q, qd, qdd


def recorded(
    motion: tuple[Array, Array, Array, Array],
    logger: Logger,
    rng: np.random.Generator,
    file: Path,
) -> Path:
    """Write what the logger makes of a motion: columns t, q, qd, tau without header."""
    t, q, qd, tau = motion
    count = int(t[-1] * logger.rate)
    at = np.arange(count) / logger.rate + rng.uniform(-1.0, 1.0, count) * logger.jitter
    at = at.clip(0.0, t[-1])

    def sampled(values: Array, times: Array) -> Array:
        return np.stack([np.interp(times, t, column) for column in values.T], axis=1)

    position = np.rint(sampled(q, at) / logger.encoder) * logger.encoder
    velocity = sampled(qd, (at - logger.lag).clip(0.0)) + 1e-3 * rng.normal(
        size=(count, q.shape[1])
    )
    torque = sampled(tau, at) * logger.gains
    torque += rng.normal(size=torque.shape) * logger.noise * torque.std(axis=0)
    np.savetxt(file, np.column_stack([at, position, velocity, torque]), delimiter=",", fmt="%.8g")
    return file
