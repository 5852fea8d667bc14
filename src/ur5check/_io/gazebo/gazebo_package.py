"""The ROS packages that simulate an arm in Gazebo, as files in memory.

They do what the paper's launch file did, for ROS 1 and ROS 2: an empty world, the arm
spawned at a height, an effort controller a joint under /ur, joint states, transforms; and a node
that publishes a computed torque.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal
from xml.sax.saxutils import escape

from ..._dynamics.equations import gravity_torque
from ..._robot import SerialArm
from ..._robot.transforms import Array
from ..._version import __version__
from ..number_text import triple
from ..ros_packages import PackageMap
from ..urdf.urdf_reader import read_urdf
from ..urdf.urdf_writer import urdf_of
from .gazebo_model import GazeboModel, gazebo_model
from .joint_lines import NAMESPACE, joint_blanks, yaml_list
from .package_templates import comment_body, fill, names_under
from .start_posture import start_angles

__all__ = ["GazeboPackages", "Ros", "gazebo_packages"]

Ros = Literal["1", "2"]
_DISTRIBUTIONS = {
    "1": "ROS 1 Noetic with Gazebo 11",
    "2": "ROS 2 Jazzy or newer with its Gazebo",
}


@dataclass(frozen=True, eq=False)
class GazeboPackages:
    """files : content by path;  programs : those of them that are run
    start : initial joint positions, length n [rad] or [m]
    tau : torque that holds them there, shape (n,) [N m] or [N]
    notes : changes to the model, in sentences
    """

    files: dict[str, bytes]
    programs: frozenset[str]
    start: tuple[float, ...]
    tau: Array
    notes: tuple[str, ...]


def gazebo_packages(
    arm: SerialArm,
    pose: Sequence[float],
    *,
    ros: Iterable[Ros],
    packages: PackageMap,
    file: str,
    licence: str = "that of the model",
    command: str = "",
) -> GazeboPackages:
    """Packages for an arm that starts in a pose, and for the torque that holds it there.

    pose : joint positions, length n [rad] or [m];  ros : which ROS
    packages : where the model's meshes are found;  file : the model's own file
    licence : of the model;  command : what makes these files again

    Raises UsageError for a pose that the arm cannot hold, ModelError for a model that Gazebo would
    misread.
    """
    start = start_angles(arm.joints, pose)
    described = _as_urdf(arm, file)
    tau = gravity_torque(described, start)
    name = _ros_name(arm.name)
    model = gazebo_model(described, package=f"{name}_gazebo", packages=packages, file=file)
    notes = (*_turned(arm, pose, start), *_unsaid(arm), *model.notes)
    blanks = {
        **_blanks(described, name, model),
        **joint_blanks(described.joint_names, start, tau.tolist()),
        "model": escape(arm.name),
        "licence": escape(f"BSD-2-Clause; the model: {licence}"),
    }
    provenance = _provenance(arm, command)
    files: dict[str, bytes] = {}
    for one in (chosen := sorted(ros, reverse=True)):
        package = _package(f"ros{one}", name, model, blanks, provenance)
        files |= {f"ros{one}/{name}_gazebo/{path}": data for path, data in package.items()}
    files["README.md"] = _readme(chosen, blanks, notes, provenance).encode()
    programs = frozenset(path for path in files if "/scripts/" in path)
    return GazeboPackages(files, programs, start, tau, notes)


def _blanks(described: SerialArm, name: str, model: GazeboModel) -> dict[str, str]:
    """Blanks that occur once in a package: names, frames, gravity."""
    folders = ["config", "launch", *(["meshes"] if model.meshes else []), "urdf", "worlds"]
    return {
        "version": __version__,
        "package": f"{name}_gazebo",
        "stem": name,
        "namespace": NAMESPACE,
        "n": str(described.n),
        "base": json.dumps(described.source.base),
        "tip": json.dumps(described.source.tip),
        "gravity": yaml_list(described.gravity.tolist()),
        "world_gravity": triple(model.gravity),
        "folders": " ".join(folders),
        "ground_and_sun": fill("common/ground_and_sun.xml", {}).rstrip("\n"),
    }


def _readme(
    ros: Sequence[Ros], blanks: dict[str, str], notes: Iterable[str], provenance: Sequence[str]
) -> str:
    own = {
        "distributions": " and for ".join(_DISTRIBUTIONS[one] for one in ros),
        "how_to": "".join(fill(f"common/how_to_ros{one}.md", blanks) for one in ros),
        "notes": "".join(f"\n- {note}" for note in notes),
    }
    return fill("common/README.md", blanks | own, provenance)


def _as_urdf(arm: SerialArm, file: str) -> SerialArm:
    """The arm as a URDF describes it: its own, or one that is written for it."""
    if arm.source.urdf is not None:
        return arm
    read = read_urdf(urdf_of(arm).encode("utf-8"), file=f"{file} as a URDF")
    return replace(read, gravity=arm.gravity)


def _package(
    ros: str, name: str, model: GazeboModel, blanks: dict[str, str], provenance: Sequence[str]
) -> dict[str, bytes]:
    """The files of one package."""
    files = {path: fill(f"{ros}/{path}", blanks, provenance) for path in names_under(ros)}
    script = "gravity_torque.py"
    files[f"scripts/{script}"] = fill(f"common/{script}", blanks, provenance)
    for variant, text in ((name, model.urdf), (f"{name}_limited", model.limited)):
        header = comment_body(".urdf", provenance)
        files[f"urdf/{variant}.urdf"] = (
            f'<?xml version="1.0" encoding="utf-8"?>\n<!-- {header} -->\n{text}\n'
        )
    meshes = {path: source.read_bytes() for path, source in model.meshes.items()}
    return {path: text.encode() for path, text in files.items()} | meshes


def _provenance(arm: SerialArm, command: str) -> list[str]:
    lines = [f"Written by ur5check {__version__} from the model {arm.name}."]
    lines += [f"Read: {name} (SHA-256 {digest})" for name, digest in arm.source.inputs]
    return lines + ([f"Command: {command}"] if command else [])


def _turned(arm: SerialArm, pose: Sequence[float], start: Sequence[float]) -> list[str]:
    return [
        f"Joint {joint.name!r} starts at {at:.6g} rad, whole turns from the {q:.6g} rad asked for: "
        "the same posture, which the limited model can hold too."
        for joint, q, at in zip(arm.joints, pose, start, strict=True)
        if at != q
    ]


def _unsaid(arm: SerialArm) -> list[str]:
    if not arm.armature.any():
        return []
    return [
        "Motor inertia is left out: URDF cannot carry it, so the arm is too light to turn here."
    ]


def _ros_name(name: str) -> str:
    """A model's name as ROS allows names: lower case, digits and single underscores (REP 144)."""
    plain = re.sub(r"[^a-z0-9]+", "_", Path(name).stem.lower()).strip("_")
    return plain if re.match("[a-z]", plain) else f"arm_{plain}".rstrip("_")
