"""The appendix's soft limits, read from the xacro itself."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from ur5check._paper.evidence import Evidence
from ur5check._paper.reproduction import Reproduction
from ur5check._paper.soft_limits import SoftLimits, read_soft_limits, soft_limit_trial

GOOD = SoftLimits("joint", -1.0, 1.0, -0.85, 0.85)

URDF = """\
<robot name="r"><link name="a"/><link name="b"/><link name="c"/>
  <joint name="one" type="revolute"><parent link="a"/><child link="b"/>
    <limit lower="-1.5" upper="2" effort="1" velocity="1"/>
    <safety_controller soft_lower_limit="-1.25" soft_upper_limit="1.5" k_velocity="0"/></joint>
  <joint name="two" type="revolute"><parent link="b"/><child link="c"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>"""


def test_a_joint_with_a_safety_controller_is_read() -> None:
    assert read_soft_limits(URDF) == (SoftLimits("one", -1.5, 2.0, -1.25, 1.5),)


@pytest.mark.parametrize("spoiled", [{"soft_lower": -1.1}, {"soft_upper": 1.0}, {"lower": -0.8}])
def test_a_soft_limit_outside_is_refused_on_either_side(spoiled: dict[str, float]) -> None:
    assert soft_limit_trial("arm", "printed", (GOOD,)).holds
    bad = replace(GOOD, joint="elbow", **spoiled)
    trial = soft_limit_trial("arm", "printed", (GOOD, bad, GOOD))
    assert not trial.holds
    assert trial.why.startswith("elbow: ")


def test_the_elbows_soft_limits_are_counted_from_the_wrong_turn(
    reproduction: Reproduction, evidence: Evidence
) -> None:
    printed, limited = reproduction.outcomes("soft-limits")
    assert printed.verdict == "refuted"
    assert printed.value == pytest.approx(0.15 - math.pi)
    assert printed.why.startswith("elbow_joint: soft ±6.133, hard ±3.142 rad")
    assert limited.verdict == "confirmed"
    assert limited.value == pytest.approx(0.15)
