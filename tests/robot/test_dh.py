from __future__ import annotations

import math

import numpy as np
import pytest

import ur5check
from ur5check._errors import ModelError
from ur5check._robot import DHRow, Inertia, arm_from_dh
from ur5check._robot.states import random_states

TABLE = [
    (0.1, 0.2, 0.3, 0.4),
    (0.0, -0.4, math.pi / 2, -1.0),
    (0.3, 0.0, -1.2, 0.0),
]  # d a α offset


def rows(**more):
    body = Inertia(2.0, np.array([0.1, -0.2, 0.05]), np.diag([0.2, 0.3, 0.4]))
    return [
        DHRow(f"l{i}", d, a, alpha, body, f"j{i}", offset=offset, **more)
        for i, (d, a, alpha, offset) in enumerate(TABLE)
    ]


def rot(axis, angle):
    c, s = math.cos(angle), math.sin(angle)
    T = np.eye(4)
    i, j = {"x": (1, 2), "z": (0, 1)}[axis]
    T[i, i] = T[j, j] = c
    T[i, j], T[j, i] = -s, s
    return T


def trans(axis, length):
    T = np.eye(4)
    T["xyz".index(axis), 3] = length
    return T


@pytest.mark.parametrize("q", random_states(3, 5, seed=0).q)
def test_the_standard_convention_is_equation_1(q):
    expected = np.eye(4)
    for theta, (d, a, alpha, offset) in zip(q, TABLE, strict=True):
        expected = (
            expected @ rot("z", theta + offset) @ trans("z", d) @ trans("x", a) @ rot("x", alpha)
        )
    np.testing.assert_allclose(
        ur5check.forward_kinematics(arm_from_dh("a", rows()), q), expected, atol=1e-15
    )


@pytest.mark.parametrize("q", random_states(3, 5, seed=1).q)
def test_the_modified_convention_is_craigs(q):
    expected = np.eye(4)
    for theta, (d, a, alpha, offset) in zip(q, TABLE, strict=True):
        expected = (
            expected @ rot("x", alpha) @ trans("x", a) @ rot("z", theta + offset) @ trans("z", d)
        )
    arm = arm_from_dh("a", rows(), convention="modified")
    np.testing.assert_allclose(ur5check.forward_kinematics(arm, q), expected, atol=1e-15)


def test_a_modified_row_holds_its_inertia_in_its_own_frame():
    # Potential energy by hand: Σ m g z of the centres, each placed by its own row's transform.
    arm, q = arm_from_dh("a", rows(), convention="modified"), [0.3, -0.7, 1.9]
    T, energy = np.eye(4), 0.0
    for theta, (d, a, alpha, offset) in zip(q, TABLE, strict=True):
        T = T @ rot("x", alpha) @ trans("x", a) @ rot("z", theta + offset) @ trans("z", d)
        energy += 2.0 * 9.81 * (T @ [0.1, -0.2, 0.05, 1.0])[2]
    assert ur5check.potential_energy(arm, q) == pytest.approx(energy)


def test_r_stands_in_place_of_d_and_a():
    arm = arm_from_dh("a", rows(r=np.array([0.5, 0.0, 0.0])))
    np.testing.assert_allclose(
        arm.links[0].link_tip_frame.R.T @ arm.links[0].link_tip_frame.p, [0.5, 0, 0], atol=1e-15
    )


def test_r_means_nothing_in_the_modified_convention():
    with pytest.raises(ModelError, match="standard convention"):
        arm_from_dh("a", rows(r=np.zeros(3)), convention="modified")
