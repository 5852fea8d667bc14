"""A `SerialArm` as a MuJoCo model (MJCF) that reads back as the same arm.

Every link is a body with its frame at its joint, its inertial in that frame; the tool is a body
without mass.  Shapes are omitted. MuJoCo refuses a moving body without mass: a massless link's
joint is written into the body that follows, where MuJoCo turns about one joint after the other.

MJCF has no velocity limits of joints; a comment states them.  A position limit that is known
on one side only has the largest double on the other, which means no limit.
"""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

import numpy as np

from ..._errors import UsageError
from ..._robot.serial_arm import Joint, Link, SerialArm
from ..._robot.transforms import Array, Transform
from ..file_comments import came_from, xml_comment
from ..number_text import as_written, exact, triple
from ..round_trip import Pose, quaternion_pose, round_trip_inertia
from ..unique_names import unique_names
from ..urdf.urdf_writer import NO_LIMIT

__all__ = ["mjcf_of", "not_said"]

_WORLD = "world"
_NOTHING_ELSE = (
    # Degrees are MJCF's default; bodies must not be merged or changed.
    '<compiler angle="radian" autolimits="true" fusestatic="false" balanceinertia="false"/>'
)
_MOVED = 8 * float(np.finfo(np.float64).eps)


def mjcf_of(arm: SerialArm) -> str:
    """The text of an MJCF file that describes this arm.

    Base, links and tool are bodies with the arm's names, made unique where two are alike.  An
    inertia that no body can have is written unchanged; MuJoCo will refuse it.

    Raises UsageError for an arm whose last link has no mass, which MJCF cannot describe.
    """
    if arm.links[-1].inertia.mass == 0.0:
        raise UsageError(f"{arm.name!r}: the last link has no mass, and MuJoCo refuses such a body")
    joints = unique_names(arm.joint_names, "joint")
    base, *names = unique_names(
        [arm.source.base, *(link.name for link in arm.links)], "link", [_WORLD]
    )
    lines = ['<?xml version="1.0" encoding="utf-8"?>']
    lines += [f"<!-- {xml_comment(line)} -->" for line in [*came_from(arm), *not_said(arm)]]
    lines += [
        f"<mujoco model={quoteattr(arm.name.strip() or 'arm')}>",
        f"  {_NOTHING_ELSE}",
        f'  <option gravity="{triple(arm.gravity)}"/>',
        "  <worldbody>",
        f"    <body name={quoteattr(base)}>",
    ]
    depth = 3
    start, waiting = arm.base, list[int]()
    for i, link in enumerate(arm.links):
        waiting.append(i)
        if link.inertia.mass == 0.0:
            continue
        pose, moved = _start_and_joints(arm, start, waiting, joints)
        body = f"<body name={quoteattr(names[i])}{_placed(pose)}>"
        read_link_tip_frame = quaternion_pose(link.link_tip_frame).read
        lines += _indented(depth, [body, f"  {_inertial(link, read_link_tip_frame)}", *moved])
        depth, start, waiting = depth + 1, link.link_tip_frame, []
    lines += _indented(depth, _tip(arm, [_WORLD, base, *names], quaternion_pose(start)))
    lines += [line for level in range(depth - 1, 1, -1) for line in _indented(level, ["</body>"])]
    return "\n".join([*lines, "  </worldbody>", "</mujoco>", ""])


def not_said(arm: SerialArm) -> list[str]:
    """What MJCF cannot carry, one line each."""
    rates = [
        f"{joint.name} {joint.limits.velocity:g}"
        for joint in arm.joints
        if joint.limits.velocity is not None
    ]
    return [f"MJCF cannot carry velocity limits: {', '.join(rates)} rad/s or m/s."] if rates else []


def _start_and_joints(
    arm: SerialArm, start: Transform, members: list[int], names: list[str]
) -> tuple[Pose, list[str]]:
    """Pose of the body that the joints `members` move, and their elements.

    The body's frame is where its last joint is, at q = 0; the joints of massless links before it
    are seen from there.
    """
    *before, last = members
    to_body = Transform.identity()
    elements = [_joint(arm.joints[last], names[last], arm.joints[last].axis, np.zeros(3))]
    for i in reversed(before):
        to_body = arm.links[i].link_tip_frame @ to_body
        seen = to_body.inverse()
        axis = seen.R @ arm.joints[i].axis
        elements.insert(0, _joint(arm.joints[i], names[i], axis, seen.p))
    return quaternion_pose(_shortened(start @ to_body) if before else start), elements


def _shortened(T: Transform) -> Transform:
    error = _MOVED * max(1.0, float(np.abs(T.p).max()))
    return Transform(T.R, np.array([as_written(float(x), error) for x in T.p]))


def _joint(joint: Joint, name: str, axis: Array, anchor: Array) -> str:
    limits = joint.limits
    words = [
        f"name={quoteattr(name)}",
        f'type="{"slide" if joint.kind == "prismatic" else "hinge"}"',
    ]
    words += [f'pos="{triple(anchor)}"'] if anchor.any() else []
    words.append(f'axis="{triple(axis)}"')
    if limits.lower is not None or limits.upper is not None:
        lower = -NO_LIMIT if limits.lower is None else limits.lower
        upper = NO_LIMIT if limits.upper is None else limits.upper
        words.append(f'range="{triple((lower, upper))}"')
    if (effort := limits.known_effort) is not None:
        words.append(f'actuatorfrcrange="{triple((-effort, effort))}"')
    losses = {
        "armature": joint.armature,
        "damping": joint.damping,
        "frictionloss": joint.friction,
    }
    words += [f'{key}="{exact(value)}"' for key, value in losses.items() if value]
    return f"  <joint {' '.join(words)}/>"


def _inertial(link: Link, read_link_tip_frame: Transform) -> str:
    here = round_trip_inertia(link, read_link_tip_frame)
    entries = [here.tensor[i] for i in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    key, values = ("fullinertia", entries) if any(entries[3:]) else ("diaginertia", entries[:3])
    return (
        f'<inertial pos="{triple(here.com)}" mass="{exact(here.mass)}" {key}="{triple(values)}"/>'
    )


def _tip(arm: SerialArm, taken: list[str], pose: Pose) -> list[str]:
    """The tool frame; nothing where the last link's own frame is the tool's."""
    tip = arm.source.tip
    if tip == arm.links[-1].name:
        if np.array_equal(pose.read.matrix(), np.eye(4)):
            return []
        tip = "tool"
    (tip,) = unique_names([tip], "link", taken)
    return [f"<body name={quoteattr(tip)}{_placed(pose)}/>"]


def _placed(pose: Pose) -> str:
    """Attributes of a pose; none for the identity, MJCF's default."""
    words = f' pos="{triple(pose.xyz)}"' if any(pose.xyz) else ""
    turned = any(pose.turn[1:])
    return words + (f' quat="{triple(pose.turn)}"' if turned else "")


def _indented(depth: int, lines: list[str]) -> list[str]:
    return [f"{'  ' * depth}{line}" for line in lines]
