"""Pieces of the JSON reports, and what makes JSON strict: no nan and no infinity, null instead."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from .._comparison.alignment import Alignment
from .._robot.inertia import Inertia
from .._robot.serial_arm import Joint, SerialArm

__all__ = [
    "Report",
    "alignment_value",
    "inertia_value",
    "joint_value",
    "json_text",
    "model_value",
    "strict",
]

Report = dict[str, Any]


def json_text(report: Report) -> str:
    """The report as strict JSON."""
    return json.dumps(report, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def strict(report: Report) -> Report:
    """The report in what JSON has: lists, Python's own numbers, None for what is no number."""
    return {key: _plain(value) for key, value in report.items()}


def model_value(arm: SerialArm) -> Report:
    """What an arm is called, and where it came from."""
    source = arm.source
    return {
        "name": arm.name,
        "label": arm.label,
        "kind": source.kind,
        "base": source.base,
        "tip": source.tip,
        "notes": source.notes,
    }


def joint_value(joint: Joint) -> Report:
    """A joint with its limits."""
    limits = joint.limits
    return {
        "name": joint.name,
        "kind": joint.kind,
        "axis": joint.axis,
        "limits": {
            "lower": limits.lower,
            "upper": limits.upper,
            "velocity": limits.velocity,
            "effort": limits.effort,
        },
    }


def alignment_value(alignment: Alignment) -> Report:
    """How b was laid along a."""
    return {
        "exact": alignment.exact,
        "T_ab": alignment.T_ab.matrix(),
        "signs": alignment.signs,
        "offsets": alignment.offsets,
        "axis_angle": alignment.axis_angle,
        "axis_distance": alignment.axis_distance,
        "tool": alignment.tool.matrix(),
        "unknown": alignment.unknown,
        "notes": alignment.notes,
    }


def inertia_value(inertia: Inertia) -> Report:
    """Mass, centre and tensor about the centre."""
    return {"mass": inertia.mass, "com": inertia.com, "tensor": inertia.tensor}


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return strict(value)
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, np.ndarray | np.generic):
        return _plain(value.tolist())
    if isinstance(value, float):
        # Adding 0.0 turns −0.0, which readers stumble over, into 0.0.
        return value + 0.0 if math.isfinite(value) else None
    return value
