"""The hand-written dynamics against arms that a textbook solves on one page."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from examples import planar_arm
from ur5check._robot import Inertia, Joint, Link, SerialArm, Transform

G = 9.81
Q = np.linspace(-3.0, 3.0, 13)


def test_a_pendulum_needs_its_weight_times_its_lever():
    # About y, a positive turn takes +x down to −z: holding the mass up is a torque against it.
    arm = planar_arm((0.7,), (2.0,))
    expected = -2.0 * G * 0.7 * np.cos(Q)
    np.testing.assert_allclose(ur5check.gravity_torque(arm, Q[:, None])[:, 0], expected, atol=1e-13)


def test_two_rods_have_the_mass_matrix_of_the_textbook():
    # Siciliano et al. 2009, ch. 7, two-link arm, with all mass at the tips.
    (l1, l2), (m1, m2) = (0.5, 0.3), (3.0, 2.0)
    arm = planar_arm((l1, l2), (m1, m2))
    q = np.column_stack([Q, Q[::-1] * 0.7])
    c2 = np.cos(q[:, 1])
    M = ur5check.mass_matrix(arm, q)
    np.testing.assert_allclose(M[:, 0, 0], m1 * l1**2 + m2 * (l1**2 + l2**2 + 2 * l1 * l2 * c2))
    np.testing.assert_allclose(M[:, 0, 1], m2 * (l2**2 + l1 * l2 * c2), atol=1e-14)
    np.testing.assert_allclose(M[:, 1, 1], np.full(len(Q), m2 * l2**2))


def test_two_rods_have_the_christoffel_matrix_of_the_textbook():
    # Siciliano et al. 2009, ch. 7, two-link arm: C = h [[q̇2, q̇1 + q̇2], [−q̇1, 0]] with
    # h = −m2 l1 l2 sin q2.
    (l1, l2), (m1, m2) = (0.5, 0.3), (3.0, 2.0)
    arm = planar_arm((l1, l2), (m1, m2))
    q, qd = np.column_stack([Q, Q * 0.4]), np.column_stack([Q * 0.3, 1.0 - Q])
    h = -m2 * l1 * l2 * np.sin(q[:, 1])
    C = ur5check.coriolis_matrix(arm, q, qd)
    expected = h[:, None, None] * np.moveaxis(
        np.array([[qd[:, 1], qd.sum(axis=1)], [-qd[:, 0], np.zeros(len(Q))]]), -1, 0
    )
    np.testing.assert_allclose(C, expected, atol=1e-13)


def test_a_slide_carries_its_weight_and_its_inertia():
    arm = SerialArm(
        "base_acceleration",
        (Joint("base_acceleration", np.array([0, 0, 1.0]), "prismatic"),),
        (Link("car", Transform.identity(), Inertia(4.0, np.zeros(3), np.eye(3))),),
    )
    assert ur5check.rnea(arm, [0.2], [1.0], [3.0]) == pytest.approx([4.0 * (G + 3.0)])
    assert ur5check.potential_energy(arm, [0.2]) == pytest.approx(4.0 * G * 0.2)


def test_a_slide_on_a_turntable_feels_coriolis_and_centrifugal_force():
    # Polar coordinates: F = m (r̈ − r θ̇²), τ = m (r² θ̈ + 2 r ṙ θ̇).
    body = Inertia(2.0, np.zeros(3), np.zeros((3, 3)))
    arm = SerialArm(
        "polar",
        (Joint("turn", np.array([0, 0, 1.0])), Joint("slide", np.array([1.0, 0, 0]), "prismatic")),
        (
            Link("table", Transform.identity(), Inertia.zero()),
            Link("car", Transform.identity(), body),
        ),
    )
    r, rd, rdd, w, wd = 0.8, 0.5, 2.0, 1.5, -1.0
    tau = ur5check.rnea(arm, [0.3, r], [w, rd], [wd, rdd])
    assert tau == pytest.approx([2.0 * (r**2 * wd + 2 * r * rd * w), 2.0 * (rdd - r * w**2)])


def test_gravity_is_taken_in_the_base_frame():
    arm = planar_arm((0.7,), (2.0,))
    assert ur5check.gravity_torque(arm, [0.0], gravity=(0, 0, 9.81)) == pytest.approx([2 * G * 0.7])
    assert ur5check.gravity_torque(arm, [0.0], gravity=(-9.81, 0, 0)) == pytest.approx([0.0])


def test_the_tool_of_a_stretched_arm_is_at_its_reach():
    arm = planar_arm((0.5, 0.3), (1.0, 1.0))
    T = ur5check.forward_kinematics(arm, [[0.0, 0.0], [np.pi / 2, 0.0]])
    np.testing.assert_allclose(T[:, :3, 3], [[0.8, 0, 0], [0, 0, -0.8]], atol=1e-15)
