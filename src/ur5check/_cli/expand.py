"""Expand a xacro to URDF, without ROS; optionally rewritten so that one engine imports
it correctly.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from .._errors import ModelError, UsageError
from .._io.formats import format_by_suffix
from .options import add_output_options, name_value_pairs, progress
from .output import check_output, emit

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = """\
examples:
  ur5check expand appendix -o ur5.urdf
  ur5check expand my_arm.urdf.xacro --package my_robot=. --for mujoco
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `expand` takes."""
    parser.add_argument(
        "file", metavar="FILE", help="a .xacro or .urdf file, or the name of a shipped model"
    )
    parser.add_argument(
        "--package",
        action="append",
        default=[],
        metavar="NAME=DIR",
        help="folder of a ROS package, for $(find NAME) and package://NAME; repeatable",
    )
    parser.add_argument(
        "--arg",
        action="append",
        default=[],
        metavar="NAME:=VALUE",
        help="value of a xacro argument; repeatable",
    )
    parser.add_argument(
        "--for",
        dest="reader",
        metavar="ENGINE",
        help="rewrite what this engine is known to misread: mujoco, drake, dart, gazebo, …",
    )
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Expand and print."""
    from .._io.package_search import known_packages
    from .._io.shipped_models import SHIPPED_MODELS
    from .._io.xacro.xacro_reader import expand_xacro
    from .input_files import input_files

    arguments = name_value_pairs(args.arg, "--arg", ":=")
    packages = name_value_pairs(args.package, "--package", "=")
    entry = SHIPPED_MODELS.get(args.file)
    path = entry.path() if entry else Path(args.file)
    form = None if entry else format_by_suffix(path)
    kind = entry.kind if entry else (form.kind if form else "")
    check_output(args.output, (path,))
    if kind == "urdf":
        text = _urdf(path, args.file, arguments)
        if args.reader is None:
            progress(args.quiet, f"{args.file} is a URDF: there is nothing to expand")
    elif kind == "xacro":
        known = known_packages(path, packages)
        expansion = expand_xacro(path, arguments=arguments, packages=known)
        for warning in expansion.warnings:
            progress(args.quiet, " ".join(f"xacro says: {warning}".split()))
        check_output(args.output, input_files(args.file, expansion.inputs, packages))
        text = expansion.text
    else:
        raise UsageError(_not_a_xacro(args.file, kind))
    if args.reader is not None:
        text = _rewritten(text, args, path, packages)
    emit(text if text.endswith("\n") else f"{text}\n", args.output)
    return 0


def _rewritten(text: str, args: argparse.Namespace, path: Path, packages: dict[str, str]) -> str:
    """The text repaired for the reader; reports what was changed, and for which known issue."""
    from .._engines.known_issues import repaired_text
    from .._engines.registry import READERS
    from .._io.meshes.mesh_paths import with_mesh_paths
    from .._io.package_search import known_packages
    from .._io.urdf.urdf_reader import read_robot_of_urdf

    _, findings = read_robot_of_urdf(text.encode(), file=args.file)
    for finding in findings:
        if finding.severity == "error":
            raise ModelError.of(finding)
    text, repaired = repaired_text(text, args.reader)
    for known_issue in repaired:
        progress(
            args.quiet, f"rewritten for {args.reader}, where {known_issue.title} ({known_issue.id})"
        )
    if not READERS[args.reader].finds_packages:  # it stops at a mesh that it does not find
        text, lost = with_mesh_paths(text, known_packages(path, packages), path.parent)
        for sentence in lost:
            progress(args.quiet, sentence)
    return text


def _urdf(path: Path, name: str, arguments: dict[str, str]) -> str:
    from .._io.xml.xml_tree import checked_xml

    if arguments:
        raise UsageError(f"--arg has no meaning for {name}: it is a URDF, not a xacro")
    try:
        data = path.read_bytes()
    except OSError as error:
        raise UsageError(f"{name}: cannot be read: {error.strerror}; check the path") from None
    return checked_xml(data, name).decode()


def _not_a_xacro(name: str, kind: str) -> str:
    from .._io.shipped_models import SHIPPED_MODELS
    from .._io.suggestions import did_you_mean

    if kind == "dh":
        return (
            f"{name} is a DH table: there is no xacro in it to expand; see `ur5check show {name}`"
        )
    known = did_you_mean(name, SHIPPED_MODELS)
    return f"{name} is no xacro and no model's name; give a .xacro file ({known})"
