"""The same lines under JAX: values, batches, and slopes."""

from __future__ import annotations

import jax
import numpy as np
import pytest

import ur5check as ur5
from examples import planar_arm
from ur5check._dynamics.compiled.jax_function import jax_rnea, jax_torque_difference
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._errors import UsageError
from ur5check._robot.states import random_states


@pytest.fixture
def in_64_bits():
    before = jax.config.jax_enable_x64  # type: ignore[attr-defined]
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.fixture(scope="module")
def arm():
    return ur5.load("paper")


STATES = random_states(6, 20, seed=1)
GIVEN = (STATES.q, STATES.qd, STATES.qdd)


def test_a_batch_is_the_recursion(arm, in_64_bits):
    found = jax.jit(jax.vmap(jax_rnea(arm)))(*GIVEN)
    assert np.abs(np.asarray(found) - ur5.rnea(arm, *GIVEN)).max() <= 1e-11


def test_slopes_are_pinocchios(arm, in_64_bits):
    slopes = jax.jit(jax.vmap(jax.jacfwd(jax_rnea(arm), argnums=(0, 1, 2))))(*GIVEN)
    wanted = PinocchioEngine(arm).inverse_dynamics_gradient(*GIVEN)
    for ours, theirs in zip(slopes, wanted, strict=True):
        assert np.abs(np.asarray(ours) - theirs).max() <= 1e-9


def test_the_slope_of_a_difference_is_pinocchios(in_64_bits):
    """Of Σ Δτ², which a search for the worst case climbs: 2 Δτᵀ ∂Δτ/∂q."""
    arms = [planar_arm((0.4, 0.3), masses) for masses in ((2.0, 1.0), (2.0, 1.5))]
    state = tuple(array[0, :2] for array in GIVEN)
    delta = jax_torque_difference(*arms)
    size = jax.jit(jax.grad(lambda q, qd, qdd: (delta(q, qd, qdd) ** 2).sum()))
    references = [PinocchioEngine(arm) for arm in arms]
    tau = [reference.inverse_dynamics(*state) for reference in references]
    slope = [reference.inverse_dynamics_gradient(*state)[0] for reference in references]
    wanted = 2.0 * (tau[0] - tau[1]) @ (slope[0] - slope[1])
    assert np.abs(np.asarray(size(*state)) - wanted).max() <= 1e-9
    assert np.abs(wanted).max() > 0.1


def test_32_bits_are_refused(arm):
    assert not jax.config.jax_enable_x64  # type: ignore[attr-defined]
    with pytest.raises(UsageError, match="jax_enable_x64"):
        jax_rnea(arm)
