"""Denavit–Hartenberg rows to a `SerialArm`.

Standard convention, eq. (1) of the paper:  A_i = Rot_z(θ_i) Trans_z(d_i) Trans_x(a_i) Rot_x(α_i).
Modified (Craig's) convention:  A_i = Rot_x(α_{i−1}) Trans_x(a_{i−1}) Rot_z(θ_i) Trans_z(d_i).
A constant `base` precedes the first row and a constant `tool` follows the last: without them, a
table can only begin on the first joint axis and end on a common normal.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from .._errors import ModelError
from .inertia import Inertia
from .serial_arm import STANDARD_GRAVITY, Joint, Limits, Link, SerialArm, Source
from .transforms import Array, Transform

__all__ = ["DHRow", "arm_from_dh"]

_X, _Z = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


@dataclass(frozen=True, eq=False)
class DHRow:
    """One row of a DH table with the link it moves.

    d, a : [m];  alpha, offset : [rad].  The joint variable is θ = q + offset (revolute), or
    d = q + `d` with θ = offset (prismatic).
    r : link vector, origin of frame i−1 to origin of frame i, in frame i, shape (3,) [m]; where it
        is given it replaces d and a (standard convention only), for listings that state it
        independently of them
    inertia : in the DH frame i;  tensor_known : see `Link`
    armature, damping, friction : see `Joint`
    """

    link: str
    d: float
    a: float
    alpha: float
    inertia: Inertia
    joint: str
    offset: float = 0.0
    kind: Literal["revolute", "prismatic"] = "revolute"
    limits: Limits = field(default_factory=Limits)
    r: Array | None = field(default=None)
    armature: float = 0.0
    damping: float = 0.0
    friction: float = 0.0
    tensor_known: bool = True

    def standard_link_tip_frame(self) -> Transform:
        """P_i of the standard convention."""
        rotation = Transform.rotation(_X, self.alpha)
        if self.r is None:
            rest = Transform.translation((self.a, 0.0, self.d)) @ rotation
        else:
            rest = Transform(rotation.R, rotation.R @ self.r)
        return Transform.rotation(_Z, self.offset) @ rest


def arm_from_dh(
    name: str,
    rows: Sequence[DHRow],
    *,
    convention: Literal["standard", "modified"] = "standard",
    gravity: Sequence[float] = STANDARD_GRAVITY,
    base: Transform | None = None,
    tool: Transform | None = None,
    source: Source | None = None,
) -> SerialArm:
    """The arm that a DH table describes.

    base : pose of the table's frame 0 in the base frame;  tool : of the tip in the table's frame n

    Raises ModelError if a row has `r` under the modified convention, whose frame i lies at the
    joint of link i, so that r would not be the link vector.
    """
    before = Transform.identity()
    link_tip_frames = [row.standard_link_tip_frame() for row in rows]
    if convention == "modified":
        if any(row.r is not None for row in rows):
            raise ModelError(
                "r is defined in the frames of the standard convention only",
                fix="leave r out, or use the standard convention",
            )
        befores = [
            Transform.rotation(_X, row.alpha) @ Transform.translation((row.a, 0.0, 0.0))
            for row in rows
        ]
        # A row of the table ends with Trans_z(d_i); P_i also contains what precedes joint i+1.
        afters = [
            Transform.rotation(_Z, row.offset) @ Transform.translation((0.0, 0.0, row.d))
            for row in rows
        ]
        before = befores[0]
        link_tip_frames = [
            after @ before
            for after, before in zip(afters, [*befores[1:], Transform.identity()], strict=True)
        ]
    links = []
    for i, (row, link_tip_frame) in enumerate(zip(rows, link_tip_frames, strict=True)):
        inertia, source_frame = row.inertia, Transform.identity()
        if convention == "modified" and i + 1 < len(rows):
            source_frame = befores[i + 1].inverse()
            inertia = inertia.expressed_in(source_frame)
        if tool is not None and i + 1 == len(rows):
            link_tip_frame, source_frame = link_tip_frame @ tool, tool.inverse()
            inertia = inertia.expressed_in(source_frame)
        links.append(
            Link(row.link, link_tip_frame, inertia, source_frame, tensor_known=row.tensor_known)
        )
    joints = [
        Joint(
            row.joint, np.array(_Z), row.kind, row.limits, row.armature, row.damping, row.friction
        )
        for row in rows
    ]
    return SerialArm(
        name,
        tuple(joints),
        tuple(links),
        base=before if base is None else base @ before,
        gravity=np.asarray(gravity, dtype=np.float64),
        source=source or Source(),
    )
