"""The same lines under JAX: values, batches, and slopes."""

from __future__ import annotations

import jax
import numpy as np
import pytest

import ur5check as ur5
from examples import random_arm
from ur5check.arm.states import random_states
from ur5check.engines.pinocchio import PinocchioEngine
from ur5check.errors import UsageError
from ur5check.kernels.jax_function import jax_rnea, jax_torque_difference


@pytest.fixture
def in_64_bits():
    before = jax.config.jax_enable_x64
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


def test_the_slope_of_a_difference_leads_up(in_64_bits):
    a = random_arm(3, seed=1)
    b = a.with_inertias([link.inertia for link in random_arm(3, seed=2).links])
    difference = jax_torque_difference(a, b)
    q, qd, qdd = (array[0, :3] for array in GIVEN)
    size = jax.jit(lambda q: (difference(q, qd, qdd) ** 2).sum())
    up = jax.grad(size)(q)
    assert size(q + 1e-4 * up / np.linalg.norm(up)) > size(q)


def test_32_bits_are_refused(arm):
    assert not jax.config.jax_enable_x64
    with pytest.raises(UsageError, match="jax_enable_x64"):
        jax_rnea(arm)
