"""One arm as plain values for JSON.  Every field is documented in docs/json.md."""

from __future__ import annotations

from .._robot.serial_arm import SerialArm
from .json_head import json_head
from .json_values import Report, inertia_value, joint_value, model_value, strict

__all__ = ["show_json"]


def show_json(arm: SerialArm, *, command: str = "") -> Report:
    """`show` as ur5check.robot/1."""
    return strict(
        {
            **json_head("arm", [arm], command),
            **model_value(arm),
            "gravity": arm.gravity,
            "base_transform": arm.base.matrix(),
            "joints": [joint_value(joint) for joint in arm.joints],
            "links": [
                {
                    "name": link.name,
                    "link_tip_frame": link.link_tip_frame.matrix(),
                    "source_frame": link.source_frame.matrix(),
                    "inertia": inertia_value(link.inertia),
                }
                for link in arm.links
            ],
        }
    )
