"""Write an arm as ROS packages that simulate it in Gazebo, driven by joint torques."""

from __future__ import annotations

import argparse
import shlex
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import UsageError
from .options import MODELS, ModelOptions, add_model_options, progress

if TYPE_CHECKING:
    from .._io.gazebo.gazebo_package import GazeboPackages, Ros
    from .._robot.transforms import Array

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = f"""\
{MODELS}

examples:
  ur5check export gazebo ur5_in_gazebo
  ur5check export gazebo pendulum --model pendulum.urdf --pose 0.5
"""

_ROS: dict[str, tuple[Ros, ...]] = {"1": ("1",), "2": ("2",), "both": ("1", "2")}


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `export` takes."""
    parser.add_argument("to", choices=("gazebo",), metavar="gazebo", help="simulator to export to")
    parser.add_argument(
        "folder", metavar="DIR", help="new or empty folder that the packages are written to"
    )
    parser.add_argument("--model", default="appendix", help="model to export (default: appendix)")
    parser.add_argument(
        "--ros",
        choices=tuple(_ROS),
        default="both",
        help="ROS version of the packages (default: both)",
    )
    parser.add_argument(
        "--pose",
        type=float,
        nargs="+",
        metavar="Q",
        help="initial configuration, which the torques hold [rad, m] (default for six joints: "
        "case 9 of the paper)",
    )
    add_model_options(parser, ("",))
    parser.add_argument("--quiet", action="store_true", help="show no progress on stderr")


def run(args: argparse.Namespace) -> int:
    """Write the packages; print their folder and the torque that they publish."""
    from .._io.gazebo.gazebo_package import gazebo_packages
    from .._io.gazebo.package_folder import check_folder, write_folder
    from .._io.package_search import known_packages
    from .._io.shipped_models import SHIPPED_MODELS
    from .._paper.cases import case
    from .output import emit

    check_folder(args.folder)
    options = ModelOptions.of(args, (args.model,))
    (arm,) = options.load(quiet=args.quiet)
    if args.pose is None:
        args.pose = _case_9(case(9).joint_angles(), args.model, arm.n)
    entry = SHIPPED_MODELS.get(args.model)
    file = entry.path() if entry else Path(args.model)
    packages = gazebo_packages(
        arm,
        args.pose,
        ros=_ROS[args.ros],
        packages=known_packages(file, options.packages),
        file=str(file),
        licence=entry.licence if entry else "that of its own file",
        command=_command(args),
    )
    write_folder(args.folder, packages.files, packages.programs)
    emit(_said(args.folder, arm.joint_names, packages), None)
    for note in packages.notes:
        progress(args.quiet, note)
    return 0


def _case_9(angles: Array, model: str, n: int) -> list[float]:
    """The posture whose torque the paper sends to Gazebo; only an arm of six joints can take it."""
    if n != angles.size:
        raise UsageError(
            f"{model} has {n} joints, the paper's case 9 has {angles.size}; give --pose Q1 … Q{n}"
        )
    return [float(q) for q in angles.ravel()]


def _said(folder: str, names: tuple[str, ...], packages: GazeboPackages) -> str:
    """The next step for the user: folder, README, and the published torques."""
    width = max(map(len, names))
    lines = [f"{folder}: {len(packages.files)} files; {folder}/README.md says how to run them"]
    lines += [
        f"{'joint':{width}}  {'start':>9}  {'torque':>9}",
        f"{'':{width}}  {'rad, m':>9}  N m, N",
    ]
    lines += [
        f"{name:{width}}  {q:9.4f}  {round(tau, 4) + 0.0:9.4f}"
        for name, q, tau in zip(names, packages.start, map(float, packages.tau), strict=True)
    ]
    return "\n".join([*lines, ""])


def _command(args: argparse.Namespace) -> str:
    """The command that writes these files again."""
    words = ["ur5check", "export", args.to, args.folder, "--model", args.model, "--ros", args.ros]
    words += ["--pose", *map(repr, args.pose)]
    for option in ("base", "tip"):
        value = getattr(args, option)
        words += [] if value is None else [f"--{option}", value]
    for option in ("package", "arg"):
        for text in getattr(args, option):
            words += [f"--{option}", text]
    return shlex.join(words)
