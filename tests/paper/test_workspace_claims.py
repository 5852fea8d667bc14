"""Figure 3's sphere and cylinder against the reach of the arm."""

from __future__ import annotations

import numpy as np
import pytest

from ur5check._dynamics.kinematics import forward_kinematics
from ur5check._paper import workspace_claims
from ur5check._paper.evidence import Evidence
from ur5check._paper.paper_models import REPAIRED


def test_the_reach_is_where_the_lengths_say(evidence: Evidence) -> None:
    """Closed form: links 2 and 3 straight, then the largest distance over joints 4 and 5.

    Seen from the shoulder the tool is at r + d5 u + d6 w with r = (0.81725, d4), u in the plane of
    the arm and w perpendicular to u; over the direction of w, then of u, that is
    max over |u| = 1 of (r + d5 u)² + d6² + 2 d6 |(r + d5 u) − u (u·(r + d5 u))|.
    """
    length, d4, d5, d6 = 0.81725, 0.10915, 0.09465, 0.0823
    angle = np.linspace(0.0, np.pi, 200_001)
    along, across = np.cos(angle), np.sin(angle)
    x, y, z = length + d5 * along, d5 * across, np.full_like(angle, d4)
    u = along * x + across * y
    lever = np.sqrt(np.maximum(x**2 + y**2 + z**2 - u**2, 0.0))
    reach = np.sqrt(x**2 + y**2 + z**2 + d6**2 + 2.0 * d6 * lever).max()
    found = workspace_claims.outer_diameter(evidence.model(REPAIRED).arm)
    assert found == pytest.approx(2.0 * reach, abs=1e-8)


def test_no_random_posture_reaches_further_or_nearer(evidence: Evidence) -> None:
    arm = evidence.model(REPAIRED).arm
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (20_000, 6))
    tool = forward_kinematics(arm, q)[:, :3, 3] - [0.0, 0.0, 0.089159]
    outer, inner = workspace_claims.outer_diameter(arm), workspace_claims.inner_diameter(arm)
    assert np.linalg.norm(tool, axis=1).max() <= outer / 2.0
    assert np.linalg.norm(tool, axis=1).max() > 0.97 * outer / 2.0
    assert np.hypot(tool[:, 0], tool[:, 1]).min() >= inner / 2.0 - 1e-12
    assert inner == pytest.approx(2.0 * (0.10915 - 0.0823))


@pytest.mark.parametrize(("diameter", "holds"), [(1.7, False), (1.86, True), (1.94, True)])
def test_a_sphere_of_another_size_is_refused(
    evidence: Evidence, diameter: float, holds: bool
) -> None:
    arm = evidence.model(REPAIRED).arm
    assert workspace_claims.sphere_trial("arm", "printed", arm, diameter).holds is holds


def test_a_cylinder_that_the_tool_enters_is_refused(evidence: Evidence) -> None:
    arm = evidence.model(REPAIRED).arm
    assert not workspace_claims.cylinder_trial("arm", "printed", arm).holds
    assert workspace_claims.cylinder_trial("arm", "printed", arm, 0.1).holds


def test_what_is_printed_is_refuted(evidence: Evidence) -> None:
    (sphere,) = workspace_claims.sphere_is_the_reach(evidence)
    (cylinder,) = workspace_claims.cylinder_is_unreachable(evidence)
    assert (sphere.verdict, cylinder.verdict) == ("refuted", "refuted")
