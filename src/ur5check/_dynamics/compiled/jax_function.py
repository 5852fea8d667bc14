"""The generated program as a JAX function: `jit`, `vmap` and `grad` work on it, on a CPU or a GPU.

jax.config.update("jax_enable_x64", True)
tau = jax_rnea(ur5check.load("paper"))
torques = jax.jit(jax.vmap(tau))(q, qd, qdd)
slope = jax.jacfwd(tau)(q[0], qd[0], qdd[0])
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..._errors import UsageError
from ..._robot.as_arm import ArmSource
from ..._robot.serial_arm import SerialArm
from ..symbolic.program import Program, read_input, value_of
from ..symbolic.trace import trace, trace_difference

__all__ = ["jax_rnea", "jax_torque_difference"]

JaxFunction = Callable[[Any, Any, Any], Any]


def jax_rnea(arm: ArmSource) -> JaxFunction:
    """Inverse dynamics of one state as a JAX function, under the arm's own gravity.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.

    Returns
    -------
    callable
        τ(q, q̇, q̈): arrays of shape (n,) [rad], [rad/s], [rad/s²] to one of shape (n,) [N m];
        `jax.jit`, `jax.vmap` and `jax.jacfwd` work on it.

    Raises
    ------
    InputError
        For an arm that cannot be read; if JAX is not installed, or computes with 32 bits.

    Examples
    --------
    >>> import jax
    >>> import ur5check
    >>> jax.config.update("jax_enable_x64", True)
    >>> rest = jax.numpy.zeros(6)
    >>> ur5check.jax_rnea("appendix")(rest, rest, rest)[1:3].round(2).tolist()
    [-57.97, -14.48]
    """
    return _function(trace(arm, "tau"))


def jax_torque_difference(a: SerialArm, b: SerialArm) -> JaxFunction:
    """τ_a − τ_b of two arms in the same joint coordinates, otherwise as `jax_rnea`."""
    return _function(trace_difference(a, b))


def _function(program: Program) -> JaxFunction:
    try:
        import jax.numpy as jnp
    except ImportError:
        raise UsageError("JAX is not installed; pip install 'ur5check[jax]'") from None
    if jnp.asarray(1.0).dtype != jnp.float64:
        raise UsageError(
            "JAX computes with 32 bits, which limits the accuracy to 1e-5 N m; call "
            'jax.config.update("jax_enable_x64", True) first'
        )

    def evaluate(q: Any, qd: Any, qdd: Any) -> Any:
        arrays = {"q": q, "qd": qd, "qdd": qdd, "c": jnp.cos(q), "s": jnp.sin(q)}
        values: dict[str, Any] = {}
        for name in program.inputs:
            kind, joint = read_input(name)
            values[name] = arrays[kind][joint]
        for line in program.assignments:
            values[line.name] = value_of(line, values)
        entries = [value_of(line, values) for line in program.outputs]
        return jnp.stack([jnp.asarray(entry, dtype=jnp.float64) for entry in entries])

    return evaluate
