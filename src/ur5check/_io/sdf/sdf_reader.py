"""The arm in an SDF file: the robot that `sdf_robot` reads, and the chain between two links."""

from __future__ import annotations

from ..._robot import SerialArm
from ..._rules.finding_log import FindingLog
from ..arm_loading import load_arm
from ..model_format import ModelFile
from .sdf_robot import read_sdf_robot

__all__ = ["read_sdf_file"]


def read_sdf_file(file: ModelFile) -> SerialArm:
    """The arm between two links of an SDF (default: as `arm_of_robot` chooses).

    Raises ModelError for a faulty file, several models, an `<include>`, a moving link without
    `<inertial>`, a joint that is neither revolute nor prismatic, and where Drake refuses.
    """
    log = FindingLog()
    robot = read_sdf_robot(file.data, file.label, log)
    return load_arm(robot, tuple(log.findings), base=file.base, tip=file.tip, strict=file.strict)
