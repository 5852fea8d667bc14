"""Every rule of ur5check as a test of its own."""

from pathlib import Path

from ur5check.testing import parametrize_with_rules

URDF = Path(__file__).parents[1] / "urdf"


@parametrize_with_rules([URDF / "arm.urdf.xacro"])
def test_arm(model, check):
    check(model)
