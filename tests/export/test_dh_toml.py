"""A DH table written and read is the same table."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import ur5check
from ur5check import strategies as ur5
from ur5check.arm import DHRow, Limits, arm_from_dh
from ur5check.arm.states import random_states
from ur5check.errors import UsageError
from ur5check.export.dh_toml import dh_toml_of
from ur5check.sources.dh_file import read_dh


def assert_same(arm):
    again = read_dh(dh_toml_of(arm).encode("utf-8"), file="written.toml")
    assert (again.name, again.joint_names) == (arm.name, arm.joint_names)
    assert [j.limits for j in again.joints] == [j.limits for j in arm.joints]
    states = random_states(arm.n, 20, seed=2)
    taus = [ur5check.rnea(a, states.q, states.qd, states.qdd) for a in (arm, again)]
    np.testing.assert_allclose(*taus, rtol=0, atol=1e-12 * np.abs(taus[0]).max())


@pytest.mark.parametrize("name", ["paper", "paper-listing"])
def test_shipped_table_reads_back_as_itself(name):
    assert_same(ur5check.load(name))


lengths, angles = st.floats(-1, 1), st.floats(-np.pi, np.pi)
rows = st.lists(
    st.builds(
        DHRow, link=st.just(""), joint=st.just(""), d=lengths, a=lengths, alpha=angles,
        offset=angles, inertia=ur5.inertias(), kind=st.sampled_from(["revolute", "prismatic"]),
        limits=st.just(Limits(-1.0, 2.0, 3.0)),
    ),
    min_size=1, max_size=5,
)  # fmt: skip


@given(rows)
def test_any_standard_table_reads_back_as_itself(table):
    from dataclasses import replace

    named = [replace(row, link=f"l{i}", joint=f"j{i}") for i, row in enumerate(table)]
    assert_same(arm_from_dh('a "quoted" name', named, gravity=(1.0, 2.0, -9.0)))


def test_lengths_are_those_of_the_table():
    body = ur5check.load("paper").links[0].inertia
    row = DHRow("l", 0.2, -0.3, np.pi / 2, body, "j", offset=0.7)
    text = dh_toml_of(arm_from_dh("one", [row]))
    assert "\nd = 0.2\na = -0.3\nalpha = 1.5707963267948966\noffset = 0.7\nmass" in text


def test_hand_written_reach_is_kept_where_d_and_a_do_not_give_it():
    text = dh_toml_of(ur5check.load("paper-listing"))
    assert "r = [0.0, 0.089159, 0.0]" in text


def test_urdf_frames_are_refused_with_advice():
    with pytest.raises(UsageError, match="write it as a URDF"):
        dh_toml_of(ur5check.load("appendix"))
