"""A file to a whole `Robot` with all that is wrong in it; nothing that stands in it raises."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from .._arguments import text_map
from .._errors import ModelError, UsageError
from .._files import read_regular
from .._finding import Finding
from .._robot.robot import Robot
from .._robot.serial_arm import SerialArm
from .._rules.finding_log import FindingLog
from .arm_names import tip_of_arm
from .formats import format_by_suffix, format_of_text
from .package_search import known_packages
from .ros_packages import PackageMap
from .shipped_models import SHIPPED_MODELS
from .suggestions import did_you_mean

if TYPE_CHECKING:
    from .xacro.xacro_places import SourcePlaces

__all__ = ["RobotReading", "load_robot", "read_robot"]


@dataclass(frozen=True, eq=False)
class RobotReading:
    """What reading a file gave.

    robot : None where the file describes none
    inputs : (name, SHA-256) of every file that was read
    base, tip : between which links the arm is taken: as asked, else a shipped model's own
    arm : of a DH table, which is nothing else
    packages : where package:// addresses lead;  folder : of the file
    """

    file: str
    robot: Robot | None
    findings: tuple[Finding, ...]
    packages: PackageMap
    folder: Path
    inputs: tuple[tuple[str, str], ...]
    arm: SerialArm | None = None
    base: str | None = None
    tip: str | None = None


def read_robot(
    model: str | Path,
    *,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
    base: str | None = None,
    tip: str | None = None,
    arm: str | None = None,
) -> RobotReading:
    """Read a model's file whole.

    model : a shipped model's name, or the path of a .urdf, .xacro, MJCF .xml, .sdf or .toml file
    packages : ROS package names and their folders, before those that are found around the file
    arguments : values for a xacro's arguments
    base, tip : links between which the arm is taken
    arm : in place of `tip`: a name of the arm, as `tip_of_arm` takes it

    Raises UsageError for a name that means nothing and a file that is not there.
    """
    if arm is not None and tip is not None:
        raise UsageError(f"arm {arm!r} and tip {tip!r} are both given; give one")
    entry = SHIPPED_MODELS.get(model) if isinstance(model, str) else None
    path = Path(model) if entry is None else entry.path()
    label = str(path) if entry is None else f"{entry.home}/{entry.file}"
    if not path.is_file():
        if path.exists():
            raise UsageError(f"{path} is no regular file; give a robot's description")
        raise UsageError(
            f"{path}: there is no such file, and no shipped model of this name; "
            f"{did_you_mean(path.stem, SHIPPED_MODELS)}"
        )
    known = known_packages(path, packages)
    try:
        data = read_regular(path)
    except OSError as error:
        raise UsageError(f"{path} cannot be read: {error.strerror}") from None
    here = _File(path, label, data, known)
    if entry is not None:  # as `load` does
        base = entry.base if base is None else base
        tip = entry.tip if tip is None and arm is None else tip
    reading = _read(here, arguments or {}, base, tip)
    if arm is not None and reading.robot is not None:
        tip = tip_of_arm(reading.robot, arm, base)
    reading = replace(reading, base=base, tip=tip)
    if entry is None or reading.robot is None:
        return reading
    return replace(reading, robot=replace(reading.robot, name=entry.name))


def load_robot(
    model: str | Path,
    *,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
) -> Robot:
    """Read a whole robot, with its branches: all links, joints and shapes of the file.

    Parameters
    ----------
    model : str or Path
        A shipped model's name, or the path of a file.  Bodies of an MJCF are links, under the link
        "world"; a DH table is a robot without branches.
    packages : mapping, optional
        Folders of ROS packages, by name.
    arguments : mapping, optional
        Values for a xacro's arguments.

    Returns
    -------
    robot : Robot

    Raises
    ------
    ModelError
        For the first error that reading finds; `judge` returns all of them.
    UsageError
        For a name that means nothing, or a file that is not there.

    Examples
    --------
    >>> import ur5check
    >>> tree = ur5check.RobotTree.of(ur5check.load_robot("erd-ur5"))
    >>> ur5check.gravity_torque(tree, [0.0] * 6).shape
    (6,)
    """
    if not isinstance(model, str | Path):
        raise UsageError(f"model must be a shipped model's name or a path, not {model!r:.80}")
    for name, mapping in (("packages", packages), ("arguments", arguments)):
        text_map(name, mapping)
    reading = read_robot(model, packages=packages, arguments=arguments)
    errors = [finding for finding in reading.findings if finding.severity == "error"]
    if errors or reading.robot is None:
        raise ModelError.of(errors[0])
    return reading.robot


def _read(
    here: _File, arguments: Mapping[str, str], base: str | None, tip: str | None
) -> RobotReading:
    form = format_by_suffix(here.path)
    if form is None:
        raise UsageError(f"{here.path} is no kind of file that a robot is read from")
    try:
        form = format_of_text(form, here.path, here.data, here.label)
    except ModelError as error:
        return here.nothing(error.finding)
    if form.kind == "xacro":
        return _xacro(here, arguments)
    if form.kind == "urdf":
        return _urdf(here, here.data, "urdf", here.inputs)
    if form.kind == "mjcf":
        return _mjcf(here, (base, tip))
    if form.kind == "sdf":
        return _sdf(here)
    for name, link in (("base", base), ("tip", tip)):
        if link is not None:
            raise UsageError(f"{name}= has no meaning for {form.noun}; leave it out")
    return _dh(here)


@dataclass(frozen=True, eq=False)
class _File:
    path: Path
    label: str
    data: bytes
    packages: PackageMap

    @property
    def inputs(self) -> tuple[tuple[str, str], ...]:
        return ((self.label, hashlib.sha256(self.data).hexdigest()),)

    def reading(self, robot: Robot | None, log: FindingLog) -> RobotReading:
        findings, folder = tuple(log.findings), self.path.parent
        inputs = self.inputs if robot is None else robot.inputs
        return RobotReading(self.label, robot, findings, self.packages, folder, inputs)

    def nothing(self, *findings: Finding) -> RobotReading:
        return RobotReading(
            self.label, None, findings, self.packages, self.path.parent, self.inputs
        )


def _urdf(
    file: _File,
    data: bytes,
    kind: str,
    inputs: tuple[tuple[str, str], ...],
    places: SourcePlaces | None = None,
) -> RobotReading:
    """places : where the text's elements were written, if it was made from other files"""
    from .urdf.urdf_reader import read_robot_of_urdf

    label = file.label if places is None else f"{file.label} (expanded)"
    robot, findings = read_robot_of_urdf(data, file=label, kind=kind, inputs=inputs, places=places)
    if robot is None:
        return file.nothing(*findings)
    return RobotReading(
        file.label,
        robot,
        findings,
        file.packages,
        file.path.parent,
        inputs,
    )


def _xacro(file: _File, arguments: Mapping[str, str]) -> RobotReading:
    from .xacro.xacro_reader import expand_xacro

    try:
        expansion = expand_xacro(
            file.path, arguments=arguments, packages=file.packages, label=file.label
        )
    except ModelError as error:
        return file.nothing(error.finding)
    text = expansion.text.encode()
    return _urdf(file, text, "xacro", expansion.inputs, expansion.places)


def _mjcf(file: _File, frames: tuple[str | None, ...]) -> RobotReading:
    from .mjcf.mjcf_robot import read_mjcf_robot

    log = FindingLog()
    named = [name for name in frames if name is not None]
    robot = read_mjcf_robot(file.data, file.label, file.path.parent, log, frames=named)
    return file.reading(robot, log)


def _sdf(file: _File) -> RobotReading:
    from .sdf.sdf_robot import read_sdf_robot

    log = FindingLog()
    return file.reading(read_sdf_robot(file.data, file.label, log), log)


def _dh(file: _File) -> RobotReading:
    from .dh.dh_reader import read_dh_robot

    log = FindingLog()
    robot, arm = read_dh_robot(file.data, file.label, log)
    return replace(file.reading(robot, log), arm=arm)
