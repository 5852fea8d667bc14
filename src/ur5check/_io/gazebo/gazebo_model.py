"""A URDF rewritten for Gazebo, and the same with limited joints.

What Gazebo would do with the unchanged file, and the change:

- its base would fall over: the root is fixed to a link named `world`, which Gazebo knows;
- joints outside the arm would swing: they are fixed where ur5check holds them still;
- a base without mass would be dropped with the whole arm: it is given a mass, which has no effect;
- "no limit", written as the largest double, would be out of range: it is written as SDFormat does;
- two control plugins would conflict: transmissions and control plugins are omitted, the package has
its own;
- a moving link without mass would be dropped, and all that hangs on it: it is refused.

Fixed joints stay: Gazebo's reader lumps them into the link above, as ur5check does.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from pathlib import Path

from lxml import etree

from ..._engines.known_issues import known_issues_of
from ..._errors import ModelError
from ..._robot import SerialArm
from ..._robot.transforms import Array
from ..ros_packages import PackageMap
from ..urdf.urdf_reader import description_of_arm
from ..xml.safe_xml import parsed_xml
from ..xml.xml_numbers import Element
from .package_meshes import take_meshes
from .urdf_edits import (
    hold_still,
    leave_out_control,
    limit_turns,
)

__all__ = ["GazeboModel", "gazebo_model"]


@dataclass(frozen=True, eq=False)
class GazeboModel:
    """urdf, limited : `<robot>` elements as text, without a header
    meshes : files to copy, by their path inside the package
    gravity : of the arm, in the world's frame, shape (3,) [m/s²]
    notes : the changes, in sentences
    """

    urdf: str
    limited: str
    meshes: dict[str, Path]
    gravity: Array
    notes: tuple[str, ...]


def gazebo_model(arm: SerialArm, *, package: str, packages: PackageMap, file: str) -> GazeboModel:
    """The model of an arm that came from a URDF's text.

    package : name of the ROS package that will hold it;  packages : where its meshes are found
    file : name of the text in errors; relative mesh names are seen from its folder

    Raises ModelError for a moving link without mass.
    """
    assert arm.source.urdf is not None  # noqa: S101 - the caller's error, not the user's
    root = parsed_xml(arm.source.urdf)
    description, _ = description_of_arm(arm, file)
    chain = description.chain(arm.source.base, arm.source.tip)
    _refuse_massless(arm, file)
    notes = [*leave_out_control(root), *hold_still(root, description, chain)]
    for known_issue in known_issues_of("gazebo"):
        if known_issue.applied(root):
            notes.append(f"Gazebo: {known_issue.title}; {known_issue.fix}.")
    meshes, unread = take_meshes(root, package=package, packages=packages, folder=Path(file).parent)
    limited = copy.deepcopy(root)
    limit_turns(limited, chain)
    R_world_base = description.root_to(chain.base).R
    return GazeboModel(
        _text(root), _text(limited), meshes, R_world_base @ arm.gravity, (*notes, *unread)
    )


def _refuse_massless(arm: SerialArm, file: str) -> None:
    for link in arm.links:
        if link.inertia.mass == 0.0:
            raise ModelError(
                "moves and has mass zero: Gazebo drops such a link and all that hangs on it",
                fix="give it a small mass and inertia",
                file=file,
                element=f"link {link.name!r}",
            )


def _text(root: Element) -> str:
    tidy = copy.deepcopy(root)
    etree.cleanup_namespaces(tidy)
    etree.indent(tidy)
    return str(etree.tostring(tidy, encoding="unicode", with_tail=False))
