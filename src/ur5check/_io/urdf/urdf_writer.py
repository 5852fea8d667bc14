"""A `SerialArm` as a URDF that strict readers take, and that reads back as the same arm.

Each link's numbers stand in the frame at its joint, as in any URDF.  Shapes are left out.

What URDF cannot say, or must say although it is unknown:

- gravity: a comment names it where it is not (0, 0, −9.81) in the base frame;
- position limits of a revolute joint, both unknown: the joint is written `continuous`;
- any other number that `<limit>` demands and is unknown: the largest double stands there, which
  is how Pinocchio writes "no limit".  No limit is invented; a comment says where this was done.
"""

from __future__ import annotations

import sys
from xml.sax.saxutils import quoteattr

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.serial_arm import STANDARD_GRAVITY, Joint, SerialArm
from ..file_comments import came_from, xml_comment
from ..number_text import exact, triple
from ..round_trip import Pose, round_trip_inertia, rpy_pose
from ..unique_names import unique_names

__all__ = ["NO_LIMIT", "not_said", "urdf_of"]

#: Where a number is demanded and not known: the largest double.
NO_LIMIT = sys.float_info.max


def urdf_of(arm: SerialArm) -> str:
    """The text of a URDF that describes this arm.

    Base and tip links, joints and links carry the arm's names, made unique where two are alike.
    An inertia that no body has is written as it is; strict readers will refuse it, as they should.
    """
    joints = unique_names(arm.joint_names, "joint")
    # URDF lets a link and a joint share a name; Pinocchio then has two frames of that name.
    names = unique_names([arm.source.base, *(link.name for link in arm.links)], "link", joints)
    lines = ['<?xml version="1.0" encoding="utf-8"?>']
    lines += [f"<!-- {xml_comment(line)} -->" for line in [*came_from(arm), *not_said(arm)]]
    lines += [
        f"<robot name={quoteattr(arm.name.strip() or 'arm')}>",
        f"  <link{_named(names[0])}/>",
    ]
    starts = [rpy_pose(T) for T in (arm.base, *(link.link_tip_frame for link in arm.links))]
    for i, (joint, link) in enumerate(zip(arm.joints, arm.links, strict=True)):
        lines += _joint_lines(joint, joints[i], names[i], names[i + 1], starts[i])
        lines += _link_lines(round_trip_inertia(link, starts[i + 1].read), names[i + 1])
    lines += _tip_lines(arm, names, joints, starts[-1])
    return "\n".join([*lines, "</robot>", ""])


def not_said(arm: SerialArm) -> list[str]:
    """What URDF cannot carry, or must say although it is unknown, one line each."""
    lines = []
    if not np.array_equal(arm.gravity, STANDARD_GRAVITY):
        lines.append(
            f"URDF cannot carry gravity: this arm's is ({triple(arm.gravity)}) m/s² in the frame "
            f"of {arm.source.base!r}; give it to whatever reads this file."
        )
    if arm.armature.any():
        lines.append(
            f"URDF cannot carry motor inertia: this arm's joints have "
            f"{', '.join(f'{value:g}' for value in arm.armature)} kg m²."
        )
    unknown = [
        f"{joint.name} {', '.join(missing)}"
        for joint in arm.joints
        if (missing := [key for key, value in _limits(joint).items() if value is None])
    ]
    if unknown:
        lines.append(
            f"Not known, and written as {exact(NO_LIMIT)}, which means no limit: "
            f"{'; '.join(unknown)}."
        )
    return lines


def _limits(joint: Joint) -> dict[str, float | None]:
    """The attributes that this joint's `<limit>` needs; none where it needs no `<limit>`."""
    limits = joint.limits
    effort_and_rate = {"effort": limits.effort, "velocity": limits.velocity}
    if _kind(joint) == "continuous":
        return effort_and_rate if any(v is not None for v in effort_and_rate.values()) else {}
    return {"lower": limits.lower, "upper": limits.upper, **effort_and_rate}


def _kind(joint: Joint) -> str:
    if joint.kind == "prismatic":
        return "prismatic"
    bounded = joint.limits.lower is not None or joint.limits.upper is not None
    return "revolute" if bounded else "continuous"


def _joint_lines(joint: Joint, name: str, parent: str, child: str, placement: Pose) -> list[str]:
    lines = [
        f'  <joint{_named(name)} type="{_kind(joint)}">',
        f"    <parent link={quoteattr(parent)}/>",
        f"    <child link={quoteattr(child)}/>",
        f"    {_origin(placement)}",
        f'    <axis xyz="{triple(joint.axis)}"/>',
    ]
    limits = _limits(joint)
    if limits:
        unknown = {"lower": -NO_LIMIT}
        written = " ".join(
            f'{key}="{exact(unknown.get(key, NO_LIMIT) if value is None else value)}"'
            for key, value in limits.items()
        )
        lines.append(f"    <limit {written}/>")
    if joint.damping or joint.friction:
        losses = f'damping="{exact(joint.damping)}" friction="{exact(joint.friction)}"'
        lines.append(f"    <dynamics {losses}/>")
    return [*lines, "  </joint>"]


def _link_lines(here: Inertia, name: str) -> list[str]:
    entries = " ".join(
        f'i{a}{b}="{exact(here.tensor["xyz".index(a), "xyz".index(b)])}"'
        for a, b in ("xx", "xy", "xz", "yy", "yz", "zz")
    )
    return [
        f"  <link{_named(name)}>",
        "    <inertial>",
        f'      <origin xyz="{triple(here.com)}" rpy="0 0 0"/>',
        f'      <mass value="{exact(here.mass)}"/>',
        f"      <inertia {entries}/>",
        "    </inertial>",
        "  </link>",
    ]


def _tip_lines(arm: SerialArm, names: list[str], joints: list[str], placement: Pose) -> list[str]:
    """The tool frame on a fixed joint; nothing where the last link's own frame is the tool's."""
    last, tip = names[-1], arm.source.tip
    if tip == arm.links[-1].name:
        if np.array_equal(placement.read.matrix(), np.eye(4)):
            return []
        tip = "tool"
    (tip,) = unique_names([tip], "link", [*names, *joints])
    (fixed,) = unique_names([f"{tip}_fixed_joint"], "joint", [*names, *joints, tip])
    return [
        f'  <joint{_named(fixed)} type="fixed">',
        f"    <parent link={quoteattr(last)}/>",
        f"    <child link={quoteattr(tip)}/>",
        f"    {_origin(placement)}",
        "  </joint>",
        f"  <link{_named(tip)}/>",
    ]


def _origin(pose: Pose) -> str:
    return f'<origin xyz="{triple(pose.xyz)}" rpy="{triple(pose.turn)}"/>'


def _named(name: str) -> str:
    return f" name={quoteattr(name)}"
