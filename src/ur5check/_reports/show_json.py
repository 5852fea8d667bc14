"""`ur5check show` as JSON."""

from __future__ import annotations

from typing import Literal

import msgspec

from .._robot.serial_arm import SerialArm
from .json_report import Report, head
from .json_values import (
    InertiaValue,
    Model,
    Number,
    Pose,
    Vector3,
    inertia_value,
    model_value,
    pose,
    vector,
)

__all__ = ["ShowReport", "show_json"]


class LimitsValue(msgspec.Struct, frozen=True):
    """Limits as the source gives them: position [rad or m], velocity [per s], effort [N m or N]."""

    lower: Number
    upper: Number
    velocity: Number
    effort: Number


class JointValue(msgspec.Struct, frozen=True):
    """A joint: its kind, unit axis and limits."""

    name: str
    kind: Literal["revolute", "prismatic"]
    axis: Vector3
    limits: LimitsValue


class LinkValue(msgspec.Struct, frozen=True):
    """A link: its frames and its inertia."""

    name: str
    link_tip_frame: Pose
    source_frame: Pose
    inertia: InertiaValue


class ShowReport(Report, frozen=True, kw_only=True, tag="ur5check.show/2"):
    """One model, as it was read."""

    model: Model
    gravity: Vector3
    base_transform: Pose
    joints: list[JointValue]
    links: list[LinkValue]


def show_json(arm: SerialArm, *, command: str = "") -> ShowReport:
    """The report of `ur5check show`."""
    return ShowReport(
        **head([arm], command),
        model=model_value(arm),
        gravity=vector(arm.gravity),
        base_transform=pose(arm.base),
        joints=[
            JointValue(
                joint.name,
                joint.kind,
                vector(joint.axis),
                LimitsValue(
                    joint.limits.lower,
                    joint.limits.upper,
                    joint.limits.velocity,
                    joint.limits.effort,
                ),
            )
            for joint in arm.joints
        ],
        links=[
            LinkValue(
                link.name,
                pose(link.link_tip_frame),
                pose(link.source_frame),
                inertia_value(link.inertia, link.tensor_known),
            )
            for link in arm.links
        ],
    )
