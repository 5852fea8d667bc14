"""The generated program under JAX: jitted, mapped over states, on JAX's default device."""

from __future__ import annotations

from importlib import metadata
from typing import Any

import numpy as np

from ur5check._dynamics.compiled.jax_function import jax_rnea
from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.states import States
from ur5check._robot.transforms import Array

from .timing import Contestant

__all__ = ["jax_contestant"]


def jax_contestant(arm: SerialArm, states: States) -> Contestant | None:
    """None where JAX is not installed.

    The inputs are on the device before the timing starts; it ends when the result is ready.
    """
    try:
        metadata.version("jax")
    except metadata.PackageNotFoundError:
        return None
    import jax

    # 64 bits in this block and in each run only: JAX's setting elsewhere is left alone.
    with jax.enable_x64(True):
        torques = jax.jit(jax.vmap(jax_rnea(arm)))
        given: list[Any] = [jax.device_put(part) for part in (states.q, states.qd, states.qdd)]

    def run() -> Array:
        with jax.enable_x64(True):
            return np.asarray(torques(*given).block_until_ready())

    return Contestant(f"JAX on {jax.default_backend()}, its own threads", run, len(states.q))
