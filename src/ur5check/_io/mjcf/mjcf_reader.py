"""The arm in an MJCF file: the robot that `mjcf_robot` reads, and the chain between two bodies."""

from __future__ import annotations

from pathlib import Path

from ..._robot import SerialArm
from ..._rules.finding_log import FindingLog
from ..arm_loading import load_arm
from ..model_format import ModelFile
from .mjcf_robot import read_mjcf_robot

__all__ = ["read_mjcf", "read_mjcf_file"]


def read_mjcf_file(file: ModelFile) -> SerialArm:
    """The arm in an MJCF.  Raises ModelError as `read_mjcf` does."""
    return read_mjcf(
        file.data,
        file=file.label,
        folder=file.path.parent,
        base=file.base,
        tip=file.tip,
        strict=file.strict,
    )


def read_mjcf(
    data: bytes,
    *,
    file: str,
    folder: Path,
    base: str | None = None,
    tip: str | None = None,
    strict: bool = True,
) -> SerialArm:
    """The arm between two bodies or sites of an MJCF model.

    data : the file's bytes;  file : what errors and reports call it
    folder : where its included files and meshes are
    base : body to start from (default: the body that stands in the world and carries the arm)
    tip : body or site to end at (default: as `arm_of_robot` chooses);  strict : as `load_arm`

    Raises ModelError for a faulty file, for what is not part of a serial arm of rigid bodies (a
    ball joint, a spring, a constraint or tendon across the arm), and where MuJoCo refuses.
    """
    log = FindingLog()
    frames = [name for name in (base, tip) if name is not None]
    robot = read_mjcf_robot(data, file, folder, log, frames=frames)
    return load_arm(robot, tuple(log.findings), base=base, tip=tip, strict=strict)
