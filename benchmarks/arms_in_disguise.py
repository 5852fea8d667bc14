"""Arms whose axes coincide in several ways, and the same arms in other coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ur5check import Inertia, Joint, Link, SerialArm, Transform
from ur5check._robot.transforms import Array

__all__ = ["FAMILIES", "family", "heavier", "in_other_coordinates", "with_tool"]

_X, _Y, _Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
_WRIST = [("R", _Z, (0.0, 0.0, 0.0)), ("R", _Y, (0.0, 0.0, 0.0)), ("R", _Z, (0.0, 0.0, 0.1))]

#: Joint by joint: kind, axis, and the vector to the next joint, all at q = 0 in the base frame.
FAMILIES: dict[str, list[tuple[str, Sequence[float], Sequence[float]]]] = {
    "S-R-S arm, 7 joints": [
        ("R", _Z, (0.0, 0.0, 0.3)),
        ("R", _Y, (0.0, 0.0, 0.0)),
        ("R", _Z, (0.0, 0.0, 0.4)),
        ("R", _Y, (0.0, 0.0, 0.4)),
        *_WRIST,
    ],
    "6 joints, spherical wrist": [
        ("R", _Z, (0.0, 0.15, 0.6)),
        ("R", _Y, (0.43, 0.0, 0.0)),
        ("R", _Y, (0.02, 0.0, 0.43)),
        *_WRIST,
    ],
    "Stanford": [
        ("R", _Z, (0.0, 0.15, 0.4)),
        ("R", _Y, (0.0, 0.0, 0.5)),
        ("P", _Z, (0.0, 0.0, 0.0)),
        *_WRIST,
    ],
    "SCARA": [
        ("R", _Z, (0.4, 0.0, 0.2)),
        ("R", _Z, (0.3, 0.0, 0.0)),
        ("P", _Z, (0.0, 0.0, -0.2)),
        ("R", _Z, (0.0, 0.0, -0.1)),
    ],
    "SCARA, slide last": [
        ("R", _Z, (0.4, 0.0, 0.2)),
        ("R", _Z, (0.3, 0.0, 0.0)),
        ("R", _Z, (0.0, 0.0, -0.1)),
        ("P", _Z, (0.05, 0.0, -0.1)),
    ],
    "gantry and wrist": [
        ("P", _X, (0.0, 0.0, 0.1)),
        ("P", _Y, (0.1, 0.0, 0.0)),
        ("P", _Z, (0.0, 0.0, -0.2)),
        *_WRIST,
    ],
    "UR": [
        ("R", _Z, (0.0, 0.136, 0.089)),
        ("R", _Y, (0.425, -0.12, 0.0)),
        ("R", _Y, (0.392, 0.0, 0.0)),
        ("R", _Y, (0.0, 0.093, 0.0)),
        ("R", _Z, (0.0, 0.0, -0.095)),
        ("R", _Y, (0.0, 0.082, 0.0)),
    ],
    "planar": [("R", _Y, (0.3, 0.0, 0.0)), ("R", _Y, (0.3, 0.1, 0.0)), ("R", _Y, (0.2, 0.0, 0.0))],
    "slide along the forearm": [
        ("R", _Z, (0.0, 0.1, 0.3)),
        ("R", _Y, (0.3, 0.0, 0.0)),
        ("P", _X, (0.2, 0.0, 0.0)),
    ],
    "two joints on one line": [
        ("R", _Y, (0.0, 0.1, 0.0)),
        ("R", _Y, (0.3, 0.1, 0.0)),
        ("R", _Z, (0.2, 0.0, 0.0)),
    ],
}


def family(name: str, seed: int, *, tilt: float = 0.0) -> SerialArm:
    """An arm of `FAMILIES`, each link a body without symmetry.

    tilt : of the base about (1, 1, 0) [rad]
    """
    rng = np.random.default_rng(seed)
    joints, links = [], []
    for i, (kind, axis, step) in enumerate(FAMILIES[name], 1):
        joints.append(
            Joint(f"joint_{i}", np.array(axis), "revolute" if kind == "R" else "prismatic")
        )
        root = rng.normal(size=(3, 3)) * 0.1
        second_moment = root @ root.T
        tensor = np.trace(second_moment) * np.eye(3) - second_moment
        body = Inertia(rng.uniform(0.5, 5.0), rng.normal(size=3) * 0.1, tensor)
        links.append(Link(f"link_{i}", Transform.translation(step), body))
    base = Transform.rotation(np.array([1.0, 1.0, 0.0]) / np.sqrt(2.0), tilt)
    return SerialArm(name, tuple(joints), tuple(links), base)


def in_other_coordinates(
    arm: SerialArm, T_ab: Transform, signs: Sequence[float], offsets: Sequence[float] | Array
) -> SerialArm:
    """The same arm, its base frame at T_ab and its joints counted otherwise: q' = s ∘ q + o."""
    joints, links = [], []
    for joint, link, sign, offset in zip(arm.joints, arm.links, signs, offsets, strict=True):
        turned = Joint(joint.name, joint.axis * sign, joint.kind, joint.limits)
        joints.append(turned)
        links.append(replace(link, link_tip_frame=turned.motion(-offset) @ link.link_tip_frame))
    back = T_ab.inverse()
    return SerialArm(
        "other", tuple(joints), tuple(links), back @ arm.base, back.R @ np.asarray(arm.gravity)
    )


def with_tool(arm: SerialArm, tool: Transform) -> SerialArm:
    """The same arm with another tool frame; its bodies stay where they are."""
    last = arm.links[-1]
    moved = replace(
        last,
        link_tip_frame=last.link_tip_frame @ tool,
        inertia=last.inertia.expressed_in(tool.inverse()),
    )
    return replace(arm, links=(*arm.links[:-1], moved))


def heavier(arm: SerialArm, link: int, factor: float) -> SerialArm:
    """The arm with the mass of one link, from 0, multiplied."""
    bodies = [each.inertia for each in arm.links]
    bodies[link] = replace(bodies[link], mass=factor * bodies[link].mass)
    return arm.with_inertias(bodies)
